// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/contact/overlap.h>
#include <signorini/diagnostics/probe.h>
#include <signorini/output/point_probe.h>
#include <signorini/schemes/scheme_table.h>
#include <signorini/simulation/change_mesh.h>
#include <signorini/simulation/expectations.h>
#include <signorini/simulation/initial_equilibrium.h>
#include <signorini/simulation/simulation.h>

namespace signorini
{
  namespace
  {
    /** Each of them has to find its point, see PointProbe and Probe. Collective. */
    template <int dim>
    void check_probes(const Scene<dim> &scene, const MeshedScene<dim> &meshed)
    {
      for (const auto &probe : scene.probes)
        Probe<dim>(probe, meshed.surface, meshed.discretization.communicator());
      for (const auto &probe : scene.point_probes)
        PointProbe<dim>(probe, meshed.discretization);
    }
  } // namespace


  template <int dim>
  void Simulation<dim>::prepare()
  {
    mesh_control.check_first_mesh();
    check_that_bodies_are_apart(mesh, scene.pairs);
    meshed = std::make_unique<MeshedScene<dim>>(mesh, scene, mesh_control.mesh_life_time(), timer);
    check_capabilities(*scheme, meshed->system);
    set_initial_state();
    if (mesh_control.any())
      adapt_initial_mesh();
    check_probes(scene, *meshed);
    impacts  = first_impacts(scene, *meshed, state);
    expected = expectations(scene, impacts);
  }


  template <int dim>
  void Simulation<dim>::adapt_initial_mesh()
  {
    for (unsigned int level = 0; level < scene.adaptivity.maximum_level; ++level)
      {
        if (!mesh_control.judge(*meshed, {state, state, 0.}).refines())
          return;
        mesh_control.mesh_changes(0);
        build_on_changed_mesh(mesh, scene, mesh_control.mesh_life_time(), meshed, timer);
        set_initial_state();
      }
  }


  template <int dim>
  void Simulation<dim>::set_initial_state()
  {
    state = State(); // not by assignment of vectors, which would keep the ghosts of an earlier mesh
    state = initial_state(meshed->discretization);
    meshed->surface.check_initial_gap(state.displacement); // of the scene as it is given
    if (scene.time.start == StartKind::equilibrium)
      equilibrium = naming_file<RunError>(
        scene.file_name, [&] { return initial_equilibrium(scene, *meshed, state); });
    start_remarks = Remarks();
    if (scheme_info(scene.time.scheme).inertia)
      start_remarks = start_with_conditions(
        meshed->discretization, meshed->coordinates, scene.time.step_size, state);
    for (const std::string &note : meshed->dirichlet.check_shared_nodes(scene.time.end_time))
      start_remarks.notes.push_back(note);
    meshed->system.apply_mass(state.momentum, state.velocity);
    meshed->system.apply_stiffness(state.internal_force, state.displacement);
  }


  template void Simulation<2>::prepare();
  template void Simulation<3>::prepare();
} // namespace signorini
