// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_contact_surface_h
#define signorini_contact_contact_surface_h

#include <signorini/contact/node_coupling.h>
#include <signorini/contact/obstacle_contact.h>

#include <cmath>

namespace signorini
{
  template <int dim>
  class FollowedPairs;

  /**
   * The possible contact boundary: nodes of the slave surfaces with gap, weight, contact frame
   * (normal and tangents), and what is opposite: a rigid obstacle or, by a mortar coupling, another
   * body. The linearised condition of non-penetration is [u].nu <= g at each (Krause and Walloth
   * 2012, equations (3) and (12)), with the relative displacement [u]_p = u_p - sum_l P_pl u_l.
   */
  template <int dim>
  class ContactSurface
  {
  public:
    /**
     * @throws UserError if a pair of bodies has no surfaces that face each other, or two pairs
     * share a node
     * @param how_to_follow what the user of this scene has to do so that contact follows the
     * motion: a clause in the imperative, for messages
     */
    ContactSurface(const Discretization<dim>             &discretization,
                   const DirichletConditions<dim>        &dirichlet,
                   const std::vector<NamedObstacle<dim>> &obstacles,
                   const std::vector<PairDescription>    &pairs,
                   ContactMotion                          motion        = ContactMotion::linearised,
                   const std::string                     &how_to_follow = set_motion_to_follow);
    ContactSurface(ContactSurface &&) noexcept;
    ~ContactSurface();

    /** Whether contact is that of the configurations of each step: see FollowedContact. */
    bool follows() const { return motion == ContactMotion::follow; }

    /** Whether nodes may get friction that they do not have, by going from one pair to another. */
    bool friction_may_come() const { return follows() && has_friction(descriptions); }

    /** What was asked to be in contact; ContactNode::pair is an index into this. */
    const std::vector<PairDescription> &pairs() const { return descriptions; }

    /** Nodes that this process owns. */
    const std::vector<ContactNode<dim>> &nodes() const { return contact_nodes; }

    /** Contact with obstacles, as far as it does not change in time. */
    const ObstacleContact<dim> &at_obstacles() const { return obstacle_contact; }

    /** See ObstacleContact::move_obstacles(). */
    void move_obstacles(const double start, const double end)
    {
      obstacle_contact.move_obstacles(start, end);
    }

    /** The geometry of a contact node from now on; see FollowedContact. */
    void set_geometry(const std::size_t k, ContactNode<dim> node)
    {
      contact_nodes[k] = std::move(node);
    }

    /** All contact nodes have their geometry. Collective. */
    void complete_geometry();

    /** Pairs of bodies, where contact follows the motion. */
    FollowedPairs<dim> &followed_pairs() { return *bodies; }

    /**
     * How deep a corner of a face of either body of a pair is in the other one, at most, at the end
     * of the latest step; length. Conditions of contact are means around nodes, this is what they
     * miss. 0 where contact is linearised. Collective.
     */
    double depth(unsigned int pair) const;

    /** What moves the other side of the nodes. */
    const NodeCoupling<dim> &coupling() const { return *node_coupling; }

    /** Number of contact nodes on all processes. */
    unsigned int n_global_nodes() const { return n_global; }

    /** Number of nodes (all processes) whose normal displacement is prescribed: no contact. */
    unsigned int n_left_to_dirichlet_conditions() const { return n_left_to_dirichlet; }

    /** What was assumed about the pairs, for the user: one sentence each. */
    const std::vector<std::string> &notes() const { return assumptions; }

    /** Whether a face of an owned cell is part of the slave surface of any pair. */
    bool contains(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
                  unsigned int                                                  face) const;

    /** [u].nu per node, of displacements or velocities. Collective. */
    std::vector<double> relative_normal(const Vector &motion) const;

    /**
     * The tangential part of [u] per node, in Cartesian components, of displacements or velocities:
     * the slip, where friction acts. Like the bound it is larger than the motion of the body by the
     * factor `transmission`. Collective.
     */
    std::vector<dealii::Tensor<1, dim>> relative_tangential(const Vector &motion) const;

    /**
     * gamma = g - [u].nu, the bound that is left for increments; infinity for nodes past the end of
     * their obstacle. They may come back. Collective.
     */
    std::vector<double> normal_gap(const Vector &displacement) const;

    /**
     * Distance to the other side, to be shown to people; to the end for nodes past it. Where
     * contact follows the motion, the true one. Collective.
     */
    std::vector<double> distance(const Vector &displacement) const;

    /**
     * What a node of a pair of bodies that faces nothing is away from the other body at least,
     * where contact follows the motion; length.
     */
    double clear_distance(unsigned int pair) const;

    /** Whether that is all that is known of a contact node. */
    bool faces_nothing(const std::size_t k) const
    {
      return follows() && descriptions[contact_nodes[k].pair].of_two_bodies()
             && std::isinf(contact_nodes[k].gap);
    }

    /**
     * What is near in a configuration: contact nodes whose gap is the distance to what they face.
     * Between bodies where contact follows the motion they come from a search, otherwise they are
     * those of the steps. Collective.
     * @param reach of the search, length
     */
    std::vector<ContactNode<dim>> near_nodes(const Vector &displacement, double reach) const;

    /** The same at another time than the end of the step, where obstacles move meanwhile. */
    std::vector<ContactNode<dim>>
    near_nodes_at(double time, const Vector &displacement, double reach) const;

    /**
     * For each body the largest depth of a displaced node of its surface in *any* obstacle of the
     * body, by the true geometry; 0 if there is none. The condition of the steps is linearised
     * about the reference configuration, with one obstacle per node; this is what it misses.
     * Collective.
     */
    std::vector<double> geometric_penetration(const Vector &displacement) const
    {
      return obstacle_contact.geometric_penetration(displacement);
    }

    /**
     * For each pair of two bodies the largest tangential displacement of a node relative to the
     * other body while it carries a contact force, in units of the size of its surroundings, on all
     * processes. Above 1 the node presses on faces that are no longer opposite. Collective.
     */
    std::vector<double> largest_sliding(const Vector &displacement,
                                        const Vector &contact_force) const;

    /**
     * Check that nothing overlaps at the start.
     * @throws UserError naming pair, depth and place
     */
    void check_initial_gap(const Vector &initial_displacement) const;

    /**
     * Let penetrating nodes be where they are: their gap becomes zero. A finer mesh sees more of a
     * curved surface than the mesh on which the motion was admissible; to push these nodes out at
     * once would be a blow that nothing but the mesh has dealt.
     */
    void admit(const Vector &displacement);

    /** The gaps of all contact nodes in their entries, with what was admitted. */
    Vector gaps() const;

    /** Gaps as they were on the same mesh. */
    void set_gaps(const Vector &gaps);

  private:
    const Discretization<dim>          &discretization;
    const std::vector<PairDescription>  descriptions;
    const ContactMotion                 motion;
    const std::string                   how_to_follow;
    ObstacleContact<dim>                obstacle_contact;
    std::vector<ContactNode<dim>>       contact_nodes;
    std::unique_ptr<FollowedPairs<dim>> bodies; ///< where contact follows the motion
    std::unique_ptr<NodeCoupling<dim>>  node_coupling;
    unsigned int                        n_global = 0, n_left_to_dirichlet = 0;
    std::vector<std::string>            assumptions;

    double distance_to(const MovedObstacle<dim> &obstacle,
                       const ContactNode<dim>   &node,
                       const Vector             &displacement) const;
    void   add_pair_of_bodies(unsigned int pair, const DirichletConditions<dim> &dirichlet);
    /**
     * Contact that follows the motion: every node of a slave surface may face the other body one
     * day. Nodes that are prescribed in all directions are left out.
     */
    void add_slave_nodes(const DirichletConditions<dim> &dirichlet);
    /** @throws UserError naming pair, depth and place, if the bodies of a pair overlap */
    void check_that_bodies_are_apart(const Vector &displacement) const;
    /**
     * Gaps by round-off become zero, and so do small overlaps of facetted surfaces; deep ones
     * stay, to be reported.
     */
    void settle_gaps(unsigned int pair, std::vector<ContactNode<dim>> &nodes);
    /** Each node belongs to one pair, and is not itself the opposite side of another. */
    void check_that_pairs_are_disjoint() const;
  };
} // namespace signorini

#endif
