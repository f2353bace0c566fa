// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/finite_elements/stress_vectors.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    template <int dim>
    FaceStress<dim> stress_at_points(const PointTable<dim> &polynomials,
                                     const PointTable<dim> &map_polynomials,
                                     const unsigned int     face,
                                     const CellStrain<dim> &strain)
    {
      const Material         &material    = strain.material;
      const FourMatrices<dim> jacobian    = strain.jacobian(map_polynomials);
      const FourMatrices<dim> cofactor    = cofactors(jacobian);
      const FourNumbers       volume      = determinant<dim>(jacobian, cofactor);
      const FourMatrices<dim> gradient    = strain.gradient(polynomials, cofactor); // times volume
      FourVectors<dim>        area_vector = cofactor[face / 2];
      FourNumbers             divergence{}, square{}, area;
      for (unsigned int c = 0; c < dim; ++c)
        {
          area_vector[c] *= face % 2 == 1 ? 1. : -1.;
          divergence += gradient[c][c];
          square += area_vector[c] * area_vector[c];
        }
      for (unsigned int q = 0; q < PointTable<dim>::n_points; ++q)
        area[q] = std::sqrt(square[q]);

      FaceStress<dim>   result;
      const FourNumbers scale = 1. / (volume * area);
      result.tension          = FourNumbers{};
      for (unsigned int i = 0; i < dim; ++i)
        {
          FourNumbers sum = material.lambda() * divergence * area_vector[i];
          for (unsigned int j = 0; j < dim; ++j)
            sum += material.mu() * (gradient[i][j] + gradient[j][i]) * area_vector[j];
          result.vector[i] = sum * scale;
          result.tension += result.vector[i] * area_vector[i] / area;
        }
      for (unsigned int q = 0; q < PointTable<dim>::n_points; ++q)
        result.area[q] =
          q < GaussTables<dim>::n_face_points ? area[q] / GaussTables<dim>::n_face_points : 0.;
      return result;
    }


    template <int dim>
    const GaussTables<dim> &tables_of_map(const CellNeighbors<dim> &mesh)
    {
      return GaussTables<dim>::of_degree(mesh.discretization.mesh().mapping().get_degree());
    }
  } // namespace


  template <int dim>
  StressVectors<dim>::StressVectors(const CellNeighbors<dim> &mesh, const Vector &displacement)
    : mesh(mesh)
    , stresses(mesh.cells.size() * GaussTables<dim>::n_faces)
  {
    const auto      &tables    = GaussTables<dim>::of_degree(1);
    const auto      &of_map    = tables_of_map(mesh);
    FaceStress<dim> *next_face = stresses.data();
    strains.reserve(mesh.cells.size());
    for (const LocalCell<dim> &cell : mesh.cells)
      {
        const CellStrain<dim> &strain = strains.emplace_back(mesh, cell, displacement);
        for (unsigned int face = 0; face < GaussTables<dim>::n_faces; ++face)
          *next_face++ =
            stress_at_points<dim>(tables.faces[face], of_map.faces[face], face, strain);
      }
  }


  template <int dim>
  FaceStress<dim> StressVectors<dim>::of_subface(const unsigned int cell,
                                                 const unsigned int face,
                                                 const unsigned int subface) const
  {
    const unsigned int table = GaussTables<dim>::n_subfaces * face + subface;
    return stress_at_points<dim>(GaussTables<dim>::of_degree(1).subfaces[table],
                                 tables_of_map(mesh).subfaces[table],
                                 face,
                                 strains[cell]);
  }


  template class StressVectors<2>;
  template class StressVectors<3>;
} // namespace signorini
