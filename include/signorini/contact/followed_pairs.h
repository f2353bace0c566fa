// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_followed_pairs_h
#define signorini_contact_followed_pairs_h

#include <signorini/base/step_normals.h>
#include <signorini/contact/facing_pair.h>
#include <signorini/contact/node_coupling.h>
#include <signorini/contact/shared_condition.h>

#include <memory>

namespace signorini
{
  /**
   * Pairs of two bodies in the configurations of a step. Where bodies face each other is found at
   * the middle of the motion, and the bound follows from the true gap at its end: with normals nu
   * and weights P of the motion d_k,
   *
   * @f[
   *   \nu \cdot [d] \le b = \max(0,\; g(x + d_k) + \nu \cdot [d_k]).
   * @f]
   *
   * A motion that repeats itself then ends with g >= 0, and its forces act where g = 0. For any
   * normals, weights and bounds that are not negative the laws of a scheme hold.
   *
   * A node that faces several bodies side by side has one condition of them all (SharedCondition).
   */
  template <int dim>
  class FollowedPairs
  {
  public:
    /** All must outlive the object. Collective. */
    FollowedPairs(const Discretization<dim>          &discretization,
                  const DirichletConditions<dim>     &dirichlet,
                  const std::vector<PairDescription> &pairs);

    /** Whether there is any pair of two bodies. */
    bool any() const { return !geometries.empty(); }

    /** By the index of a pair of two bodies. */
    const std::map<unsigned int, std::unique_ptr<FacingPair<dim>>> &pairs() const
    {
      return geometries;
    }

    /** Owned nodes on whose motion the conditions depend, ascending. */
    std::vector<unsigned int> nodes() const;

    /**
     * The conditions of a motion that is expected from here. With StepNormals::at_end they are
     * those of the geometry at its end, and bounds may be negative: there is no energy to keep.
     * Collective.
     */
    void begin_step(const Vector &displacement,
                    const Vector &expected,
                    StepNormals   normals = StepNormals::of_motion);

    /**
     * The conditions of a motion from the same start. Their true gap at the end is that of the
     * motion that was looked at last, which is the same one in a fixed point. Collective.
     */
    void follow(const Vector &increment);

    /**
     * From now on in this step normals and partners are those of the motion that was expected; only
     * bounds change with the motion. Collective.
     */
    void keep_geometry_of_expected();

    /** See where a motion ends; the conditions stay. Collective. */
    void look_at_end(const Vector &increment);

    /**
     * The condition of a node in a pair; null if nothing is opposite, or if another pair stands for
     * this one, too.
     */
    const PairCondition<dim> *find(unsigned int pair, unsigned int node) const;

    /**
     * How deep a corner of a face of either body of a pair is in the other one, at most, at the end
     * of the motion that was looked at last; length. Collective.
     */
    double depth(unsigned int pair) const;

    /**
     * What nodes of a pair that face nothing are away from the other body at least, at the end of
     * the motion that was looked at last; length.
     */
    double clear_distance(const unsigned int pair) const { return clear.at(pair); }

    /**
     * Whether bodies that are near each other move by so much that they may pass through each other
     * unseen: a quarter of the smaller one. Collective.
     */
    bool move_too_far(const Vector &increment) const;

  private:
    using Conditions = std::map<unsigned int, PairCondition<dim>>; ///< by node

    const Discretization<dim>                               &discretization;
    const DirichletConditions<dim>                          &dirichlet;
    const std::vector<PairDescription>                      &descriptions;
    std::map<unsigned int, std::unique_ptr<FacingPair<dim>>> geometries;
    std::vector<unsigned int>                                order; ///< of pairs
    bool                                                     is_cyclic = false;
    bool                               may_share = false; ///< a body is the slave of several pairs
    std::map<unsigned int, Conditions> conditions;        ///< by pair
    std::map<unsigned int, SharedCondition<dim>>               shared; ///< by node
    std::map<unsigned int, std::unique_ptr<NodeCoupling<dim>>> couplings;
    Vector                                                     start;    ///< displacement
    Vector                                                     expected; ///< motion
    bool                                                       at_end = false, is_kept = false;
    Vector                                                 looked_at; ///< the latest motion, if any
    std::map<unsigned int, std::map<unsigned int, double>> end_gaps;  ///< of it, by pair and node
    std::map<unsigned int, std::map<unsigned int, double>> missed_gaps; ///< of it, likewise
    std::map<unsigned int, double> missed_by_shared;                    ///< gaps of it, by node
    std::map<unsigned int, double> end_depths; ///< of it, by pair, of this process
    std::map<unsigned int, double> clear;      ///< by pair

    /** Masters before slaves, as far as there is no ring of bodies. */
    void find_order();
    /** Set the bound of a condition that knows its motion and gaps. */
    void bound(PairCondition<dim> &condition) const;
    /** Geometry in the middle of a motion, with [u] and [d]; bounds are of no end yet. */
    void search_middle(const Vector &increment);
    /** True gaps at the end of a motion. */
    void search_end(const Vector &increment);
    /** Give the conditions the motion that was looked at, and its gaps. */
    void take_end_over();
    /** Of conditions that have their bounds. */
    void find_shared_nodes();
    /** What the conditions miss; the same of the motion before goes to missed_before. */
    void look_what_is_missed();
    /** [v] of the nodes of a pair, in their order. Collective. */
    std::vector<dealii::Tensor<1, dim>> relative(unsigned int pair, const Vector &v) const;
    double                              reach(unsigned int pair, const Vector &increment) const;
  };
} // namespace signorini

#endif
