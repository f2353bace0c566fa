// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/residual_parts.h>

namespace signorini
{
  template <int dim>
  void add_stress_jumps(const StressVectors<dim> &stress,
                        const ResidualWeights    &weights,
                        dealii::Vector<double>   &squares)
  {
    const auto &cells = stress.mesh.cells;
    for (const InnerFace<dim> &face : stress.mesh.inner_faces)
      {
        const FaceStress<dim> &mine = stress.of_face(face.cells[0], face.faces[0]);
        FaceStress<dim>        part;
        if (face.subface >= 0)
          part = stress.of_subface(face.cells[1], face.faces[1], face.subface);
        const FaceStress<dim> &theirs =
          face.subface >= 0 ? part : stress.of_face(face.cells[1], face.faces[1]);
        double square = 0.;
        for (unsigned int q = 0; q < face.points.size(); ++q)
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double jump = mine.vector[c][q] + theirs.vector[c][face.points[q]];
              square += jump * jump * mine.area[q];
            }
        const Material &material =
          stress.mesh.discretization.mesh().bodies()[cells[face.cells[0]].body].material;
        const double half = 0.5 * weights.face(material, face.size) * square;
        for (const unsigned int cell : face.cells)
          if (cells[cell].owned)
            squares(cells[cell].index) += half;
      }
  }


  template void
  add_stress_jumps(const StressVectors<2> &, const ResidualWeights &, dealii::Vector<double> &);
  template void
  add_stress_jumps(const StressVectors<3> &, const ResidualWeights &, dealii::Vector<double> &);
} // namespace signorini
