// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_state_transfer_h
#define signorini_adaptivity_state_transfer_h

#include <signorini/adaptivity/field_transfer.h>
#include <signorini/contact/contact_coordinates.h>
#include <signorini/model/run_parameters.h>
#include <signorini/time/dynamical_system.h>
#include <signorini/time/state.h>

namespace signorini
{
  /**
   * Carries a state to a changed mesh.
   *
   * On refined cells every function stays what it is. Where cells are coarsened, velocity and
   * acceleration are projected in the mass matrix, which keeps momentum and takes kinetic energy,
   * and the displacement in the energy of the elastic forces onto the admissible set, which moves
   * no free body (project_in_energy()). Contact forces go as stresses at contact nodes, slip as
   * values at nodes; a new node between two that stick or slip does what they do.
   *
   * No change of the mesh brings energy: what other points of quadrature, bounds that are in the
   * way of a projection, or the work of loads on what a projection changes would add is taken out
   * of the vibration (take_from_vibration()), as far as there is one.
   */
  template <int dim>
  class StateTransfer
  {
  public:
    /**
     * Take the state. The mesh must carry its final flags, and must change next; the other
     * arguments must live until then. @param load at the time of the state, null: none. Collective.
     */
    StateTransfer(Mesh<dim>                     &mesh,
                  const Discretization<dim>     &discretization,
                  const ContactSurface<dim>     &surface,
                  const ContactCoordinates<dim> &coordinates,
                  const State                   &state,
                  const Vector                  *load = nullptr);

    /**
     * The state on the new mesh. Where the finer geometry of the contact surface shows that the
     * displacement penetrates, the surface admits that, see ContactSurface::admit(). Once.
     * Collective. All arguments are of the new mesh.
     */
    State finish(const Discretization<dim>     &discretization,
                 ContactSurface<dim>           &surface,
                 const ContactCoordinates<dim> &coordinates,
                 DynamicalSystem               &system,
                 const ActiveSetLimits         &limits);

  private:
    const State        clock; ///< step and time
    const bool         has_acceleration, has_friction, has_last_step;
    const double       elastic_size; ///< energy norm of the old displacement
    const bool         has_load;
    const double       energy; ///< of the old state, with the potential of the load
    FieldTransfer<dim> fields;

    /**
     * What a displacement becomes on the new mesh. Where contact follows the motion, its normals
     * are those of what the projection changes.
     * @param contact null: linearised
     */
    Vector displacement_after(const typename FieldTransfer<dim>::Result &,
                              const Discretization<dim> &,
                              ContactSurface<dim> &,
                              const ContactCoordinates<dim> &,
                              MovingContact *contact,
                              const ActiveSetLimits &) const;

    /** Take what the state has gained out of its vibration. */
    void keep_energy(const Discretization<dim> &,
                     const ContactCoordinates<dim> &,
                     DynamicalSystem &,
                     State &) const;
  };
} // namespace signorini

#endif
