// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_linear_algebra_separate_parts_h
#define signorini_linear_algebra_separate_parts_h

#include <signorini/linear_algebra/node_pattern.h>

namespace signorini
{
  /** Parts of a matrix that nothing couples: bodies that meet no other one. */
  struct SeparateParts
  {
    /** More parts than this count as one. */
    static constexpr unsigned int most = 32;

    unsigned int              n = 1;
    std::vector<unsigned int> part_of; ///< per owned node; 0 for one that is coupled with none.
                                       ///< Of a single part it may be empty

    /** Collective. */
    template <int dim>
    static SeparateParts of(const NodePattern &pattern);

    /** x'y of each part, of vectors with some entries per node. Collective. */
    std::vector<double> products(const Vector &x, const Vector &y) const;
    /** target += factors x, with a factor for each part. */
    void add(Vector &target, const std::vector<double> &factors, const Vector &x) const;

  private:
    unsigned int part_of_entry(const unsigned int entry, const Vector &x) const
    {
      return part_of[entry / (x.locally_owned_size() / part_of.size())];
    }
  };
} // namespace signorini

#endif
