// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_finite_elements_stress_vectors_h
#define signorini_finite_elements_stress_vectors_h

#include <signorini/finite_elements/cell_strain.h>

namespace signorini
{
  /** At the Gauss points of a face; n points out of the cell. */
  template <int dim>
  struct FaceStress
  {
    FourVectors<dim> vector;  ///< sigma n
    FourNumbers      tension; ///< n.sigma n
    FourNumbers area; ///< weights of the integral over the face; zero in lanes that repeat a point
  };

  /**
   * Strains of a displacement in all local cells, and the stress vectors on all of their faces,
   * computed once for both sides. 1.5 kB per cell in 3d with a map of second degree.
   */
  template <int dim>
  class StressVectors
  {
  public:
    /** @param displacement with values at hanging nodes */
    StressVectors(const CellNeighbors<dim> &mesh, const Vector &displacement);

    /** Of a local cell, by its number. */
    const CellStrain<dim> &strain(const unsigned int cell) const { return strains[cell]; }

    /** Of a face of a local cell. */
    const FaceStress<dim> &of_face(const unsigned int cell, const unsigned int face) const
    {
      return stresses[GaussTables<dim>::n_faces * cell + face];
    }

    /** At the points of a part of the face; `area` is that of the whole face. */
    FaceStress<dim> of_subface(unsigned int cell, unsigned int face, unsigned int subface) const;

    const CellNeighbors<dim> &mesh;

  private:
    std::vector<CellStrain<dim>> strains;
    std::vector<FaceStress<dim>> stresses;
  };
} // namespace signorini

#endif
