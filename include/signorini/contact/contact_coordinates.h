// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_contact_coordinates_h
#define signorini_contact_contact_coordinates_h

#include <signorini/base/contact_status.h>
#include <signorini/contact/contact_surface.h>
#include <signorini/contact/node_frames.h>

#include <optional>

namespace signorini
{
  /**
   * The transformation u = T w between Cartesian components u and contact coordinates w, in which a
   * contact node p has its displacements along the directions e_{p,k} of its frame: normal and
   * tangents. Where two bodies meet, the normal one is *relative to the other side*, and so are the
   * tangential ones that friction acts on (ContactNode::relative),
   *
   *   w_{p,k} = e_{p,k}.(u_p - sum_l P_pl u_l),
   *
   * so that contact is a bound on a single entry, and the slip of a node a few entries (Krause and
   * Walloth 2012, section 2; there the tangential entries are always relative, which is the same
   * problem without friction). T touches contact nodes and their partners only. At rigid obstacles
   * P is absent and T orthogonal; with two bodies, and where several obstacles bound a node (its
   * frame is then oblique: their normals are rows), displacements and forces transform differently:
   *
   *   u = T w,    K in contact coordinates is T'K T,    forces f in contact coordinates are T'f.
   *
   * All transformations are in place, and collective if there are two bodies in contact.
   */
  template <int dim>
  class ContactCoordinates
  {
  public:
    ContactCoordinates(const Discretization<dim>      &discretization,
                       const ContactSurface<dim>      &surface,
                       const DirichletConditions<dim> &dirichlet);

    /** u = T w. */
    void displacement_to_cartesian(Vector &vector) const;

    /** w = T^-1 u. */
    void displacement_to_contact(Vector &vector) const;

    /** T'f. */
    void force_to_contact(Vector &vector) const;

    /** The inverse of the last one. */
    void force_to_cartesian(Vector &vector) const;

    /**
     * The components of displacements or forces of contact nodes in their frames, without regard to
     * the other side. They are the same for both unless several obstacles bound a node.
     */
    void rotate_to_frames(Vector &displacement) const;
    void rotate_from_frames(Vector &displacement) const;
    void force_to_frames(Vector &force) const;
    void force_from_frames(Vector &force) const;

    /**
     * The frames of the contact nodes may have turned: take them over. Collective. Which entries
     * are prescribed or tangential does not change with them, but for entries that another obstacle
     * begins or ceases to bound.
     */
    void follow_frames();

    /** How often frames have turned. */
    unsigned int n_turns() const { return turns; }

    /** What moves the other side of the contact nodes. */
    const NodeCoupling<dim> &coupling() const { return node_coupling; }

    /** The normal entry of each contact node, in the order of the surface. */
    const std::vector<unsigned int> &normal_entries() const { return normals; }

    /** All entries that are relative to another body. */
    const std::vector<unsigned int> &relative_entries() const
    {
      return node_coupling.relative_entries();
    }

    /**
     * The tangential entries of each contact node on which friction acts, in the order of the
     * surface: none without friction, and none that is prescribed.
     */
    const std::vector<std::vector<unsigned int>> &tangential_entries() const { return tangential; }

    /** The owned contact nodes. */
    std::vector<unsigned int> contact_nodes() const;

    /** Prescribed entries, in contact coordinates. */
    const std::vector<unsigned int> &dirichlet_entries() const { return prescribed; }

    /** By owned entry: 1 for Cartesian components that are prescribed. */
    std::vector<char> prescribed_components() const;

    /** The owned nodes of which all entries are prescribed. */
    std::vector<unsigned int> clamped_nodes() const;

    /** The owned nodes of the contact surface, with what is known about them. */
    const std::vector<ContactNode<dim>> &surface_nodes() const { return owned_contact_nodes; }

    /**
     * The prescribed entries, then those that contact holds: the normal ones of closed nodes and
     * the tangential ones of sticking nodes.
     */
    std::vector<unsigned int> held_entries(const ActiveSet &statuses) const;

    /**
     * What holds closed nodes in the normal direction. @param residual b - K x of a solved problem
     * @return the same forces turned round, in contact coordinates
     */
    Vector normal_reaction(const ActiveSet &statuses, const Vector &residual) const;

    /**
     * Displacements prescribed at a time, in the order of dirichlet_entries(). Collective.
     * @throws RunError naming condition and time, if one is not a finite number
     */
    std::vector<double> dirichlet_values(double time) const;

    /** Frames of the owned contact nodes and prescribed nodes. */
    const std::map<unsigned int, typename NodeFrames<dim>::Frame> &node_frames() const
    {
      return frames;
    }

  private:
    using Frame = typename NodeFrames<dim>::Frame;

    const DirichletConditions<dim>        &dirichlet;
    const std::vector<ContactNode<dim>>   &owned_contact_nodes;
    const NodeCoupling<dim>               &node_coupling;
    const unsigned int                     n_owned_entries;
    std::map<unsigned int, Frame>          frames;
    std::vector<unsigned int>              normals, prescribed;
    std::vector<std::vector<unsigned int>> tangential;
    unsigned int                           turns = 0;

    /** A node whose frame is not that of the axes. */
    struct TurnedNode
    {
      std::size_t  contact_node; ///< the first of the node
      unsigned int first_entry;
      Frame        frame, dual; ///< dual: for the components of forces
    };
    /** Nodes that nothing bounds have the frame of the axes: they cost nothing. */
    std::vector<TurnedNode> turned_nodes;

    void find_turned_nodes();

    /** Where the value of a prescribed entry comes from. */
    struct DirichletSource
    {
      unsigned int       condition;
      dealii::Point<dim> point;
      unsigned int       component;
      double             direction; ///< 1 or -1: the entry is that along or against the axis
    };
    std::vector<DirichletSource> dirichlet_sources;

    void find_tangential_entries();
    /** Call turn(turned node, its dim entries) for each of them. */
    template <typename Turn>
    void for_each_node(Vector &vector, const Turn &turn) const;
    /** The relative entries times a factor; zero for nodes of other levels than a given one. */
    std::vector<double> relative_forces(const Vector               &vector,
                                        double                      factor,
                                        std::optional<unsigned int> level = {}) const;
  };
} // namespace signorini

#endif
