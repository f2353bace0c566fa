// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_facing_pair_h
#define signorini_contact_facing_pair_h

#include <signorini/contact/contact_node.h>
#include <signorini/discretization/dirichlet_conditions.h>
#include <signorini/surfaces/covered_surface.h>

#include <map>

namespace signorini
{
  /**
   * The surfaces of a pair of two bodies, in any configuration: what faces the nodes of the slave
   * there. The coupling is that of MortarCoupling, with three differences that motion asks for.
   * Points of faces that turn away from each other count less and less, instead of no more from
   * some angle on. Normals are those of the side that is flatter at the node. And the rows of P are
   * shifted along the surface by so little that the relative position of a node is along its
   * normal,
   *
   * @f[
   *   P_{il} \leftarrow P_{il} + |P_{il}|\, a \cdot (x_l - \bar x), \qquad [x]_i \parallel \nu_i,
   * @f]
   *
   * so that forces of contact have no moment. Weights still add up to one.
   *
   * A body may be a pair with itself. Then faces that share no node may meet; of two that do, that
   * is the slave which in the reference configuration lies farther along the axis on which they are
   * farthest apart. Behind itself a face looks no farther than a part of the body's thickness
   * there.
   */
  template <int dim>
  class FacingPair
  {
  public:
    /** All must outlive the object. Collective. @param pair index of a pair of two bodies */
    FacingPair(const Discretization<dim>          &discretization,
               const DirichletConditions<dim>     &dirichlet,
               const std::vector<PairDescription> &pairs,
               unsigned int                        pair);

    /** The owned nodes of the slave surface, and the area (length in 2d) of each. */
    const std::map<unsigned int, double> &slave_nodes() const { return areas; }

    /**
     * How thick the slave is behind its nodes: the reciprocal, in the first entry of each node; 0
     * where its surface shows no other side. Collective.
     */
    Vector reciprocal_thickness() const;

    /** The owned nodes of the master surface, ascending. */
    const std::vector<unsigned int> &master_nodes() const { return owned_master_nodes; }

    /**
     * The largest motion of a point of one surface relative to the other one as a whole.
     * Collective.
     */
    double relative_motion(const Vector &increment) const;

    /** Between boxes around both surfaces: they are at least as far apart. Collective. */
    double distance_of_boxes(const Vector &displacement) const;

    /**
     * The owned nodes that face the master, with gap, normal, partners; the gap is minus the normal
     * part of the relative position. Collective.
     * @param reach    length: what is farther away, or deeper inside, counts no more; half a face
     *                 is added
     * @param excluded per owned node, those that carry no multiplier; null: none
     */
    std::vector<ContactNode<dim>>
    at(const Vector &displacement, double reach, const std::vector<bool> *excluded = nullptr) const;

    /**
     * How deep a corner of a face of either body is in the other one, at most; length, 0 if none
     * is. @param nodes of at()
     */
    static double depth(const std::vector<ContactNode<dim>> &nodes);

  private:
    const Discretization<dim>          &discretization;
    const DirichletConditions<dim>     &dirichlet;
    const std::vector<PairDescription> &pairs;
    const unsigned int                  pair;
    std::vector<SurfaceFace<dim>>       slaves, masters; ///< owned, in the reference configuration
    std::map<unsigned int, double>      areas;
    std::vector<unsigned int>           owned_slave_nodes, owned_master_nodes;
    std::vector<double>                 bluntness; ///< of the slave surface, per owned node
    Vector       is_slave;            ///< 1 in the first entries of the nodes of the slave surface
    double       largest_face   = 0.; ///< diameter in the reference configuration
    unsigned int n_master_nodes = 0;  ///< on all processes

    /** Area and bluntness of the slave's nodes. Collective. */
    void measure_slave();
    /** How thick the slave is behind each of its faces, as far as others show it. Collective. */
    std::vector<double> thickness_behind_faces(const std::vector<SurfaceFace<dim>> &others) const;
    bool                is_of_one_body() const { return pairs[pair].slave == pairs[pair].master; }
    /** The coupling of faces that face each other. Collective. */
    std::vector<ContactNode<dim>> couple(const CoveredSurface<dim> &surface,
                                         const std::vector<bool>   *excluded) const;
    /** Around the nodes of slave and master, those of all processes. Collective. */
    std::vector<dealii::BoundingBox<dim>> boxes(const Vector &displacement) const;
    /** Faces in a configuration, as far as they are in a box. */
    std::vector<SurfaceFace<dim>> displaced(const std::vector<SurfaceFace<dim>> &faces,
                                            const Vector                        &displacement,
                                            const dealii::BoundingBox<dim>      &box) const;
    /** Shift the rows of P. Collective. */
    void align(std::vector<ContactNode<dim>> &nodes, const Vector &displacement) const;
  };
} // namespace signorini

#endif
