// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/cell_matrices.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/mapping_q.h>

#include <boost/functional/hash.hpp>
#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /**
     * To compute a matrix takes hardly longer than to fetch it from main memory, so that many
     * shapes are not worth keeping.
     */
    constexpr unsigned int most_shapes = 64;


    /** Whether the cell, its faces and its edges are all without manifold. */
    template <int dim>
    bool is_flat(const typename Triangulation<dim>::cell_iterator &cell)
    {
      bool flat = cell->manifold_id() == numbers::flat_manifold_id;
      for (const unsigned int f : cell->face_indices())
        flat = flat && cell->face(f)->manifold_id() == numbers::flat_manifold_id;
      for (const unsigned int l : cell->line_indices())
        flat = flat && cell->line(l)->manifold_id() == numbers::flat_manifold_id;
      return flat;
    }

    /** Integrals over a cell of products of two shape functions, and of their gradients. */
    template <int dim>
    class IntegratedProducts
    {
    public:
      using Block = typename CellMatrix<dim>::Block;

      explicit IntegratedProducts(const FEValues<dim> &fe_values)
      {
        const unsigned int                                n_points = fe_values.n_quadrature_points;
        Eigen::Matrix<double, n_vertices, Eigen::Dynamic> value(n_vertices, n_points);
        Eigen::Matrix<double, dim * n_vertices, Eigen::Dynamic> gradient(dim * n_vertices,
                                                                         n_points);
        Eigen::VectorXd                                         weight(n_points);
        for (unsigned int q = 0; q < n_points; ++q)
          {
            weight(q) = fe_values.JxW(q);
            for (unsigned int a = 0; a < n_vertices; ++a)
              {
                value(a, q) = fe_values.shape_value(a, q);
                for (unsigned int c = 0; c < dim; ++c)
                  gradient(dim * a + c, q) = fe_values.shape_grad(a, q)[c];
              }
          }
        values.noalias()    = value * (value * weight.asDiagonal()).transpose();
        gradients.noalias() = gradient * (gradient * weight.asDiagonal()).transpose();
      }

      double of_values(const unsigned int a, const unsigned int b) const { return values(a, b); }

      /** Of the derivatives by c of function a and by d of function b, column by column. */
      Block of_gradients(const unsigned int a, const unsigned int b) const
      {
        Block block;
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int c = 0; c < dim; ++c)
            block[dim * d + c] = gradients(dim * a + c, dim * b + d);
        return block;
      }

    private:
      static constexpr unsigned int n_vertices = CellMatrix<dim>::n_vertices;

      Eigen::Matrix<double, n_vertices, n_vertices>             values;
      Eigen::Matrix<double, dim * n_vertices, dim * n_vertices> gradients;
    };


    /** Of two vertices: all of it is made of the products of the derivatives. */
    template <int dim>
    typename CellMatrix<dim>::Block stiffness_block(const Material                        &material,
                                                    const typename CellMatrix<dim>::Block &products)
    {
      double trace = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        trace += products[dim * c + c];
      typename CellMatrix<dim>::Block block;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int c = 0; c < dim; ++c)
          block[dim * d + c] = material.lambda() * products[dim * d + c]
                               + material.mu() * products[dim * c + d]
                               + (c == d ? material.mu() * trace : 0.);
      return block;
    }
  } // namespace


  template <int dim>
  CellMatrices<dim>::CellMatrices(const std::vector<BodyDescription<dim>> &bodies,
                                  const Mapping<dim>                      &mapping,
                                  const unsigned int                       n_quadrature_points,
                                  const std::size_t                        capacity)
    : mapping(mapping)
    , all_straight([&mapping] {
      const auto *polynomial = dynamic_cast<const MappingQ<dim> *>(&mapping);
      return polynomial != nullptr && polynomial->get_degree() == 1;
    }())
    , capacity(capacity)
    , scalar_fe(1)
    , fe_values(mapping,
                scalar_fe,
                QGauss<dim>(n_quadrature_points),
                update_values | update_gradients | update_JxW_values)
    , centre_values(mapping, scalar_fe, QMidpoint<dim>(), update_jacobians)
  {
    for (const auto &body : bodies)
      by_body.push_back({body.material, body.element});
  }


  template <int dim>
  ScaledCellMatrix<dim> CellMatrices<dim>::of(const Cell &cell) const
  {
    if (all_straight)
      return of_straight(cell);
    const CellId id = cell->id();
    return is_straight(cell, id) ? of_straight(cell) : of_curved(cell, id);
  }


  template <int dim>
  const FEValues<dim> &CellMatrices<dim>::values_on(const Cell &cell) const
  {
    fe_values.reinit(cell);
    return fe_values;
  }


  template <int dim>
  void CellMatrices<dim>::forget_unused()
  {
    // Which of many cells of one shape was computed must not depend on earlier meshes; nor may the
    // number of buckets, by which shapes make room for each other.
    decltype(shapes)().swap(shapes);
    if (curved_cells.size() > capacity / 2)
      for (auto entry = curved_cells.begin(); entry != curved_cells.end();)
        entry = entry->second.last_mesh == mesh ? std::next(entry) : curved_cells.erase(entry);
    ++mesh;
    latest = nullptr;
  }


  template <int dim>
  bool CellMatrices<dim>::is_straight(const Cell &cell, const CellId &id) const
  {
    // A cell may be a part of the map of a cell of the coarse mesh.
    const auto [known, is_new] = straight_coarse_cells.emplace(id.get_coarse_cell_id(), false);
    if (is_new)
      {
        Cell ancestor = cell;
        while (ancestor->level() > 0)
          ancestor = ancestor->parent();
        known->second = is_flat<dim>(ancestor);
      }
    return known->second;
  }


  template <int dim>
  ScaledCellMatrix<dim> CellMatrices<dim>::of_straight(const Cell &cell) const
  {
    const Shape shape(cell, mapping);
    const auto  scaled = [this, &shape](std::pair<Shape, Kept> &found) {
      found.second.last_mesh = mesh;
      const double ratio     = shape.size / found.first.size;
      return ScaledCellMatrix<dim>{&found.second.matrix,
                                   std::pow(ratio, dim),
                                   dim == 2 ? 1. : ratio,
                                   std::pow(ratio, dim - 1)};
    };
    if (latest != nullptr && shape.is_same(latest->first))
      return scaled(*latest);
    const std::size_t hash       = shape.hash();
    const auto        candidates = shapes.equal_range(hash);
    for (auto candidate = candidates.first; candidate != candidates.second; ++candidate)
      if (shape.is_same(candidate->second.first))
        return scaled(*(latest = &candidate->second));

    // Where all cells differ, a new shape takes the place of another one: that stays in the cache
    // of the processor.
    if (shapes.size() >= most_shapes)
      shapes.erase(shapes.begin());
    latest = &shapes.emplace(hash, std::pair<Shape, Kept>(shape, {}))->second;
    compute(cell, latest->second.matrix);
    return scaled(*latest);
  }


  template <int dim>
  ScaledCellMatrix<dim> CellMatrices<dim>::of_curved(const Cell &cell, const CellId &id) const
  {
    auto found = curved_cells.find(id);
    if (found == curved_cells.end() && curved_cells.size() >= capacity)
      {
        compute(cell, not_kept);
        return {&not_kept, 1., 1., 1.};
      }
    if (found == curved_cells.end())
      {
        found = curved_cells.emplace(id, Kept()).first;
        compute(cell, found->second.matrix);
      }
    found->second.last_mesh = mesh;
    return {&found->second.matrix, 1., 1., 1.};
  }


  template <int dim>
  void CellMatrices<dim>::compute(const Cell &cell, CellMatrix<dim> &result) const
  {
    const Material &material = by_body[cell->material_id()].material;
    fe_values.reinit(cell);
    const IntegratedProducts<dim> integrals(fe_values);
    for (unsigned int a = 0; a < n_vertices; ++a)
      for (unsigned int b = a; b < n_vertices; ++b)
        {
          const unsigned int k = CellMatrix<dim>::pair(a, b);
          result.mass[k]       = material.density * integrals.of_values(a, b);
          result.stiffness[k]  = stiffness_block<dim>(material, integrals.of_gradients(a, b));
        }
    result.modes = CellModes<dim>();
    if (const auto &modes = strain_modes<dim>(by_body[cell->material_id()].element); !modes.empty())
      {
        centre_values.reinit(cell);
        const Tensor<2, dim> jacobian(centre_values.jacobian(0));
        result.modes = CellModes<dim>(
          modes, fe_values, determinant(jacobian) * invert(jacobian), material, result);
      }
  }


  template <int dim>
  CellMatrices<dim>::Shape::Shape(const Cell &cell, const Mapping<dim> &mapping)
    : material(cell->material_id())
  {
    const auto points  = mapping.get_vertices(cell);
    double     largest = 0.;
    for (unsigned int c = 0; c < dim; ++c)
      largest = std::max({largest, std::abs(points.front()[c]), std::abs(points.back()[c])});
    size      = points.front().distance(points.back());
    tolerance = 1e-14 + 8. * std::numeric_limits<double>::epsilon() * largest / size;
    for (unsigned int v = 1; v < n_vertices; ++v)
      for (unsigned int c = 0; c < dim; ++c)
        vertices[dim * (v - 1) + c] = (points[v][c] - points[0][c]) / size;
  }


  template <int dim>
  bool CellMatrices<dim>::Shape::is_same(const Shape &other) const
  {
    double difference = 0.;
    for (unsigned int i = 0; i < vertices.size(); ++i)
      difference = std::max(difference, std::abs(vertices[i] - other.vertices[i]));
    return material == other.material && difference <= std::max(tolerance, other.tolerance);
  }


  template <int dim>
  std::size_t CellMatrices<dim>::Shape::hash() const
  {
    // Much coarser than the tolerance. The odd offset keeps simple fractions away from where
    // rounding jumps; where it does jump, a shape is kept twice, and nothing else happens.
    std::size_t seed = material;
    for (const double coordinate : vertices)
      boost::hash_combine(seed, std::llround(1e6 * coordinate + 0.3719));
    return seed;
  }


  template class CellMatrices<2>;
  template class CellMatrices<3>;
} // namespace signorini
