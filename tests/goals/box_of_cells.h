// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_goals_box_of_cells_h
#define signorini_tests_goals_box_of_cells_h

#include "../contact/contact_scene.h"

#include <functional>

namespace signorini::tests
{
  /** A box of 16 x 16 cells of level 3. */
  struct Box
  {
    Box()
      : problem(contact_scene<2>(finer(box<2>()), {floor_at<2>(0.)}))
      , mesh(problem.discretization.mesh())
    {
    }

    static BodyDescription<2> finer(BodyDescription<2> body)
    {
      body.refinements = 3;
      return body;
    }

    dealii::Vector<double>
    indicator(const std::function<double(const dealii::Point<2> &)> &value) const
    {
      dealii::Vector<double> result(mesh.triangulation().n_active_cells());
      for (const auto &cell : mesh.active_cells())
        if (cell->is_locally_owned())
          result(cell->active_cell_index()) = value(cell->center());
      return result;
    }

    ContactProblem<2> problem;
    const Mesh<2>    &mesh;
  };
} // namespace signorini::tests

#endif
