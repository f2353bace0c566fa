// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/preconditioners/factor_coordinates.h>
#include <signorini/preconditioners/relative_matrix.h>
#include <signorini/surfaces/contact_frame.h>

#include <deal.II/base/mpi.h>

namespace signorini
{
  template <int dim>
  FactorCoordinates<dim>::FactorCoordinates(const ElasticMatrices<dim>    &matrices,
                                            const ContactCoordinates<dim> &coordinates,
                                            const MatrixSum               &sum,
                                            const bool                     follows_partners)
    : of_bodies(matrices)
    , coordinates(coordinates)
    , of_step(sum)
    , relative(follows_partners && coordinates.coupling().any() && !coordinates.coupling().changes()
                 ? relative_matrix(matrices, coordinates, sum)
                 : ElasticMatrices<dim>())
    , is_relative(relative.pattern.partitioner != nullptr)
    , n_turns(coordinates.n_turns())
    , frames(frames_now())
  {
  }


  template <int dim>
  NodeFrames<dim> FactorCoordinates<dim>::frames_now() const
  {
    return NodeFrames<dim>(
      coordinates.node_frames(), coordinates.contact_nodes(), matrices().pattern.partitioner);
  }


  template <int dim>
  bool FactorCoordinates<dim>::is_exact() const
  {
    return is_relative || !coordinates.coupling().any();
  }


  template <int dim>
  HeldNodes<dim> FactorCoordinates<dim>::set_mask(const Mask &mask)
  {
    AssertDimension(mask.size(), dim * of_bodies.pattern.n_owned);
    if (n_turns != coordinates.n_turns())
      {
        frames  = frames_now();
        n_turns = coordinates.n_turns();
      }
    held_entries.clear();
    for (unsigned int i = 0; i < mask.size(); ++i)
      if (mask[i])
        held_entries.push_back(i);
    Mask within = mask;
    if (!is_relative)
      for (const unsigned int i : coordinates.relative_entries())
        within[i] = 0;
    return frames.held_nodes(within);
  }


  template <int dim>
  std::optional<std::vector<NodeSlip<dim>>>
  FactorCoordinates<dim>::node_slip(const std::vector<SlipRows> &rows) const
  {
    std::vector<NodeSlip<dim>> result;
    bool                       any_oblique = false;
    for (const SlipRows &row : rows)
      {
        const unsigned int node  = row.normal / dim;
        const auto        &frame = coordinates.node_frames().at(node);
        any_oblique              = any_oblique || orthonormal_frame<dim>(frame) != frame;
        const auto direction     = [&](const unsigned int entry) {
          dealii::Tensor<1, dim> result;
          for (unsigned int c = 0; c < dim; ++c)
            result[c] = frame[dim * (entry % dim) + c];
          return result;
        };
        NodeSlip<dim> slip{node, direction(row.normal), {}, {}};
        for (unsigned int i = 0; i < row.entries.size(); ++i)
          {
            slip.coupling += row.coupling[i] * direction(row.entries[i]);
            for (unsigned int j = 0; j < row.entries.size(); ++j)
              slip.stiffness +=
                row.stiffness(i, j)
                * outer_product(direction(row.entries[i]), direction(row.entries[j]));
          }
        result.push_back(slip);
      }
    if (dealii::Utilities::MPI::max(static_cast<unsigned int>(any_oblique),
                                    of_bodies.pattern.partitioner->get_mpi_communicator())
        > 0)
      return {};
    return result;
  }


  template <int dim>
  void FactorCoordinates<dim>::to_factor(Vector &force) const
  {
    hold(force);
    if (is_relative)
      coordinates.force_from_frames(force);
    else
      coordinates.force_to_cartesian(force);
  }


  template <int dim>
  void FactorCoordinates<dim>::from_factor(Vector &displacement) const
  {
    if (is_relative)
      coordinates.rotate_to_frames(displacement);
    else
      coordinates.displacement_to_contact(displacement);
    hold(displacement);
  }


  template <int dim>
  void FactorCoordinates<dim>::hold(Vector &vector) const
  {
    for (const unsigned int i : held_entries)
      vector.local_element(i) = 0.;
  }


  template class FactorCoordinates<2>;
  template class FactorCoordinates<3>;
} // namespace signorini
