// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/support_table.h>

namespace signorini
{
  namespace
  {
    template <int dim>
    std::vector<std::string> columns_of(const std::vector<BodyDescription<dim>> &bodies)
    {
      std::vector<std::string> names = {"step", "time"};
      for (const BodyDescription<dim> &body : bodies)
        for (const BoundaryCondition<dim> &condition : body.dirichlet)
          add_vector_columns("support_" + body.name + "_" + std::to_string(condition.boundary_id),
                             names);
      return names;
    }
  } // namespace


  template <int dim>
  SupportTable<dim>::SupportTable(const std::string                       &directory,
                                  const std::vector<BodyDescription<dim>> &bodies,
                                  const bool                               mean_contact_force,
                                  const MPI_Comm                           communicator)
    : table(directory + "/supports.csv", columns_of(bodies), communicator)
    , mean_contact_force(mean_contact_force)
  {
  }


  template <int dim>
  void SupportTable<dim>::use_mesh(const ObservedMesh<dim> &mesh, const State &state)
  {
    supports         = std::make_unique<Supports<dim>>(mesh.dirichlet, mesh.surface);
    handed_on_before = supports->handed_on(state.contact_force);
  }


  template <int dim>
  void SupportTable<dim>::write(const State &state, const StepReport &report, const bool is_due)
  {
    // The nodal forces hold against what contact hands on, too.
    const Forces handed_on = supports->handed_on(state.contact_force);
    Forces       forces(handed_on.size());
    if (report.support_force.size() > 0)
      forces = supports->sums(report.support_force);
    std::vector<double> values = {static_cast<double>(state.step), state.time};
    for (std::size_t i = 0; i < forces.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        {
          const double start = mean_contact_force ? handed_on_before[i][c] : handed_on[i][c];
          values.push_back(forces[i][c] - 0.5 * (start + handed_on[i][c]));
        }
    table.write_row(values, is_due);
    handed_on_before = handed_on;
  }


  template <int dim>
  std::vector<CsvTable *> SupportTable<dim>::files()
  {
    return {&table};
  }


  template class SupportTable<2>;
  template class SupportTable<3>;
} // namespace signorini
