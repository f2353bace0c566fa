// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_shared_condition_h
#define signorini_contact_shared_condition_h

#include <signorini/contact/pair_condition.h>

#include <vector>

namespace signorini
{
  /**
   * The one condition of a node that faces several bodies side by side, as a block does that
   * bridges the seam of two others: the mean of their gaps and partners over the parts of the
   * surface around the node that face each. A mortar does not care where one master ends and the
   * next begins; a row for each would be the same row twice, and one of them alone would leave the
   * other body without its share.
   *
   * What is farther away than the closest body counts less and less, and no more from a twentieth
   * of the node's size on; likewise what faces the node from another direction, up to 0.1 radian.
   */
  template <int dim>
  class SharedCondition
  {
  public:
    struct Part
    {
      unsigned int              pair;
      const PairCondition<dim> *condition; ///< must outlive the object
    };

    /** @param turns whether the normal may be a mean, too: not at nodes with prescribed entries */
    SharedCondition(std::vector<Part> facing, bool turns);

    /** Whether more than one body counts. */
    bool is_shared() const { return parts.size() > 1; }

    /** Whether a pair is a part of it, and whether it is the largest one, which stands for all. */
    bool has(unsigned int pair) const;
    bool is_of(const unsigned int pair) const { return parts.front().pair == pair; }

    /** Motion and gap at the end are those of the parts by now. */
    void take_end_over();

    /** To be bounded by who owns the parts. */
    PairCondition<dim> condition;

  private:
    struct Weighed : Part
    {
      double weight;
    };
    std::vector<Weighed> parts; ///< the largest first

    void merge_geometry(bool turns);
  };
} // namespace signorini

#endif
