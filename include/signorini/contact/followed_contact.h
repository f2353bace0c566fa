// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_followed_contact_h
#define signorini_contact_followed_contact_h

#include <signorini/base/step_normals.h>
#include <signorini/contact/contact_site.h>
#include <signorini/contact/contact_surface.h>

namespace signorini
{
  /**
   * Contact with obstacles in the configurations of a step, instead of the reference one. Every
   * node of a contact surface is bounded by the obstacle that is closest when the step begins, and
   * by those that it touches then or would enter on its way; its bound is the true gap there, and
   * its normal the discrete gradient of the true gap over the motion of the step (MotionCondition).
   * So a motion keeps all linear conditions of its own normals exactly if no node penetrates at the
   * end, and the forces are those of closed gaps.
   *
   * The normals depend on the motion, and the motion on the normals: who leads the step calls
   * follow() until mismatch() is small. At flat obstacles, and far from any, there is nothing to
   * repeat.
   *
   * All functions that look at obstacles are collective. Where an obstacle has no distance or no
   * normal, a node is far from it, but for a node that it holds: then they throw a UserError on all
   * processes.
   */
  template <int dim>
  class FollowedContact
  {
  public:
    /** All must outlive the object, which writes the geometry of the surface. */
    FollowedContact(const Discretization<dim>      &discretization,
                    const DirichletConditions<dim> &dirichlet,
                    ContactSurface<dim>            &surface);

    /**
     * Forces such as these act in the steps to come: what strains bodies little wants gaps that are
     * the more exact. Where none act, nothing is known of them. Collective.
     */
    void expect_forces(const Vector &contact_force);

    /**
     * Look what every node faces at the start of a step.
     * @param expected   increment of the step
     * @param start, end times of the step
     * @param normals    that follow() gives; at_end are exact where the last two motions agree
     * @throws StepError if an obstacle turns too far
     */
    void begin_step(const Vector &displacement,
                    const Vector &expected,
                    double        start,
                    double        end,
                    StepNormals   normals = StepNormals::of_motion);

    /** The conditions of the same step with the normals of this motion. */
    void follow(const Vector &increment);

    /**
     * By how much the gaps at the end of a motion differ from what their conditions say, at the
     * nodes that matter, and at those that penetrate: the largest, in units of what is wanted,
     * 1e-12 of the size of the bodies and the round-off of coordinates; less under light contact,
     * see expect_forces(). Collective.
     * @param matters per contact node
     */
    double mismatch(const Vector &increment, const std::vector<bool> &matters);

    /**
     * Whether a node passes through an obstacle: it begins and ends outside, and is deep inside
     * between, as no sliding along the surface is. Only motions by more than a part of a
     * cell are looked at. Collective.
     */
    bool passes_through(const Vector &increment) const;

    /** The motion of the obstacles at the contact nodes in the step, zero elsewhere. */
    Vector obstacle_motion() const;

    /** See MovingContact::tangential_approach(), per contact node. */
    std::vector<double> tangential_approach(const Vector &free_increment) const;

    /**
     * Normals are those of the end of a motion at the nodes that tangential_approach() is about,
     * until face_motion().
     */
    void face_end(const Vector &increment);
    void face_motion();

    /** Whether tangential_approach() may be about any node, on any process. */
    bool may_turn() const { return some_are_curved; }

    /** Per contact node at the start of the step; infinite where nothing bounds it. */
    std::vector<double> gaps_at_start() const
    {
      std::vector<double> gaps(surface.nodes().size(), std::numeric_limits<double>::infinity());
      for (const Site &site : sites)
        for (unsigned int row = 0; row < site.bounding.size(); ++row)
          gaps[site.first + row] = site.facings[site.bounding[row]].gap;
      return gaps;
    }

    /** Whether any obstacle moves. */
    bool obstacles_move() const { return some_move; }

    /** The owned nodes on whose motion the conditions depend, ascending. */
    std::vector<unsigned int> nodes() const;

    /**
     * By how much the true gap at the end of the latest motion is larger than what its condition
     * says, per contact node: for bodies that meet bodies and have found no motion of their own
     * normals, or whose bound is clipped.
     */
    std::vector<double> missed_gaps() const;

  private:
    using Site = ContactSite<dim>;

    const Discretization<dim>      &discretization;
    const DirichletConditions<dim> &dirichlet;
    ContactSurface<dim>            &surface;
    const ObstacleContact<dim>     &at_obstacles;
    FollowedPairs<dim>             &pairs;
    std::vector<Site>               sites;
    bool                            some_move = false, some_are_curved = false;
    double                          strain   = 0.;              ///< of contact, mean
    double                          accepted = 0., wanted = 0.; ///< lengths
    unsigned int                    n_followed      = 0;        ///< motions of this step
    StepNormals                     normals_of_step = StepNormals::of_motion;

    /** The laws of friction of all facings. Collective. */
    void find_friction();
    /** The motion of a node. */
    dealii::Tensor<1, dim> motion(const Site &site, const Vector &increment) const;
    /** Whether the node was in the obstacle when the step began. */
    bool was_inside(const Facing<dim> &facing) const
    {
      return !facing.of_body && facing.gap < -accepted;
    }
    /** Whether a node faces one curved obstacle at rest, and nothing else. */
    bool turns(const Site &site) const;
    /** Whether a motion is so large that what faces the node may be in its way. */
    bool is_in_reach(const Facing<dim> &facing, const dealii::Tensor<1, dim> &motion) const;
    /** The obstacle that a node faces, or one of its sides. */
    const MovedObstacle<dim> &obstacle(const Facing<dim> &facing) const;
    /**
     * In inner corners of one obstacle let the node face its sides, each with a condition of its
     * own.
     */
    void face_sides(Site &site, const dealii::Tensor<1, dim> &expected_motion) const;
    /** Whether a motion ends in an obstacle, but in none of the sides that the node faces. */
    bool misses_a_side(const Site &site, const dealii::Tensor<1, dim> &motion) const;
    /** Look where the obstacles of a node are when the step begins. */
    void look_around(Site &site) const;
    /** Let the node be bounded by what it would enter, as far as it has rows. */
    void bound_by_what_is_entered(Site &site, const dealii::Tensor<1, dim> &motion) const;
    /** Whether a motion would end in an obstacle that does not bound the node. */
    bool
    enters(const Site &site, const Facing<dim> &facing, const dealii::Tensor<1, dim> &motion) const;
    /** The gap of a facing after a motion, as far as it is in the way. */
    double gap_after(const Site                   &site,
                     const Facing<dim>            &facing,
                     const dealii::Tensor<1, dim> &motion) const;
    /** By how much the condition of a row misses the true gap after a motion. */
    double mismatch_of(const Site                   &site,
                       const Facing<dim>            &facing,
                       const dealii::Tensor<1, dim> &motion,
                       bool                          is_held) const;
    /** Write the conditions of a node to the surface. */
    void write(const Site &site);
    /** Take the conditions of bodies over. */
    void update_opposite(Site &site) const;
  };
} // namespace signorini

#endif
