// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/contact/overlap.h>
#include <signorini/diagnostics/held_by_turning.h>
#include <signorini/diagnostics/probe.h>
#include <signorini/output/point_probe.h>
#include <signorini/schemes/scheme_table.h>
#include <signorini/simulation/change_mesh.h>
#include <signorini/simulation/expectations.h>
#include <signorini/simulation/initial_equilibrium.h>
#include <signorini/simulation/simulation.h>

#include <sstream>

namespace signorini
{
  namespace
  {
    /**
     * The matrix of a step is the mass plus a stiffness that is larger by the square of the Courant
     * number. Where this square is all that a number can hold, round-off moves the bodies.
     */
    template <int dim>
    void check_courant_number(const Mesh<dim> &mesh, const TimeParameters &time)
    {
      constexpr double most   = 1e7;
      const double     number = mesh.courant_number(time.step_size);
      if (!scheme_info(time.scheme).inertia || number <= most)
        return;
      std::ostringstream message;
      message << "Time/Step size = " << time.step_size << " gives the Courant number " << number
              << ": so many smallest cells are passed by a wave in a step, and with more than "
              << most
              << " round-off hides the inertia of the bodies. Use smaller steps or a softer "
                 "material, take a rigid obstacle instead of a body that is nearly rigid, or a "
                 "scheme without inertia.";
      throw UserError(message.str());
    }


    /** Of what moves so far in a step, positions have no digits left that tell a gap. */
    template <int dim>
    void check_speed(const Mesh<dim> &mesh, const Vector &velocity, const double step_size)
    {
      constexpr double most = 1e8;
      const double     way  = velocity.linfty_norm() * step_size / mesh.body_size();
      if (way <= most)
        return;
      std::ostringstream message;
      message << "Bodies: an initial velocity leads in a step of `Time/Step size` = " << step_size
              << " over " << way << " times the size of the bodies, and with more than " << most
              << " round-off hides what they touch. Correct the velocity, or use smaller steps.";
      throw UserError(message.str());
    }


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
    check_courant_number(mesh, scene.time);
    mesh_control.check_first_mesh();
    check_that_bodies_are_apart(mesh, scene.pairs);
    meshed = std::make_unique<MeshedScene<dim>>(mesh, scene, mesh_control.mesh_life_time(), timer);
    check_capabilities(*scheme, meshed->system);
    set_initial_state();
    if (scheme_info(scene.time.scheme).inertia)
      check_speed(mesh, state.velocity, scene.time.step_size);
    if (mesh_control.any())
      adapt_initial_mesh();
    settle_damping();
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
    const bool has_inertia = scheme_info(scene.time.scheme).inertia;
    start_remarks          = Remarks();
    if (has_inertia)
      start_remarks = start_with_conditions(
        meshed->discretization, meshed->coordinates, scene.time.step_size, state.velocity);
    if (scene.time.start == StartKind::equilibrium)
      {
        dealii::TimerOutput::Scope scope(timer, "start: equilibrium");
        equilibrium = naming_file<RunError>(
          scene.file_name, [&] { return initial_equilibrium(scene, *meshed, state); });
        for (const std::string &sentence : equilibrium.remarks)
          start_remarks.warnings.push_back(sentence);
        for (const std::string &sentence : held_by_turning(meshed->discretization, state))
          start_remarks.warnings.push_back(sentence);
      }
    if (has_inertia)
      for (const std::string &sentence :
           jump_to_conditions(meshed->discretization, meshed->coordinates, state.displacement)
             .warnings)
        start_remarks.warnings.push_back(sentence);
    for (const std::string &note : meshed->dirichlet.check_shared_nodes(scene.time.end_time))
      start_remarks.notes.push_back(note);
    meshed->system.apply_mass(state.momentum, state.velocity);
    meshed->system.apply_stiffness(state.internal_force, state.displacement);
  }


  template void Simulation<2>::prepare();
  template void Simulation<3>::prepare();
} // namespace signorini
