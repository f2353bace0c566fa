// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_contact_two_bodies_h
#define signorini_tests_contact_two_bodies_h

#include "../discretization/bodies.h"

#include <signorini/contact/contact_coordinates.h>
#include <signorini/contact/mortar_coupling.h>

#include <deal.II/grid/grid_tools.h>

namespace signorini::tests
{
  // Faces of blocks that lie on each other in the last direction.
  template <int dim>
  constexpr dealii::types::boundary_id bottom_id = 2 * (dim - 1);
  template <int dim>
  constexpr dealii::types::boundary_id top_id = 2 * dim - 1;

  template <int dim>
  BodyDescription<dim> block(const std::string                   &name,
                             const dealii::Point<dim>            &lower,
                             const dealii::Point<dim>            &upper,
                             const std::array<unsigned int, dim> &repetitions)
  {
    BodyDescription<dim> body;
    body.name          = name;
    BoxShape<dim> &box = box_of(body);
    box.lower_corner   = lower;
    box.upper_corner   = upper;
    box.repetitions    = repetitions;
    body.material      = {500., 0.3, 2.};
    return body;
  }

  /**
   * The first body is the slave, with its face at the bottom, the second the master, with its face
   * at the top.
   */
  template <int dim>
  Scene<dim> stacked(const BodyDescription<dim> &slave, const BodyDescription<dim> &master)
  {
    Scene<dim>      scene = scene_of<dim>({slave, master});
    PairDescription pair;
    pair.name                = slave.name + " : " + master.name;
    pair.slave               = 0;
    pair.slave_boundary_ids  = {bottom_id<dim>};
    pair.master              = 1;
    pair.master_boundary_ids = {top_id<dim>};
    scene.pairs.push_back(pair);
    return scene;
  }

  /** A rotation without any symmetry. */
  template <int dim>
  dealii::Tensor<2, dim> rotation(const double angle)
  {
    const double           c = std::cos(angle), s = std::sin(angle);
    dealii::Tensor<2, dim> first, second;
    for (unsigned int d = 0; d < dim; ++d)
      first[d][d] = second[d][d] = 1.;
    first[0][0] = first[1][1] = c;
    first[0][1]               = -s;
    first[1][0]               = s;
    if constexpr (dim == 3)
      {
        second[1][1] = second[2][2] = c;
        second[1][2]                = -s;
        second[2][1]                = s;
      }
    return second * first;
  }

  template <int dim>
  using Map = std::function<dealii::Point<dim>(const dealii::Point<dim> &)>;

  template <int dim>
  Map<dim> turn(const double angle)
  {
    return [matrix = rotation<dim>(angle)](const dealii::Point<dim> &p) {
      return dealii::Point<dim>(matrix * dealii::Tensor<1, dim>(p));
    };
  }

  /** A scene up to the assembled matrices; the vertices can be moved before. */
  template <int dim>
  struct MappedAssembled
  {
    MappedAssembled(const Scene<dim> &scene, const Map<dim> &map)
      : scene(scene)
      , mesh(scene.bodies, MPI_COMM_WORLD, scene.mapping)
      , discretization(moved(map))
    {
    }

    const Scene<dim>    scene;
    Mesh<dim>           mesh;
    Discretization<dim> discretization;

  private:
    const Mesh<dim> &moved(const Map<dim> &map)
    {
      if (map)
        {
          dealii::GridTools::transform(map, mesh.triangulation());
          mesh.update();
        }
      return mesh;
    }
  };

  /** Everything up to contact coordinates, and the mortar coupling of the first pair once more. */
  template <int dim>
  struct TwoBodies : public MappedAssembled<dim>
  {
    explicit TwoBodies(const Scene<dim> &scene, const Map<dim> &map = {})
      : MappedAssembled<dim>(scene, map)
      , dirichlet(this->discretization)
      , mortar(this->discretization, dirichlet, scene.pairs, 0)
      , surface(this->discretization, dirichlet, scene.obstacles, scene.pairs)
      , coordinates(this->discretization, surface, dirichlet)
    {
    }

    /** Sum over the contact nodes of all processes. */
    double sum(const std::function<double(const ContactNode<dim> &)> &value) const
    {
      double result = 0.;
      for (const ContactNode<dim> &node : surface.nodes())
        result += value(node);
      return dealii::Utilities::MPI::sum(result, MPI_COMM_WORLD);
    }

    /** Which of the owned nodes belong to a body. */
    std::vector<bool> nodes_of_body(const unsigned int body) const
    {
      const auto       &partitioner = *this->discretization.matrices().pattern.partitioner;
      std::vector<bool> nodes(this->discretization.matrices().pattern.n_owned);
      for (const auto &cell : this->discretization.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() == body)
          for (const unsigned int v : cell->vertex_indices())
            if (const auto dof = cell->vertex_dof_index(v, 0); partitioner.in_local_range(dof))
              nodes[partitioner.global_to_local(dof) / dim] = true;
      return nodes;
    }

    /** Sum of nodal forces over the nodes of a body. */
    dealii::Tensor<1, dim> resultant_on(const unsigned int body, const Vector &forces) const
    {
      const auto             nodes = nodes_of_body(body);
      dealii::Tensor<1, dim> result;
      for (unsigned int node = 0; node < this->discretization.matrices().pattern.n_owned; ++node)
        if (nodes[node])
          for (unsigned int c = 0; c < dim; ++c)
            result[c] += forces.local_element(dim * node + c);
      return dealii::Utilities::MPI::sum(result, MPI_COMM_WORLD);
    }

    /** Nodal values of a function of the reference position; zero at hanging nodes. */
    Vector
    nodal(const std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &)> &function) const
    {
      Vector result = this->discretization.make_vector();
      for (unsigned int node = 0; node < this->discretization.matrices().pattern.n_owned; ++node)
        {
          if (this->discretization.matrices().pattern.is_empty(node))
            continue;
          const dealii::Tensor<1, dim> value =
            function(this->discretization.node_positions()[node]);
          for (unsigned int c = 0; c < dim; ++c)
            result.local_element(dim * node + c) = value[c];
        }
      return result;
    }

    const DirichletConditions<dim> dirichlet;
    const MortarCoupling<dim>      mortar;
    const ContactSurface<dim>      surface;
    const ContactCoordinates<dim>  coordinates;
  };
} // namespace signorini::tests

#endif
