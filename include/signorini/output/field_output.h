// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_field_output_h
#define signorini_output_field_output_h

#include <signorini/output/cell_stress.h>
#include <signorini/output/field_series.h>
#include <signorini/output/surface_patches.h>

namespace signorini
{
  /**
   * Pictures of the motion for Paraview: `volume.pvd` with displacement and velocity (nodes), body,
   * stress_xx, ..., von_mises, strain_xx, ... and subdomain and, on meshes that change,
   * error_indicator (cells), and `surface.pvd` with the contact surface, see SurfacePatches. Stress
   * and strain of a cell are its means; in 2d (plane strain) stress_zz is part of it. strain_xy is
   * a component of the tensor, half the angle of shear. A scene without contact pairs has no
   * surface series.
   */
  template <int dim>
  class FieldOutput
  {
  public:
    /** Collective. The .pvd files of an earlier run in this directory are removed. */
    FieldOutput(const std::string &directory, MPI_Comm communicator);

    /**
     * Write the fields of a moment; a second call for the same step does nothing. Collective.
     * @param discretization, surface of the mesh as it is
     * @param indicators              of the error per cell, empty for none
     * @throws RunError on all processes if a file cannot be written
     */
    void write(const State                  &state,
               const Discretization<dim>    &discretization,
               const ContactSurface<dim>    &surface,
               const dealii::Vector<double> &indicators = {});

  private:
    FieldSeries                   volume_series, surface_series;
    static constexpr unsigned int none      = static_cast<unsigned int>(-1);
    unsigned int                  last_step = none;

    void write_volume(const State                  &state,
                      const Discretization<dim>    &discretization,
                      const Vector                 &displacement,
                      const Vector                 &velocity,
                      const dealii::Vector<double> &indicators);
  };
} // namespace signorini

#endif
