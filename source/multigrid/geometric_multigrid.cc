// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/linear_algebra/flush_denormals.h>
#include <signorini/multigrid/geometric_multigrid.h>
#include <signorini/surfaces/contact_frame.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    /** Radians: directions that differ by less are good enough for a preconditioner. */
    constexpr double old_direction = 0.05;
    /** The same for weights of partners: the sum of changes. */
    constexpr double old_partners = 0.5;

    /** A power of two that makes the largest diagonal entry one or a little less. */
    template <int dim>
    double scale_of(const ElasticMatrices<dim> &matrices, const MatrixSum &sum)
    {
      const NodePattern &pattern = matrices.pattern;
      double             largest = 0.;
      for (unsigned int node = 0; node < pattern.n_owned; ++node)
        if (!pattern.is_empty(node))
          largest =
            std::max(largest, matrices.combined_block(node, pattern.row_start[node], sum)[0]);
      largest = dealii::Utilities::MPI::max(largest, pattern.partitioner->get_mpi_communicator());
      return std::exp2(-std::ceil(std::log2(largest)));
    }
  } // namespace


  template <int dim, typename Number>
  GeometricMultigrid<dim, Number>::GeometricMultigrid(
    std::shared_ptr<const LevelHierarchy<dim>> levels_of_mesh,
    const ContactCoordinates<dim>             &coordinates,
    const MatrixSum                           &sum)
    : shared_hierarchy(std::move(levels_of_mesh))
    , hierarchy(*shared_hierarchy)
    , coordinates(coordinates)
    , scale(scale_of(hierarchy.matrices(hierarchy.n_levels() - 1), sum))
    , sum(sum)
    , correction(std::make_unique<HeldCorrection<dim, Number>>(hierarchy, coordinates, sum, scale))
    , free_space(coordinates, hierarchy.matrices(hierarchy.n_levels() - 1).pattern)
    , coarsest(hierarchy.matrices(0), sum, scale)
    , known_frames(coordinates.node_frames())
    , known_nodes(coordinates.coupling().changes() ? coordinates.surface_nodes()
                                                   : std::vector<ContactNode<dim>>())
    , cartesian(hierarchy.matrices(hierarchy.n_levels() - 1).pattern.partitioner)
  {
    levels.reserve(hierarchy.n_levels());
    for (unsigned int level = 0; level < hierarchy.n_levels(); ++level)
      {
        levels.push_back(
          {LevelMatrix<dim, Number>(hierarchy.matrices(level), smoothed(level), sum, scale),
           nullptr,
           hierarchy.template make_vector<Number>(level),
           hierarchy.template make_vector<Number>(level),
           hierarchy.template make_vector<Number>(level)});
        if (level > 0)
          levels.back().smoother = std::make_unique<LevelSmoother<dim, Number>>(
            levels.back().matrix, is_finest(level) ? &free_space : nullptr);
      }
  }


  template <int dim, typename Number>
  std::vector<char> GeometricMultigrid<dim, Number>::smoothed(const unsigned int level) const
  {
    if (level == 0)
      return std::vector<char>(hierarchy.matrices(0).pattern.n_owned, 0);
    std::vector<char> result = hierarchy.smoothed(level);
    if (is_finest(level))
      {
        // Nodes that carry others along are smoothed together with them.
        for (const unsigned int entry : coordinates.relative_entries())
          result[entry / dim] = 1;
        for (const unsigned int node : coordinates.coupling().owned_partners())
          result[node] = 1;
      }
    return result;
  }


  template <int dim, typename Number>
  void GeometricMultigrid<dim, Number>::set_mask(const Mask &new_mask)
  {
    const bool is_old = have_turned(new_mask);
    if (!is_old
        && dealii::Utilities::MPI::max(static_cast<unsigned int>(mask != new_mask),
                                       cartesian.get_mpi_communicator())
             == 0)
      return;
    if (is_old)
      {
        correction =
          std::make_unique<HeldCorrection<dim, Number>>(hierarchy, coordinates, sum, scale);
        free_space =
          FreeSpace<dim, Number>(coordinates, hierarchy.matrices(hierarchy.n_levels() - 1).pattern);
        known_frames = coordinates.node_frames();
        if (coordinates.coupling().changes())
          known_nodes = coordinates.surface_nodes();
      }
    mask = new_mask;
    free_space.set_mask(mask);
    correction->set_mask(mask);
    levels.back().smoother->update_free_space();
    for (unsigned int level = 1; level + 1 < levels.size(); ++level)
      levels[level].smoother->set_correction(*correction, level);
    coarsest.set_correction(*correction);
  }


  template <int dim, typename Number>
  bool GeometricMultigrid<dim, Number>::have_turned(const Mask &new_mask) const
  {
    if (coordinates.n_turns() == 0)
      return false;
    bool any = false;
    for (const auto &[node, frame] : coordinates.node_frames())
      for (unsigned int row = 0; row < dim; ++row)
        if (new_mask[dim * node + row])
          {
            // Of an oblique frame all rows count: with a wrong tangent no direction may be left in
            // which a free entry could move.
            const auto        &known  = known_frames.at(node);
            const bool         single = orthonormal_frame<dim>(frame) == frame;
            const unsigned int end    = single ? dim * (row + 1) : dim * dim;
            for (unsigned int i = single ? dim * row : 0; i < end; ++i)
              any = any || std::abs(frame[i] - known[i]) > old_direction;
          }
    for (std::size_t k = 0; k < known_nodes.size(); ++k)
      any = any || has_other_partners(k, new_mask);
    return dealii::Utilities::MPI::max(static_cast<unsigned int>(any),
                                       cartesian.get_mpi_communicator())
           > 0;
  }


  template <int dim, typename Number>
  bool GeometricMultigrid<dim, Number>::has_other_partners(const std::size_t k,
                                                           const Mask       &new_mask) const
  {
    const ContactNode<dim> &node = coordinates.surface_nodes()[k];
    if (!node.relative[node.row] || !new_mask[node.entry()])
      return false;
    std::map<dealii::types::global_dof_index, double> change;
    for (const auto &[partner, weight] : node.partners)
      change[partner] += weight;
    for (const auto &[partner, weight] : known_nodes[k].partners)
      change[partner] -= weight;
    double sum_of_changes = 0.;
    for (const auto &[partner, weight] : change)
      sum_of_changes += std::abs(weight);
    return sum_of_changes > old_partners;
  }


  template <int dim, typename Number>
  void GeometricMultigrid<dim, Number>::vmult(Vector &destination, const Vector &source) const
  {
    Level &finest = levels.back();
    cartesian.copy_locally_owned_data_from(source);
    keep_free(cartesian);
    coordinates.force_to_cartesian(cartesian);
    const double       size    = cartesian.linfty_norm(); // keeps single precision in range
    const double       factor  = size > 0. ? 1. / size : 0.;
    const unsigned int n_nodes = finest.matrix.n_owned();
    for (unsigned int node = 0; node < n_nodes; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        finest.residual[4 * node + c] = factor * cartesian.local_element(dim * node + c);
    {
      const FlushDenormals flush;
      cycle(levels.size() - 1);
    }
    for (unsigned int node = 0; node < n_nodes; ++node)
      for (unsigned int c = 0; c < dim; ++c)
        cartesian.local_element(dim * node + c) = size * scale * finest.solution[4 * node + c];
    coordinates.displacement_to_contact(cartesian);
    keep_free(cartesian);
    destination.copy_locally_owned_data_from(cartesian);
  }


  template <int dim, typename Number>
  void GeometricMultigrid<dim, Number>::cycle(const unsigned int level) const
  {
    Level &here = levels[level];
    if (level == 0)
      {
        coarsest.solve(here.residual, here.solution);
        return;
      }
    Level &below = levels[level - 1];
    here.smoother->start(here.residual, here.solution);
    if (is_finest(level))
      free_space.project_force(here.residual);
    hierarchy.restrict_to_coarser(level, here.residual, below.residual);
    cycle(level - 1);
    hierarchy.prolongate(level, below.solution, here.coarse_correction);
    if (is_finest(level))
      free_space.project(here.coarse_correction);
    for (unsigned int i = 0; i < here.solution.size(); ++i)
      here.solution[i] += here.coarse_correction[i];
    here.smoother->subtract_product(here.coarse_correction, here.residual);
    here.smoother->finish(here.residual, here.solution);
  }


  template <int dim, typename Number>
  void GeometricMultigrid<dim, Number>::keep_free(Vector &vector) const
  {
    for (unsigned int i = 0; i < mask.size(); ++i)
      if (mask[i])
        vector.local_element(i) = 0.;
  }


  template <int dim>
  std::unique_ptr<MaskedPreconditioner>
  make_geometric_multigrid(std::shared_ptr<const LevelHierarchy<dim>> hierarchy,
                           const ContactCoordinates<dim>             &coordinates,
                           const MatrixSum                           &sum,
                           const bool                                 in_double_precision)
  {
    if (in_double_precision)
      return std::make_unique<GeometricMultigrid<dim, double>>(
        std::move(hierarchy), coordinates, sum);
    return std::make_unique<GeometricMultigrid<dim, float>>(std::move(hierarchy), coordinates, sum);
  }


#define INSTANTIATE(dim)                                                                           \
  template std::unique_ptr<MaskedPreconditioner> make_geometric_multigrid(                         \
    std::shared_ptr<const LevelHierarchy<dim>>,                                                    \
    const ContactCoordinates<dim> &,                                                               \
    const MatrixSum &,                                                                             \
    bool);
  template class GeometricMultigrid<2, float>;
  template class GeometricMultigrid<2, double>;
  template class GeometricMultigrid<3, float>;
  template class GeometricMultigrid<3, double>;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
