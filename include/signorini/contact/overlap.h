// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_contact_overlap_h
#define signorini_contact_overlap_h

#include <signorini/discretization/mesh.h>
#include <signorini/model/contact_description.h>

#include <optional>

namespace signorini
{
  /**
   * A point that lies well inside both bodies, if the coarse meshes show one: a vertex or a centre
   * of a coarse cell of one body within a coarse cell of the other. It finds the overlaps that are
   * too deep for the gap between surfaces to see. The coarse mesh is known to every process, so
   * that all come to the same result without communication. The time is that of a search in a tree
   * for each vertex and centre in the common part of the boxes around the bodies.
   */
  template <int dim>
  std::optional<dealii::Point<dim>>
  find_deep_overlap(const Mesh<dim> &mesh, unsigned int body, unsigned int other_body);

  /**
   * Refuse pairs of bodies that overlap at the start. What it looks at is the same on every mesh of
   * a run: once is enough. @throws UserError
   */
  template <int dim>
  void check_that_bodies_are_apart(const Mesh<dim>                    &mesh,
                                   const std::vector<PairDescription> &pairs);
} // namespace signorini

#endif
