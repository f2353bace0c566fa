// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_volume_patches_h
#define signorini_output_volume_patches_h

#include <signorini/output/mean_strain.h>

#include <deal.II/base/data_out_base.h>

#include <boost/signals2/connection.hpp>

namespace signorini
{
  /**
   * The cells of this process with what happens in them, as a series of its own: displacement and
   * velocity (vertices) and, the same at all vertices of a cell, body, von_mises, stress_xx, ...,
   * strain_xx, ..., subdomain and, if there are any, error_indicator.
   *
   * deal.II's DataOut asks its finite elements anew at every vertex of every moment. Here vertices
   * and mean gradients stay until the mesh changes, and a moment is one pass over its values. What
   * is there when build() returns is free of mesh and state: it can be written while they go on.
   */
  template <int dim>
  class VolumePatches : public dealii::DataOutInterface<dim, dim>
  {
  public:
    using Patch = dealii::DataOutBase::Patch<dim, dim>;

    VolumePatches() = default;

    /** The triangulation knows the address of the object. */
    VolumePatches(const VolumePatches &)            = delete;
    VolumePatches &operator=(const VolumePatches &) = delete;

    /**
     * Not collective. @param displacement, velocity with ghosts and hanging nodes
     * @param indicators of the error by active cell, empty for none
     */
    void build(const Discretization<dim>    &discretization,
               const Vector                 &displacement,
               const Vector                 &velocity,
               const dealii::Vector<double> &indicators);

    const std::vector<Patch> &get_patches() const override { return patches; }
    std::vector<std::string>  get_dataset_names() const override;

  private:
    std::vector<Patch>               patches;
    std::unique_ptr<MeanStrain<dim>> mean_strain;               ///< none: the mesh has changed
    const void                      *triangulation   = nullptr; ///< to which it belongs
    bool                             with_indicators = false;

    boost::signals2::scoped_connection change_of_mesh;

    /** What stays as long as the mesh. */
    void use_mesh(const Discretization<dim> &discretization);

    std::vector<std::tuple<unsigned int,
                           unsigned int,
                           std::string,
                           dealii::DataComponentInterpretation::DataComponentInterpretation>>
    get_nonscalar_data_ranges() const override;
  };
} // namespace signorini

#endif
