// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_surface_face_h
#define signorini_surfaces_surface_face_h

#include <signorini/discretization/discretization.h>
#include <signorini/model/contact_description.h>

#include <deal.II/base/bounding_box.h>

#include <boost/container/small_vector.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/split_member.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <limits>

namespace signorini
{
  /** A linear combination of nodes: global node and weight. */
  using NodeWeights = std::vector<std::pair<dealii::types::global_dof_index, double>>;

  /**
   * The nodes that move a vertex: one of weight 1, or the parents of a hanging vertex. Faces are
   * copied in every search; the one node of most vertices needs no memory of its own.
   */
  using VertexNodes =
    boost::container::small_vector<std::pair<dealii::types::global_dof_index, double>, 1>;

  /**
   * A (bi)linear face of a contact surface with the nodes that move it, detached from the mesh, so
   * that it can travel to another process. Vertices in deal.II's lexicographic order, reference
   * coordinates in [0,1]^(dim-1).
   */
  template <int dim>
  struct SurfaceFace
  {
    static constexpr unsigned int n_vertices = 1u << (dim - 1);

    std::array<dealii::Point<dim>, n_vertices> vertices; ///< in the reference configuration
    std::array<VertexNodes, n_vertices>        nodes;
    double             orientation = 1; ///< +1 or -1, makes area_vector() point out of the body
    dealii::Point<dim> place;           ///< centre in the reference configuration
    double thickness = std::numeric_limits<double>::infinity(); ///< of the body behind it, if known

    /** Values of the (bi)linear shape functions. */
    static std::array<double, n_vertices> shape_values(const dealii::Point<dim - 1> &xi);

    dealii::Point<dim> position(const dealii::Point<dim - 1> &xi) const;

    /** Derivatives of the position by the reference coordinates. */
    std::array<dealii::Tensor<1, dim>, dim - 1> tangents(const dealii::Point<dim - 1> &xi) const;

    /** Outward normal times the surface element. */
    dealii::Tensor<1, dim> area_vector(const dealii::Point<dim - 1> &xi) const;

    /** The same is linear: the constant part, and what reference coordinates are multiplied by. */
    std::array<dealii::Tensor<1, dim>, dim> area_vector_parts() const;

    /** Reference coordinates of the centre. */
    static dealii::Point<dim - 1> middle();

    dealii::Point<dim> centre() const { return position(middle()); }
    /** Outward. */
    dealii::Tensor<1, dim>   unit_normal(const dealii::Point<dim - 1> &xi = middle()) const;
    double                   diameter() const;
    dealii::BoundingBox<dim> bounding_box() const;

    template <class Archive>
    void save(Archive &archive, const unsigned int /*version*/) const
    {
      archive &vertices &orientation &place &thickness;
      for (const VertexNodes &of_vertex : nodes)
        archive &NodeWeights(of_vertex.begin(), of_vertex.end());
    }

    template <class Archive>
    void load(Archive &archive, const unsigned int /*version*/)
    {
      archive &vertices &orientation &place &thickness;
      for (VertexNodes &of_vertex : nodes)
        {
          NodeWeights weights;
          archive    &weights;
          of_vertex.assign(weights.begin(), weights.end());
        }
    }

    BOOST_SERIALIZATION_SPLIT_MEMBER()
  };

  /**
   * Whether a face of an owned cell lies on the boundary of a body and has one of the boundary ids
   * (empty: all).
   */
  template <int dim>
  bool is_surface_face(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
                       unsigned int                                                  face,
                       unsigned int                                                  body,
                       const std::vector<dealii::types::boundary_id>                &boundary_ids);

  /** The faces of owned cells of a body with one of the boundary ids (empty: all). */
  template <int dim>
  std::vector<SurfaceFace<dim>>
  owned_surface_faces(const Discretization<dim>                     &discretization,
                      unsigned int                                   body,
                      const std::vector<dealii::types::boundary_id> &boundary_ids);
} // namespace signorini

#endif
