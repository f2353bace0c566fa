// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_setup_setup_output_h
#define signorini_setup_setup_output_h

#include <signorini/discretization/discretization.h>
#include <signorini/model/contact_description.h>
#include <signorini/obstacles/moved_obstacle.h>

#include <deal.II/base/data_out_base.h>

namespace signorini
{
  /**
   * The surfaces of all bodies before the first step, as lines or quadrilaterals, with values per
   * face: body (its index), boundary_id, contact (0: in no pair, 1: of a slave, 2: of a master),
   * support (1 where `Dirichlet` prescribes a displacement), traction (1 where there is one).
   */
  template <int dim>
  class SetupPatches : public dealii::DataOutInterface<dim - 1, dim>
  {
  public:
    using Patch = dealii::DataOutBase::Patch<dim - 1, dim>;

    /** The faces of the cells of this process. */
    SetupPatches(const Discretization<dim>          &discretization,
                 const std::vector<PairDescription> &pairs);

    const std::vector<Patch> &get_patches() const override { return patches; }
    std::vector<std::string>  get_dataset_names() const override;

  private:
    std::vector<Patch> patches;
  };

  /**
   * Write `setup.pvd` with the bodies, `setup_obstacles.vtu` with all obstacles where they are at
   * the start, and the picture `setup.svg`, see SetupPicture. Collective.
   * @return whether there is a picture
   * @throws RunError on all processes if a file cannot be written
   */
  template <int dim>
  bool write_setup(const std::string                     &directory,
                   const Discretization<dim>             &discretization,
                   const std::vector<PairDescription>    &pairs,
                   const std::vector<NamedObstacle<dim>> &obstacles);
} // namespace signorini

#endif
