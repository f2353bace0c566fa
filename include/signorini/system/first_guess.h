// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_system_first_guess_h
#define signorini_system_first_guess_h

#include <signorini/contact/contact_coordinates.h>
#include <signorini/linear_algebra/linear_operator.h>
#include <signorini/time/dynamical_system.h>

namespace signorini
{
  /**
   * What the start of a step says about its solution where no increments are known, on a new mesh
   * or with a new size of steps: the velocity goes on, and contact is where it was. Increments are
   * in contact coordinates.
   */
  template <int dim>
  class FirstGuess
  {
  public:
    /** @param coordinates must outlive the object @param touching length below which nodes touch */
    FirstGuess(const ContactCoordinates<dim> &coordinates, const double touching)
      : coordinates(coordinates)
      , touching(touching)
    {
    }

    /** The part of the velocity that has the least energy, and where contact was in its reach. */
    void from_start(const IncrementProblem &problem,
                    const LinearOperator   &matrix,
                    const Vector           &right_hand_side,
                    Vector                 &increment,
                    ActiveSet              &active) const;

    /** Contact is where it was. */
    void status(const State &start, ActiveSet &active) const;

    /** A node that the increment drives into the obstacle is expected to touch. */
    void expect_contact(const Vector &increment, const NormalGap &bounds, ActiveSet &active) const;

  private:
    const ContactCoordinates<dim> &coordinates;
    const double                   touching;
  };
} // namespace signorini

#endif
