// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_obstacle_contact_h
#define signorini_contact_obstacle_contact_h

#include <signorini/base/complaints.h>
#include <signorini/contact/contact_node.h>
#include <signorini/discretization/dirichlet_conditions.h>
#include <signorini/obstacles/moved_obstacle.h>

#include <map>
#include <optional>

namespace signorini
{
  /**
   * Contact with rigid obstacles. A node belongs to the closest obstacle among the pairs of its
   * body, one that carries it first, and only if its surface faces that obstacle. A node with
   * prescribed directions meets it in the others; one whose normal displacement is prescribed is
   * left out. Where contact follows the motion every node of the surface may touch sooner or later:
   * what it faces is looked up in every step (FollowedContact), and only nodes that are prescribed
   * in all directions are left out.
   */
  template <int dim>
  class ObstacleContact
  {
  public:
    /**
     * The pairs of two bodies among @p pairs are left out.
     * @throws UserError naming body, place and obstacle, where a prescribed displacement that is
     * oblique to the obstacle changes in time
     */
    ObstacleContact(const Discretization<dim>             &discretization,
                    const DirichletConditions<dim>        &dirichlet,
                    const std::vector<NamedObstacle<dim>> &obstacles,
                    const std::vector<PairDescription>    &pairs,
                    ContactMotion                          motion = ContactMotion::linearised);

    /**
     * The owned nodes that may touch an obstacle, ascending; where contact follows the motion, one
     * more in turn for each further obstacle that a node may meet at the same time.
     */
    const std::vector<ContactNode<dim>> &nodes() const { return contact_nodes; }

    /** Number of nodes (all processes) whose normal displacement is prescribed: no contact. */
    unsigned int n_left_to_dirichlet_conditions() const { return n_left_to_dirichlet; }

    /** Number of nodes (all processes) at which a part of the normal is prescribed. */
    unsigned int n_oblique_nodes() const { return n_oblique; }

    /**
     * The displaced node and its obstacle, if that has an end: past it the node is not carried.
     * Nothing for other nodes, and where contact follows the motion: then the bound says it.
     */
    std::optional<ObstacleProjection<dim>> at_an_end(const ContactNode<dim> &node,
                                                     const Vector           &displacement) const;

    /** What a node may be past an end before it is free: round-off. */
    double end_tolerance() const;

    /** A node of the contact boundaries of its body. */
    struct SurfaceNode
    {
      unsigned int body;
      /** Pairs with obstacles to which the node belongs, and its area (length in 2d) in each. */
      std::vector<std::pair<unsigned int, double>> areas;
    };

    /** All owned nodes of the surfaces of pairs with obstacles. */
    const std::map<unsigned int, SurfaceNode> &surface() const { return surface_nodes; }

    /** The obstacle of a pair, where it is now. */
    const MovedObstacle<dim> &obstacle(const unsigned int pair) const
    {
      return moved[pairs[pair].obstacle];
    }

    /** Obstacles move from where they are at one time to where they are at another. */
    void move_obstacles(double start, double end);

    /** Where a node is. */
    dealii::Point<dim> displaced(unsigned int node, const Vector &displacement) const;

    /** Whether the first way is the better one: obstacles that carry come first, then near ones. */
    bool is_closer(const ObstacleProjection<dim> &first,
                   const ObstacleProjection<dim> &second) const;

    /**
     * For each body the largest depth of a displaced node of its contact boundaries in *any*
     * obstacle of the body, whether the node has faced it at the start or not; 0 if there is none.
     * The same on all processes. Collective.
     */
    std::vector<double> geometric_penetration(const Vector &displacement) const;

    /**
     * @throws UserError naming pair, depth and place, if a slave surface penetrates its obstacle
     * at the start
     */
    void check_initial_gap(const Vector &initial_displacement) const;

  private:
    const Discretization<dim>            &discretization;
    const std::vector<PairDescription>    pairs;
    const std::vector<NamedObstacle<dim>> obstacles;
    std::vector<MovedObstacle<dim>>       moved; ///< the obstacles
    const ContactMotion                   motion;
    std::vector<ContactNode<dim>>         contact_nodes;
    std::map<unsigned int, SurfaceNode>   surface_nodes;
    unsigned int                          n_left_to_dirichlet = 0, n_oblique = 0;

    void check_that_they_rest(const DirichletConditions<dim>                      &dirichlet,
                              const typename DirichletConditions<dim>::Components &conditions,
                              const ContactNode<dim>                              &contact_node,
                              std::vector<Complaint> &complaints) const;
    /** Which prescribed directions a plane obstacle is oblique to, for a node that may meet it. */
    std::array<bool, dim>
    is_oblique_to(unsigned int                                         pair,
                  ContactNode<dim>                                     node,
                  const typename DirichletConditions<dim>::Components &conditions) const;

    /** Enter a node, and the rows of further obstacles. */
    void add_with_rows(ContactNode<dim> contact_node);

    /**
     * Of a node that cannot move towards its obstacle: whether contact that follows the motion may
     * hold it one day. Then it has no bound, and a frame for its free directions.
     */
    bool wait_for_other_normals(const typename DirichletConditions<dim>::Components &conditions,
                                ContactNode<dim> &contact_node) const;

    /** At the start; where contact follows the motion, far if the obstacle has no value there. */
    ObstacleProjection<dim> projection_at_start(unsigned int              pair,
                                                const dealii::Point<dim> &position) const;
    /** Enter the nodes of a pair that have no closer obstacle yet. */
    void add_closest(unsigned int pair, std::map<unsigned int, ContactNode<dim>> &closest);
    /**
     * Area and averaged outward normal (times area) per node for one pair; `normal` has dim,
     * `area` one entry per node.
     */
    void integrate(const PairDescription &pair, Vector &area, Vector &normal) const;
  };
} // namespace signorini

#endif
