// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/mesh_geometry.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Lets others see the support points that manifolds give to a cell. */
    template <int dim>
    class ManifoldPoints : public MappingQ<dim>
    {
    public:
      using MappingQ<dim>::MappingQ;
      using MappingQ<dim>::compute_mapping_support_points;
    };


    std::vector<std::vector<std::pair<unsigned int, double>>>
    sparse_rows(const FullMatrix<double> &matrix)
    {
      std::vector<std::vector<std::pair<unsigned int, double>>> rows(matrix.m());
      for (unsigned int i = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j < matrix.n(); ++j)
          if (matrix(i, j) != 0.)
            rows[i].emplace_back(j, matrix(i, j));
      return rows;
    }
  } // namespace


  template <int dim>
  MeshGeometry<dim>::MeshGeometry(const unsigned int degree, std::vector<unsigned int> base_levels)
    : base_levels(std::move(base_levels))
    , polynomials(degree)
    , cached_mapping(degree)
  {
    for (unsigned int child = 0; child < GeometryInfo<dim>::max_children_per_cell; ++child)
      parts.push_back(sparse_rows(polynomials.get_prolongation_matrix(child)));
  }


  template <int dim>
  void MeshGeometry<dim>::update(parallel::distributed::Triangulation<dim> &triangulation)
  {
    const ManifoldPoints<dim> manifold_points(polynomials.degree);
    if (!has_base())
      {
        if (!is_straight())
          cached_mapping.initialize(manifold_points, triangulation);
        return;
      }

    std::vector<std::vector<Points>> points(triangulation.n_levels());
    for (unsigned int level = 0; level < points.size(); ++level)
      {
        points[level].resize(triangulation.n_raw_cells(level));
        for (const auto &cell : triangulation.cell_iterators_on_level(level))
          {
            Points &mine = points[level][cell->index()];
            if (level <= base_levels[cell->material_id()])
              {
                const auto known = base_points.find(cell->id());
                mine =
                  known != base_points.end()
                    ? known->second
                    : base_points
                        .emplace(cell->id(), manifold_points.compute_mapping_support_points(cell))
                        .first->second;
                continue;
              }
            const auto   &parent = cell->parent();
            const Points &theirs = points[level - 1][parent->index()];
            unsigned int  child  = 0;
            while (parent->child_index(child) != cell->index())
              ++child;
            mine.resize(theirs.size());
            for (unsigned int i = 0; i < mine.size(); ++i)
              for (const auto &[j, weight] : parts[child][i])
                mine[i] += weight * theirs[j];
            for (const unsigned int v : cell->vertex_indices())
              cell->vertex(v) = mine[v];
          }
      }
    if (!is_straight())
      cached_mapping.initialize(triangulation, [&](const auto &cell) {
        return std::move(points[cell->level()][cell->index()]);
      });
  }


  template class MeshGeometry<2>;
  template class MeshGeometry<3>;
} // namespace signorini
