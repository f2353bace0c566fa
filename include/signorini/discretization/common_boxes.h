// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_common_boxes_h
#define signorini_discretization_common_boxes_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>

#include <vector>

namespace signorini
{
  /** Boxes, each around points that are spread over the processes. */
  template <int dim>
  class CommonBoxes
  {
  public:
    explicit CommonBoxes(unsigned int n_boxes = 1);

    /** Let a box contain a point of this process. */
    void add(const dealii::Point<dim> &point, unsigned int box = 0);

    /** Around the points of all processes; the same on all. Collective. */
    std::vector<dealii::BoundingBox<dim>> around_all(MPI_Comm communicator) const;

  private:
    std::vector<double> ends; ///< of each box: the lower corner, and the upper one times -1
  };
} // namespace signorini

#endif
