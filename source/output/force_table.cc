// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/force_table.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    using Force = std::array<double, 3>;

    template <int dim>
    std::vector<std::string> columns_of_forces(const std::vector<BodyDescription<dim>> &bodies)
    {
      std::vector<std::string> names = {"step", "time"};
      for (const BodyDescription<dim> &body : bodies)
        {
          for (const char *route : {"multiplier", "stress", "momentum"})
            add_vector_columns("force_" + body.name + "_" + route, names);
          names.push_back("force_" + body.name + "_spread");
        }
      return names;
    }


    double distance_of_forces(const Force &a, const Force &b)
    {
      return std::sqrt(std::pow(a[0] - b[0], 2) + std::pow(a[1] - b[1], 2)
                       + std::pow(a[2] - b[2], 2));
    }


    /** Nothing where nothing touches: momentum is then balanced up to round-off. */
    double spread(const Force &multiplier, const Force &stress, const Force &momentum)
    {
      const Force none{};
      if (multiplier == none)
        return 0.;
      return std::max({distance_of_forces(multiplier, stress),
                       distance_of_forces(multiplier, momentum),
                       distance_of_forces(stress, momentum)})
             / std::max({distance_of_forces(multiplier, none),
                         distance_of_forces(stress, none),
                         distance_of_forces(momentum, none)});
    }
  } // namespace


  template <int dim>
  ForceTable<dim>::ForceTable(const std::string                       &directory,
                              const std::vector<BodyDescription<dim>> &bodies,
                              const ForceBalance<dim>                 &balance,
                              const double                             force_before_end,
                              const MPI_Comm                           communicator)
    : table(directory + "/forces.csv", columns_of_forces(bodies), communicator)
    , balance(balance)
    , force_before_end(force_before_end)
  {
  }


  template <int dim>
  void ForceTable<dim>::use_mesh(const ObservedMesh<dim> &mesh, const State &state)
  {
    load = mesh.load;
    balance.start(mesh.discretization, state, load(state.time));
    stress              = std::make_unique<BoundaryStress<dim>>(mesh.discretization);
    displacement_before = state.displacement;
  }


  template <int dim>
  void ForceTable<dim>::write(const State &state, const StepReport &report, const bool is_due)
  {
    std::vector<double> values   = {static_cast<double>(state.step), state.time};
    const auto          n_bodies = balance.n_bodies();
    // The first row is that of no step.
    const auto forces = report.step_size > 0. ? balance.step(state, report, load(state.time))
                                              : std::vector<ContactForceOnBody>(n_bodies);
    std::vector<Force> stresses(n_bodies);
    // Rows that are not due may be written after all if the run ends early, without this route.
    if (is_due && report.step_size > 0.)
      {
        Vector at_the_instant = state.displacement;
        at_the_instant.sadd(1. - force_before_end, force_before_end, displacement_before);
        stresses = stress->forces(at_the_instant, state.contact_force);
      }
    for (std::size_t b = 0; b < n_bodies; ++b)
      {
        add_values(forces[b].by_multiplier, values);
        add_values(stresses[b], values);
        add_values(forces[b].by_momentum, values);
        values.push_back(spread(forces[b].by_multiplier, stresses[b], forces[b].by_momentum));
      }
    table.write_row(values, is_due);
    if (force_before_end > 0.)
      displacement_before = state.displacement;
  }


  template <int dim>
  std::vector<CsvTable *> ForceTable<dim>::files()
  {
    return {&table};
  }


  template class ForceTable<2>;
  template class ForceTable<3>;
} // namespace signorini
