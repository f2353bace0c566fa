// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_simulation_simulation_h
#define signorini_simulation_simulation_h

#include <signorini/output/field_output.h>
#include <signorini/output/run_log.h>
#include <signorini/simulation/observation.h>
#include <signorini/system/elastic_contact_system.h>

#include <deal.II/base/timer.h>

#include <sstream>

namespace signorini
{
  /**
   * A run of one scene. Owns the nouns and orders the verbs, nothing else. All functions are collective.
   */
  template <int dim>
  class Simulation
  {
  public:
    /** Builds the mesh. @param quiet no output on the screen. The scene must outlive the simulation. */
    Simulation(const Scene<dim> &scene, MPI_Comm communicator, bool quiet);

    /**
     * Build everything that a run needs, and look for penetration at the start.
     * @return what would run, for the user
     * @throws UserError
     */
    std::string validate();

    /** From time 0 to the end. @throws UserError before the first step, RunError later. */
    void run();

  private:
    const Scene<dim>   &scene;
    const bool          quiet;
    std::ostringstream  timer_table;
    dealii::TimerOutput timer;
    Discretization<dim> discretization;
    State               state;
    std::string         mass_note; ///< what became of the mass, if that is not the consistent one

    std::unique_ptr<Supports<dim>>             supports;
    std::unique_ptr<ContactSurface<dim>>       surface;
    std::unique_ptr<ContactCoordinates<dim>>   coordinates;
    std::unique_ptr<Loads<dim>>                loads;
    std::unique_ptr<ElasticContactSystem<dim>> system;

    /** Matrices, contact surface, system, initial state. */
    void        prepare();
    void        set_initial_state();
    bool        writes_fields(unsigned int step, bool is_last) const;
    std::string description() const;
  };
} // namespace signorini

#endif
