// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/point_probe_table.h>

namespace signorini
{
  template <int dim>
  PointProbeTable<dim>::PointProbeTable(const std::string                             &directory,
                                        const std::vector<PointProbeDescription<dim>> &descriptions,
                                        const MPI_Comm                                 communicator)
    : descriptions(descriptions)
  {
    std::vector<std::string> names = {"time"};
    for (const char *quantity : {"position", "displacement", "velocity"})
      add_vector_columns(quantity, names);
    for (const char *component : {"xx", "yy", "zz", "xy", "xz", "yz"})
      names.push_back(std::string("stress_") + component);
    names.emplace_back("von_mises");
    for (const auto &probe : descriptions)
      tables.push_back(std::make_unique<CsvTable>(
        directory + "/probe_" + probe.name + ".csv", names, communicator));
  }


  template <int dim>
  void PointProbeTable<dim>::use_mesh(const ObservedMesh<dim> &mesh, const State & /*state*/)
  {
    discretization = &mesh.discretization;
    probes.clear();
    for (const auto &probe : descriptions)
      probes.emplace_back(probe, *discretization);
  }


  template <int dim>
  void
  PointProbeTable<dim>::write(const State &state, const StepReport & /*report*/, const bool is_due)
  {
    const Vector displacement = discretization->interpolate_hanging_nodes(state.displacement),
                 velocity     = discretization->interpolate_hanging_nodes(state.velocity);
    for (std::size_t p = 0; p < probes.size(); ++p)
      {
        const PointReading  reading = probes[p].read(displacement, velocity);
        std::vector<double> values  = {state.time};
        for (const auto &vector : {reading.position, reading.displacement, reading.velocity})
          add_values(vector, values);
        values.insert(values.end(), reading.stress.begin(), reading.stress.end());
        values.push_back(reading.von_mises);
        tables[p]->write_row(values, is_due);
      }
  }


  template <int dim>
  std::vector<CsvTable *> PointProbeTable<dim>::files()
  {
    std::vector<CsvTable *> files;
    for (const auto &table : tables)
      files.push_back(table.get());
    return files;
  }


  template class PointProbeTable<2>;
  template class PointProbeTable<3>;
} // namespace signorini
