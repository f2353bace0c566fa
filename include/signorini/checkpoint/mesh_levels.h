// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_checkpoint_mesh_levels_h
#define signorini_checkpoint_mesh_levels_h

#include <signorini/discretization/mesh.h>

namespace signorini
{
  /**
   * The mesh as the levels of its active cells along the space-filling curve, a byte each: with the
   * coarse mesh of the scene they say all. p4est writes such files, too, but ends the program where
   * the disk is full. Collective. @throws RunError see write_parts()
   */
  template <int dim>
  void write_levels(const Mesh<dim> &mesh, const std::string &path);

  /**
   * Refine and coarsen a mesh of the same scene until its cells are those of the file. For this
   * time each process knows the whole list, a byte for each cell. Collective.
   * @throws RunError on all processes if the file belongs to another mesh
   */
  template <int dim>
  void restore_levels(Mesh<dim> &mesh, const std::string &path);
} // namespace signorini

#endif
