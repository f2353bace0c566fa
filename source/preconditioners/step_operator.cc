// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/preconditioners/step_operator.h>

#include <Eigen/Dense>

#include <algorithm>

namespace signorini
{
  template <int dim>
  StepOperator<dim>::StepOperator(const ElasticMatrices<dim>    &matrices,
                                  const ContactCoordinates<dim> &coordinates,
                                  const MatrixSum               &sum)
    : matrices(matrices)
    , coordinates(coordinates)
    , sum(sum)
    , cartesian(matrices.pattern.partitioner)
  {
    Assert(sum.is_positive(), dealii::ExcMessage("The matrix of a step is positive definite."));
  }


  template <int dim>
  void StepOperator<dim>::vmult(Vector &destination, const Vector &source) const
  {
    cartesian.copy_locally_owned_data_from(source);
    coordinates.displacement_to_cartesian(cartesian);
    matrices.apply(destination, cartesian, sum);
    coordinates.force_to_contact(destination);
  }


  template <int dim>
  void StepOperator<dim>::diagonal(Vector &destination) const
  {
    if (known_diagonal.size() == 0)
      {
        known_diagonal.reinit(destination);
        compute_diagonal(known_diagonal);
      }
    destination.copy_locally_owned_data_from(known_diagonal);
  }


  template <int dim>
  void StepOperator<dim>::compute_diagonal(Vector &destination) const
  {
    using Block =
      Eigen::Matrix<double, dim, dim, Eigen::RowMajor>; // the diagonal blocks are symmetric
    const auto &pattern  = matrices.pattern;
    const auto  block_of = [&](const unsigned int node) {
      if (pattern.is_empty(node))
        return Block(Block::Identity());
      return Block(Eigen::Map<const Block>(
        matrices.combined_block(node, pattern.row_start[node], sum).data()));
    };
    for (unsigned int node = 0; node < pattern.n_owned; ++node)
      {
        const Block block = block_of(node);
        for (unsigned int c = 0; c < dim; ++c)
          destination.local_element(dim * node + c) = block(c, c);
      }
    std::vector<std::array<double, dim * dim>> contact_blocks;
    for (const ContactNode<dim> &contact_node : coordinates.surface_nodes())
      {
        const Eigen::Map<const Block> frame(contact_node.dual_frame().data());
        const Block block = frame * block_of(contact_node.node) * frame.transpose();
        for (unsigned int c = 0; c < dim; ++c)
          destination.local_element(dim * contact_node.node + c) = block(c, c);
        contact_blocks.emplace_back();
        std::copy_n(block.data(), dim * dim, contact_blocks.back().begin());
      }
    // Partners move contact nodes along; products of different contact nodes are left out.
    coordinates.coupling().add_blocks_to_partners(contact_blocks, destination);
  }


  template class StepOperator<2>;
  template class StepOperator<3>;
} // namespace signorini
