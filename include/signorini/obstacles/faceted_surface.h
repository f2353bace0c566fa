// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_obstacles_faceted_surface_h
#define signorini_obstacles_faceted_surface_h

#include <signorini/mesh_files/facet_mesh.h>

#include <deal.II/base/tensor.h>

#include <limits>

namespace signorini
{
  /**
   * A surface of triangles (2d: a line of segments) that is the boundary of something: every edge
   * (2d: vertex) has at most two facets, which agree about where the outside is. Facets are grouped
   * into *sides*, which meet at creases and are smooth, or nearly so, in themselves.
   */
  template <int dim>
  class FacetedSurface
  {
  public:
    static constexpr unsigned int none = std::numeric_limits<unsigned int>::max();

    /** A facet. Its ridge i is the edge (2d: vertex) opposite to its vertex i. */
    struct Facet
    {
      std::array<unsigned int, dim> vertices;
      std::array<unsigned int, dim> neighbours; ///< across the ridges; none: the rim
      dealii::Tensor<1, dim>        normal;     ///< unit vector outwards, the same in a plane
      dealii::Point<dim>            origin;     ///< of its plane
      unsigned int                  side;

      /** Height of a point above the plane. */
      double height(const dealii::Point<dim> &p) const { return (p - origin) * normal; }
    };

    /**
     * @param mesh of any orientation; vertices that are nearer than 1e-6 of the size are one
     * @param open whether it may end. A surface without end has its inside inside; the orientation
     * of one with an end is that of the mesh, or of most of its facets.
     * @throws UserError saying what is wrong with the mesh, and where
     */
    FacetedSurface(FacetMesh<dim> mesh, bool open);

    /** The outside becomes the inside. */
    void turn_inside_out();

    const std::vector<dealii::Point<dim>> &vertices() const { return points; }
    const std::vector<Facet>              &facets() const { return all; }
    unsigned int                           n_sides() const { return n_groups; }
    double                                 size() const { return diameter; }
    bool                                   has_rim() const { return n_rim_ridges > 0; }

    std::array<dealii::Point<dim>, dim> corners(unsigned int facet) const;

    /** The angle of a facet at a point that is one of its corners (radians, in 2d 1); 1 elsewhere.
     */
    double angle_at(unsigned int facet, const dealii::Point<dim> &point) const;

    /** Facets at a vertex. */
    const std::vector<unsigned int> &facets_at(const unsigned int vertex) const
    {
      return at_vertex[vertex];
    }

    /** Whether the outside is narrow at a ridge between two sides: an inner corner. */
    bool is_inner_corner(unsigned int facet, unsigned int ridge) const;

    /** What round-off makes of a length here. */
    double round_off() const { return 16. * std::numeric_limits<double>::epsilon() * largest; }

  private:
    std::vector<dealii::Point<dim>>        points;
    std::vector<Facet>                     all;
    std::vector<std::vector<unsigned int>> at_vertex;
    double                                 diameter = 0., largest = 0.;
    unsigned int                           n_groups = 0, n_rim_ridges = 0;

    /** The size of the facets, and their largest coordinate. */
    void measure(const std::vector<typename FacetMesh<dim>::Facet> &facets);
    void use_vertices(FacetMesh<dim> &mesh);
    void connect(bool open);
    void orient();
    void orient_by_volume();
    void flip(unsigned int facet);
    void find_planes();
    void find_sides();
    /** Whether two neighbours make a crease. */
    bool is_crease(unsigned int facet, unsigned int neighbour) const;
    /** Middle of a ridge, for messages. */
    std::string place(unsigned int facet, unsigned int ridge) const;
    /** Whether two facets agree about the outside. */
    bool agree(unsigned int facet, unsigned int ridge) const;
  };
} // namespace signorini

#endif
