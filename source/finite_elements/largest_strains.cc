// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/finite_elements/largest_strains.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  std::vector<double> largest_strains(const Discretization<dim> &discretization,
                                      const Vector              &displacement)
  {
    const Vector         ghosted = discretization.interpolate_hanging_nodes(displacement);
    std::vector<double>  largest(discretization.mesh().bodies().size(), 0.);
    const QMidpoint<dim> middle;
    const FEValuesExtractors::Vector     vector(0);
    std::vector<SymmetricTensor<2, dim>> strain(1);
    FEValues<dim>                        fe_values(
      discretization.mesh().mapping(), discretization.fe(), middle, update_gradients);
    for (const auto &cell : discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          fe_values[vector].get_function_symmetric_gradients(ghosted, strain);
          double &of_body = largest[cell->material_id()];
          for (const double principal : eigenvalues(strain[0]))
            of_body = std::max(of_body, std::abs(principal));
        }
    Utilities::MPI::max(largest, discretization.communicator(), largest);
    return largest;
  }


  template std::vector<double> largest_strains(const Discretization<2> &, const Vector &);
  template std::vector<double> largest_strains(const Discretization<3> &, const Vector &);
} // namespace signorini
