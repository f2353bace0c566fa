// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_schemes_fixed_point_h
#define signorini_schemes_fixed_point_h

#include <signorini/base/types.h>

#include <exception>
#include <functional>
#include <limits>

namespace signorini
{
  /**
   * Fixed points y = f(y) by the iteration of KINSOL (SUNDIALS) with Anderson acceleration,
   * watched: the image that differs least from its origin is kept, and the iteration ends when the
   * difference is as small as wanted or has been computed often enough. Where acceleration leads
   * astray, to what is no number or to a difference far beyond what it was, it starts anew from the
   * best image, as long as that gains something. Collective.
   */
  class FixedPoint
  {
  public:
    /** How many differences Anderson's acceleration combines. */
    static constexpr unsigned int usual_depth = 8;

    /** image = f(current). @return their difference, the same number on all processes */
    using Function = std::function<double(const Vector &current, Vector &image)>;

    struct Limits
    {
      double       aim;         ///< a difference that ends the iteration
      double       good_enough; ///< a difference to be content with where round-off is in the way
      unsigned int maximum_iterations; ///< of one run
    };

    /** @param start where to start; see make_unknowns() */
    FixedPoint(const Function &function, const Vector &start, const Limits &limits)
      : function(function)
      , limits(limits)
      , best_image(start)
    {
    }

    /**
     * A vector with at least n entries on each process, all zero. One entry is there in any case,
     * because KINSOL's operations on vectors want one on each process; an idle one has to stay
     * zero.
     */
    static Vector make_unknowns(std::size_t n_owned, MPI_Comm communicator);

    /**
     * Go on from the best image so far. Exceptions of the function arrive here.
     * @param anderson_depth number of differences that are combined; 0: the plain iteration
     */
    void run(unsigned int anderson_depth);

    bool          converged() const { return smallest_difference <= limits.good_enough; }
    const Vector &best() const { return best_image; }
    unsigned int  n_iterations() const { return iterations; }

  private:
    const Function     function;
    const Limits       limits;
    Vector             best_image;
    double             smallest_difference = std::numeric_limits<double>::max();
    unsigned int       iterations          = 0;
    std::exception_ptr exception;

    /** One solve of KINSOL. @param end the number of iterations after which it ends at the latest
     */
    void run_until_astray(unsigned int anderson_depth, unsigned int end);

    /** @return whether to go on */
    bool evaluate(const Vector &current, Vector &image);
  };
} // namespace signorini

#endif
