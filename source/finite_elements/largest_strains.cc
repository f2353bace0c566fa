// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/finite_elements/largest_strains.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /**
     * Derivatives of a field in the middle of the reference cell, times the number of edges in a
     * direction: what it grows along them.
     */
    template <int dim, typename ValueAt>
    Tensor<2, dim> growth_along_edges(const ValueAt &value_at)
    {
      Tensor<2, dim> growth; // [component][direction]
      for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
        {
          const Tensor<1, dim> value = value_at(v);
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int c = 0; c < dim; ++c)
              growth[c][d] += (v >> d & 1) != 0 ? value[c] : -value[c];
        }
      return growth;
    }
  } // namespace


  template <int dim>
  std::vector<double> largest_strains(const Discretization<dim> &discretization,
                                      const Vector              &displacement)
  {
    const Vector        ghosted = discretization.interpolate_hanging_nodes(displacement);
    std::vector<double> largest(discretization.mesh().bodies().size(), 0.);
    std::vector<types::global_dof_index> dofs(discretization.fe().n_dofs_per_cell());
    for (const auto &cell : discretization.cells())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          const auto of_displacement = growth_along_edges<dim>([&](const unsigned int v) {
            Tensor<1, dim> value; // each vertex has one shape function per component
            for (unsigned int c = 0; c < dim; ++c)
              value[c] = ghosted(dofs[dim * v + c]);
            return value;
          });
          const auto of_position =
            growth_along_edges<dim>([&](const unsigned int v) { return cell->vertex(v); });
          const SymmetricTensor<2, dim> strain  = symmetrize(of_displacement * invert(of_position));
          double                       &of_body = largest[cell->material_id()];
          if (strain.norm() > of_body) // which is never less than the largest principal strain
            for (const double principal : eigenvalues(strain))
              of_body = std::max(of_body, std::abs(principal));
        }
    Utilities::MPI::max(largest, discretization.communicator(), largest);
    return largest;
  }


  template std::vector<double> largest_strains(const Discretization<2> &, const Vector &);
  template std::vector<double> largest_strains(const Discretization<3> &, const Vector &);
} // namespace signorini
