// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/preconditioners/preconditioner_choice.h>
#include <signorini/simulation/memory_estimate.h>
#include <signorini/system/step_matrices.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

namespace signorini
{
  namespace
  {
    /** Of the program without a scene: libraries, and what MPI keeps. */
    constexpr double of_the_program = 90e6;

    /**
     * Bytes that steps add per unknown: copies of the matrix, and vectors; without the levels of
     * multigrid, which are measured.
     */
    template <int dim>
    double bytes_per_unknown(const bool multigrid)
    {
      if (dim == 2)
        return multigrid ? 570. : 620.;
      return multigrid ? 650. : 740.;
    }

    /** Bytes that fields take per cell while they are written: patches of values at corners. */
    template <int dim>
    constexpr double bytes_per_cell = dim == 2 ? 1600. : 2500.;


    template <int dim>
    bool takes_multigrid(const Scene<dim> &scene, const MeshedScene<dim> &meshed)
    {
      const PreconditionerKind chosen = scene.solver.preconditioner;
      if (chosen != PreconditionerKind::automatic)
        return chosen == PreconditionerKind::multigrid || chosen == PreconditionerKind::ml;
      if (!scheme_info(scene.time.scheme).inertia)
        return true;
      StepCost cost         = cost_of_step(meshed.discretization, scene.time.step_size);
      cost.matrix_life_time = scene.time.n_steps();
      cost.solves_roughly   = true;
      return choose_preconditioner(cost) == PreconditionerKind::multigrid;
    }


    /** What the factor of condensed steps takes. */
    template <int dim>
    double memory_of_condensation(const Scene<dim> &scene, const MeshedScene<dim> &meshed)
    {
      const StepsOfMatrix use{
        scene.time.step_size, scene.time.n_steps(), has_friction(scene.pairs)};
      return scheme_info(scene.time.scheme).inertia
                 && condenses(scene.solver.condensation,
                              scene.solver.preconditioner,
                              meshed.discretization,
                              meshed.coordinates,
                              use)
               ? memory_of_factor(meshed.discretization.dof_handler().n_dofs())
               : 0.;
    }


    /** Of this process: now, and the most so far. */
    std::pair<double, double> resident_bytes()
    {
      dealii::Utilities::System::MemoryStats measured;
      dealii::Utilities::System::get_memory_stats(measured);
      return {1024. * measured.VmRSS, 1024. * measured.VmHWM}; // kB
    }


    /** What a cycle takes, by making one: algebraic levels are as large as they turn out to be. */
    template <int dim>
    double memory_of_multigrid(const Scene<dim> &scene, const MeshedScene<dim> &meshed)
    {
      std::ostringstream  no_table;
      dealii::TimerOutput timer(
        no_table, dealii::TimerOutput::never, dealii::TimerOutput::wall_times);
      const double         step = scene.time.step_size, before = resident_bytes().first;
      PreconditionerChoice multigrid;
      multigrid.kind         = PreconditionerKind::multigrid;
      multigrid.condensation = CondensationKind::never;
      StepMatrices<dim> matrices(meshed.discretization, meshed.coordinates, multigrid, timer);
      matrices.get(0.25 * step * step, 0., step);
      return std::max(0., resident_bytes().first - before);
    }
  } // namespace


  template <int dim>
  MemoryEstimate memory_estimate(const Scene<dim> &scene, const MeshedScene<dim> &meshed)
  {
    const auto    &discretization = meshed.discretization;
    const MPI_Comm communicator   = discretization.communicator();
    const auto    &triangulation  = discretization.mesh().triangulation();

    dealii::Utilities::System::MemoryStats measured;
    dealii::Utilities::System::get_memory_stats(measured);
    const double prepared  = 1024. * measured.VmHWM; // kB
    const double condensed = memory_of_condensation(scene, meshed);
    const bool   multigrid = condensed == 0. && takes_multigrid(scene, meshed);
    const double steps =
      bytes_per_unknown<dim>(multigrid) * discretization.locally_owned().n_elements()
      + (multigrid ? memory_of_multigrid(scene, meshed) : 0.) + condensed;
    const double fields =
      scene.output.vtu ? bytes_per_cell<dim> * triangulation.n_locally_owned_active_cells() : 0.;
    // While levels are made they may take more than they keep.
    const double run = std::max(prepared + steps + fields, resident_bytes().second);

    MemoryEstimate estimate;
    estimate.prepared        = dealii::Utilities::MPI::sum(prepared, communicator);
    estimate.run             = dealii::Utilities::MPI::sum(run, communicator);
    estimate.largest_process = dealii::Utilities::MPI::max(run, communicator);
    estimate.at_most         = estimate.run;
    if (scene.adaptivity.any() && scene.adaptivity.maximum_cells == 0)
      estimate.at_most = std::numeric_limits<double>::infinity();
    else if (scene.adaptivity.any())
      {
        const double program =
          of_the_program * dealii::Utilities::MPI::n_mpi_processes(communicator);
        const double growth = static_cast<double>(scene.adaptivity.maximum_cells)
                              / triangulation.n_global_active_cells();
        estimate.at_most = program + std::max(1., growth) * (estimate.run - program);
      }
    return estimate;
  }


  template MemoryEstimate memory_estimate(const Scene<2> &, const MeshedScene<2> &);
  template MemoryEstimate memory_estimate(const Scene<3> &, const MeshedScene<3> &);
} // namespace signorini
