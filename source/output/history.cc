// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/history.h>

#include <utility>

namespace signorini
{
  namespace
  {
    const std::vector<std::string> columns = {"step",
                                              "time",
                                              "step_size",
                                              "cells",
                                              "dofs",
                                              "kinetic_energy",
                                              "kinetic_energy_modified",
                                              "elastic_energy",
                                              "external_energy",
                                              "total_energy",
                                              "total_energy_modified",
                                              "work_contact",
                                              "work_predictor",
                                              "work_friction",
                                              "work_damping",
                                              "work_scheme",
                                              "work_external",
                                              "work_geometry",
                                              "energy_transfer",
                                              "energy_residual",
                                              "momentum_x",
                                              "momentum_y",
                                              "momentum_z",
                                              "angular_momentum_x",
                                              "angular_momentum_y",
                                              "angular_momentum_z",
                                              "angular_momentum_drift",
                                              "contact_force",
                                              "contact_force_x",
                                              "contact_force_y",
                                              "contact_force_z",
                                              "friction_force",
                                              "active_nodes",
                                              "stick_nodes",
                                              "slip_nodes",
                                              "max_slip",
                                              "max_penetration",
                                              "geometric_penetration",
                                              "active_set_iterations",
                                              "linear_iterations",
                                              "predictor_iterations",
                                              "products_combined",
                                              "products_stiffness",
                                              "products_mass",
                                              "rejected_steps",
                                              "fallbacks",
                                              "wall_time"};

    const std::vector<std::string> error_columns = {"displacement_error",
                                                    "velocity_error",
                                                    "displacement_norm",
                                                    "velocity_norm",
                                                    "relative_displacement_error",
                                                    "relative_velocity_error"};

    const std::vector<std::string> probe_columns =
      {"time", "gap", "normal_displacement", "normal_velocity", "pressure", "normal_force"};

    const std::vector<std::string> friction_columns = {"tangential_force_x",
                                                       "tangential_force_y",
                                                       "tangential_force_z",
                                                       "slip_x",
                                                       "slip_y",
                                                       "slip_z",
                                                       "slip_path",
                                                       "status"};

    std::vector<double> values_of(const HistoryRow &row, const StepSums &sums)
    {
      return {static_cast<double>(row.state.step),
              row.state.time,
              row.report.step_size,
              static_cast<double>(row.cells),
              static_cast<double>(row.dofs),
              row.standard_kinetic_energy,
              row.energy.kinetic,
              row.energy.elastic,
              row.energy.external,
              row.energy.total() - row.energy.kinetic + row.standard_kinetic_energy,
              row.energy.total(),
              sums.booking.contact,
              sums.booking.predictor,
              sums.booking.friction,
              sums.booking.damping,
              sums.booking.scheme,
              sums.booking.external,
              sums.booking.geometry,
              sums.booking.transfer,
              sums.booking.residual,
              row.momentum.linear[0],
              row.momentum.linear[1],
              row.momentum.linear[2],
              row.momentum.angular[0],
              row.momentum.angular[1],
              row.momentum.angular[2],
              row.angular_momentum_drift,
              row.contact.normal_force,
              row.contact.resultant[0],
              row.contact.resultant[1],
              row.contact.resultant[2],
              row.contact.friction_force,
              static_cast<double>(row.contact.n_active),
              static_cast<double>(row.contact.n_stick),
              static_cast<double>(row.contact.n_slip),
              row.contact.max_slip,
              row.contact.max_penetration,
              row.contact.geometric_penetration,
              static_cast<double>(sums.active_set_iterations),
              static_cast<double>(sums.linear_iterations),
              static_cast<double>(sums.predictor_iterations),
              static_cast<double>(sums.products.combined),
              static_cast<double>(sums.products.stiffness),
              static_cast<double>(sums.products.mass),
              static_cast<double>(sums.rejected_steps),
              static_cast<double>(sums.fallbacks),
              row.wall_time};
    }
  } // namespace


  void StepSums::add(const HistoryRow &row)
  {
    booking += row.booking;
    products.combined += row.products.combined;
    products.stiffness += row.products.stiffness;
    products.mass += row.products.mass;
    active_set_iterations += row.report.corrector.active_set_iterations;
    linear_iterations += row.report.corrector.linear_iterations;
    predictor_iterations += row.report.predictor.linear_iterations;
    rejected_steps += row.report.rejected_steps;
    fallbacks += row.report.n_fallbacks();
  }


  template <int dim>
  History<dim>::History(const std::string             &directory,
                        const bool                     with_errors,
                        const bool                     with_friction,
                        const std::vector<Probe<dim>> &probes,
                        const MPI_Comm                 communicator)
    : with_errors(with_errors)
    , with_friction(with_friction)
  {
    std::vector<std::string> names = columns;
    if (with_errors)
      names.insert(names.end(), error_columns.begin(), error_columns.end());
    history = std::make_unique<CsvTable>(directory + "/history.csv", names, communicator);
    names   = probe_columns;
    if (with_friction)
      names.insert(names.end(), friction_columns.begin(), friction_columns.end());
    for (const Probe<dim> &probe : probes)
      probe_tables.push_back(std::make_unique<CsvTable>(
        directory + "/probe_" + probe.name() + ".csv", names, communicator));
  }


  template <int dim>
  void History<dim>::write(const HistoryRow &row, const bool is_due)
  {
    since_last_row.add(row);
    std::vector<double> values = values_of(row, since_last_row);
    if (is_due)
      since_last_row = StepSums();
    if (with_errors)
      for (const double error : {row.errors.displacement,
                                 row.errors.velocity,
                                 row.errors.displacement_norm,
                                 row.errors.velocity_norm,
                                 row.errors.relative_displacement,
                                 row.errors.relative_velocity})
        values.push_back(error);
    history->write_row(values, is_due);
  }


  template <int dim>
  void History<dim>::write_probe(const unsigned int  probe,
                                 const double        time,
                                 const ProbeReading &reading,
                                 const bool          is_due)
  {
    std::vector<double> values = {time,
                                  reading.gap,
                                  reading.normal_displacement,
                                  reading.normal_velocity,
                                  reading.pressure,
                                  reading.normal_force};
    if (with_friction)
      {
        values.insert(
          values.end(), reading.tangential_force.begin(), reading.tangential_force.end());
        values.insert(values.end(), reading.slip.begin(), reading.slip.end());
        values.push_back(reading.slip_path);
        values.push_back(reading.status);
      }
    probe_tables[probe]->write_row(values, is_due);
  }


  template <int dim>
  void History<dim>::finish()
  {
    history->finish();
    for (const auto &table : probe_tables)
      table->finish();
  }


  template <int dim>
  void History<dim>::archive(Archive &archive)
  {
    archive(since_last_row);
    history->archive(archive);
    for (const auto &table : probe_tables)
      table->archive(archive);
  }


  template class History<2>;
  template class History<3>;
} // namespace signorini
