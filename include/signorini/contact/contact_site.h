// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_contact_site_h
#define signorini_contact_contact_site_h

#include <signorini/base/user_error.h>
#include <signorini/contact/followed_pairs.h>
#include <signorini/contact/obstacle_contact.h>

#include <limits>

namespace signorini
{
  /** An obstacle or a body as a node sees it in a step. */
  template <int dim>
  struct Facing
  {
    unsigned int pair;
    bool         of_body;  ///< or of an obstacle
    double       area;     ///< of the node in this pair
    FrictionLaw  friction; ///< of the node in this pair, with all of its area
    double       gap = std::numeric_limits<double>::infinity(); ///< at the start of the step
    MotionCondition<dim>          condition       = {};
    dealii::Tensor<1, dim>        normal_at_start = {}; ///< unit normal of an obstacle there
    const PairCondition<dim>     *opposite = nullptr; ///< of a body: null if it is not opposite now
    static constexpr unsigned int whole = -1, absent = -2;
    unsigned int side = whole; ///< of an obstacle; `whole`, or `absent` for no side at all

    /** Whether there is any condition at all. */
    bool is_there() const { return of_body ? opposite != nullptr : side != absent; }

    /** Take the condition of a body over. */
    void set_opposite(const PairCondition<dim> *new_opposite);
  };

  /** A node of a contact surface, with all that may bound it in a step. */
  template <int dim>
  struct ContactSite
  {
    std::size_t               first;             ///< of its contact nodes
    unsigned int              n_rows       = 1;  ///< their number
    dealii::Point<dim>        start        = {}; ///< position at the start of the step
    dealii::Tensor<1, dim>    displacement = {}; ///< there
    std::vector<Facing<dim>>  facings      = {}; ///< one for each of its pairs
    std::vector<unsigned int> bounding     = {}; ///< the facings that bound it, one per row

    bool is_bounded_by(unsigned int facing) const;

    /**
     * Let another facing bound the node, too.
     * @return false: no row is left, or its normal is too close to those that are there
     */
    bool add_row(unsigned int facing);

    /** What is not opposite any more bounds no more; the first facing is left if none is. */
    void drop_what_is_gone();

    /** The facings in the order of rows: those that bound the node, then the others. */
    std::vector<unsigned int> order() const;

    /**
     * The node of a row as the conditions are now.
     * @param node       what it was
     * @param conditions prescribed components of the node; null: none
     */
    ContactNode<dim>
    contact_node(unsigned int                                         row,
                 ContactNode<dim>                                     node,
                 const typename DirichletConditions<dim>::Components *conditions) const;
  };

  /**
   * Call an action for each site. Where an obstacle has no distance, all processes throw
   * together. Collective.
   */
  template <typename Sites, typename Action>
  void for_each_site(Sites &sites, MPI_Comm communicator, const Action &action)
  {
    std::vector<Complaint> complaints;
    try
      {
        for (auto &site : sites)
          action(site);
      }
    catch (const UserError &error)
      {
        complaints.emplace_back(1., error.what());
      }
    throw_worst(complaints, communicator);
  }
} // namespace signorini

#endif
