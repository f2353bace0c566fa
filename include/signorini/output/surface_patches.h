// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_surface_patches_h
#define signorini_output_surface_patches_h

#include <signorini/contact/contact_surface.h>
#include <signorini/time/state.h>

#include <deal.II/base/data_out_base.h>

namespace signorini
{
  /**
   * The faces of the slave surfaces with what happens on them, as a series of their own. Per vertex
   *
   * - displacement, velocity
   * - CPRESS: contact pressure -(r.nu)/D >= 0, the nodal force over the area of the node
   * - COPEN: gap g - u.nu along the normal of the obstacle, 0 in contact
   * - CSTATUS: 1 where the pressure is positive, else 0; with friction 2 where the node sticks, too
   *
   * and, if the scene has friction,
   *
   * - CSHEAR: tangential stress on the slave, the tangential nodal force over the area (a vector)
   * - CSLIP: slip relative to the other side since the start (a vector)
   * - CSLIP_INCREMENT: its part in the last step
   *
   * most of them under the names that Abaqus uses. Vertices of a slave surface that can never touch
   * (on the far side of a ball, or prescribed) have no gap; they show the largest COPEN of the
   * contact nodes, so that they look open without spoiling the scale of colours.
   */
  template <int dim>
  class SurfacePatches : public dealii::DataOutInterface<dim - 1, dim>
  {
  public:
    using Patch = dealii::DataOutBase::Patch<dim - 1, dim>;

    /**
     * What is there afterwards is free of mesh and state: it can be written while they go on.
     * Collective. @param displacement with ghosts and hanging nodes, like @p velocity
     */
    void build(const Discretization<dim> &discretization,
               const ContactSurface<dim> &surface,
               const State               &state,
               const Vector              &displacement,
               const Vector              &velocity);

    const std::vector<Patch> &get_patches() const override { return patches; }
    std::vector<std::string>  get_dataset_names() const override;

  private:
    bool               with_friction = false;
    std::vector<Patch> patches;

    std::vector<std::tuple<unsigned int,
                           unsigned int,
                           std::string,
                           dealii::DataComponentInterpretation::DataComponentInterpretation>>
    get_nonscalar_data_ranges() const override;
  };
} // namespace signorini

#endif
