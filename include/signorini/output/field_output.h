// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_field_output_h
#define signorini_output_field_output_h

#include <signorini/output/field_series.h>
#include <signorini/output/spare_core.h>
#include <signorini/output/surface_patches.h>
#include <signorini/output/volume_patches.h>

#include <future>

namespace signorini
{
  /**
   * Pictures of the motion for Paraview: `volume.pvd` with displacement and velocity (nodes), body,
   * stress_xx, ..., von_mises, strain_xx, ... and subdomain and, on meshes that change,
   * error_indicator (cells), and `surface.pvd` with the contact surface, see SurfacePatches. Stress
   * and strain of a cell are its means; in 2d (plane strain) stress_zz is part of it. strain_xy is
   * a component of the tensor, half the angle of shear. A scene without contact pairs has no
   * surface series.
   *
   * Most of the work is compression. In the background it is done by a thread while the run goes
   * on, one moment at a time: the patches hold copies of all values, and neither that thread nor
   * what it calls communicates. What it could not write is reported by the next call of write(),
   * finish_if_written() or finish(), and no .pvd names it.
   */
  template <int dim>
  class FieldOutput
  {
  public:
    /**
     * Collective. The .pvd files of an earlier run in this directory are removed.
     * @param in_background the same on all processes
     */
    FieldOutput(const std::string &directory, MPI_Comm communicator, bool in_background);

    /** In the background if there is a core for it. */
    FieldOutput(const std::string &directory, const MPI_Comm communicator)
      : FieldOutput(directory, communicator, has_spare_core(communicator))
    {
    }

    /**
     * Write the fields of a moment, or begin to; a second call for the same step does nothing.
     * Collective.
     * @param discretization, surface of the mesh as it is
     * @param indicators              of the error per cell, empty for none
     * @throws RunError on all processes if a file of this or the earlier moment cannot be written
     */
    void write(const State                  &state,
               const Discretization<dim>    &discretization,
               const ContactSurface<dim>    &surface,
               const dealii::Vector<double> &indicators = {});

    /** Whether a moment is being written: the same on all processes. */
    bool is_writing() const { return pieces.valid(); }

    /**
     * Wait until the moment that is being written is complete. To be called at the end: the
     * destructor waits for the thread, but no .pvd names the moment then. Collective.
     * @throws RunError on all processes if a file cannot be written
     */
    void finish();

    /** finish() if it need not wait. Collective. @throws RunError see finish() */
    void finish_if_written();

    /** The moments so far; nothing may be being written. */
    void archive(Archive &archive)
    {
      volume_series.archive(archive);
      surface_series.archive(archive);
    }

  private:
    const MPI_Comm                communicator;
    const bool                    in_background;
    static constexpr unsigned int none         = static_cast<unsigned int>(-1);
    unsigned int                  last_step    = none;
    double                        last_time    = 0.;
    bool                          with_surface = false;

    FieldSeries         volume_series, surface_series;
    VolumePatches<dim>  volume;
    SurfacePatches<dim> contact_surface;
    /** Those of this process and of the last step; behind what they read, as it waits for them. */
    std::future<void> pieces;
  };
} // namespace signorini

#endif
