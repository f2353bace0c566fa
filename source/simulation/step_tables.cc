// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/body_table.h>
#include <signorini/output/force_table.h>
#include <signorini/output/pair_table.h>
#include <signorini/output/point_probe_table.h>
#include <signorini/output/support_table.h>
#include <signorini/schemes/scheme_table.h>
#include <signorini/simulation/step_tables.h>

#include <algorithm>

namespace signorini
{
  template <int dim>
  StepTables<dim>::StepTables(const Scene<dim> &scene, const MPI_Comm communicator)
  {
    const std::string &directory    = scene.output_directory;
    const bool         has_supports = std::any_of(scene.bodies.begin(),
                                          scene.bodies.end(),
                                          [](const auto &body) { return !body.dirichlet.empty(); });
    if (scene.output.supports && has_supports)
      tables.push_back(std::make_unique<SupportTable<dim>>(directory,
                                                           scene.bodies,
                                                           scheme_info(scene.time.scheme).balance
                                                             == StepBalance::both_ends,
                                                           communicator));
    if (scene.output.pairs && !scene.pairs.empty())
      tables.push_back(
        std::make_unique<PairTable<dim>>(directory, scene.pairs.size(), communicator));
    if (scene.output.bodies)
      tables.push_back(std::make_unique<BodyTable<dim>>(directory, scene.bodies, communicator));
    if (scene.output.forces && !scene.pairs.empty())
      {
        const SchemeInfo &scheme = scheme_info(scene.time.scheme);
        tables.push_back(
          std::make_unique<ForceTable<dim>>(directory,
                                            scene.bodies,
                                            ForceBalance<dim>(scheme.balance, scheme.inertia),
                                            force_before_end(scheme, scene.time.parameters),
                                            communicator));
      }
    if (!scene.point_probes.empty())
      tables.push_back(
        std::make_unique<PointProbeTable<dim>>(directory, scene.point_probes, communicator));
  }


  template <int dim>
  void StepTables<dim>::use_mesh(MeshedScene<dim>      &meshed,
                                 const BodyMotion<dim> &motion,
                                 const State           &state)
  {
    const ObservedMesh<dim> mesh{
      meshed.discretization, meshed.dirichlet, meshed.surface, motion, [&](const double time) {
        return meshed.load(time);
      }};
    for (const auto &table : tables)
      table->use_mesh(mesh, state);
  }


  template <int dim>
  void StepTables<dim>::write(const State &state, const StepReport &report, const bool is_due)
  {
    for (const auto &table : tables)
      table->write(state, report, is_due);
  }


  template <int dim>
  void StepTables<dim>::finish()
  {
    for (const auto &table : tables)
      for (CsvTable *file : table->files())
        file->finish();
  }


  template <int dim>
  void StepTables<dim>::archive(Archive &archive)
  {
    for (const auto &table : tables)
      for (CsvTable *file : table->files())
        file->archive(archive);
  }


  template class StepTables<2>;
  template class StepTables<3>;
} // namespace signorini
