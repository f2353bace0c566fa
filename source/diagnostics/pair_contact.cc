// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/own_forces.h>
#include <signorini/diagnostics/counted_nodes.h>
#include <signorini/diagnostics/friction_reading.h>
#include <signorini/diagnostics/pair_contact.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** x times f, in three components. */
    template <int dim>
    std::array<double, 3> cross(const Tensor<1, dim> &x, const Tensor<1, dim> &f)
    {
      if constexpr (dim == 2)
        return {{0., 0., x[0] * f[1] - x[1] * f[0]}};
      else
        return {{x[1] * f[2] - x[2] * f[1], x[2] * f[0] - x[0] * f[2], x[0] * f[1] - x[1] * f[0]}};
    }


    /** What adds up over nodes and processes, as numbers. */
    std::vector<double> sums_of(const PairContact &pair)
    {
      std::vector<double> sums(pair.force.begin(), pair.force.end());
      sums.insert(sums.end(), pair.moment.begin(), pair.moment.end());
      sums.insert(sums.end(),
                  {pair.normal_force, pair.friction_force, static_cast<double>(pair.n_active)});
      return sums;
    }


    void over_all_processes(std::vector<PairContact> &pairs, const MPI_Comm communicator)
    {
      std::vector<double> sums, gaps;
      for (const PairContact &pair : pairs)
        {
          const std::vector<double> of_pair = sums_of(pair);
          sums.insert(sums.end(), of_pair.begin(), of_pair.end());
          gaps.push_back(pair.smallest_gap);
        }
      Utilities::MPI::sum(sums, communicator, sums);
      Utilities::MPI::min(gaps, communicator, gaps);
      for (std::size_t k = 0; k < pairs.size(); ++k)
        {
          PairContact  &pair = pairs[k];
          const double *sum  = &sums[k * sums.size() / pairs.size()];
          std::copy(sum, sum + 3, pair.force.begin());
          std::copy(sum + 3, sum + 6, pair.moment.begin());
          pair.normal_force   = sum[6];
          pair.friction_force = sum[7];
          pair.n_active       = static_cast<unsigned int>(sum[8]);
          pair.smallest_gap   = gaps[k];
        }
    }
  } // namespace


  template <int dim>
  PairReader<dim>::PairReader(const Discretization<dim> &discretization,
                              const ContactSurface<dim> &surface)
    : discretization(discretization)
    , surface(surface)
    , bodies(discretization.bodies_of_nodes())
    , levers(levers_at(nullptr))
  {
  }


  template <int dim>
  std::vector<Tensor<1, dim>> PairReader<dim>::levers_at(const Vector *displacement) const
  {
    Vector positions = displacement != nullptr ? *displacement : discretization.make_vector();
    for (unsigned int node = 0; node < bodies.size(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        positions.local_element(dim * node + c) += discretization.node_positions()[node][c];
    std::vector<Tensor<1, dim>> result;
    for (const ContactNode<dim> &node : surface.nodes())
      {
        result.emplace_back();
        for (unsigned int c = 0; c < dim; ++c)
          result.back()[c] = positions.local_element(dim * node.node + c);
      }
    std::set<unsigned int> slaves;
    for (const PairDescription &pair : surface.pairs())
      slaves.insert(pair.slave);
    for (const unsigned int slave : slaves)
      {
        Vector of_slave = positions;
        for (unsigned int node = 0; node < bodies.size(); ++node)
          for (unsigned int c = 0; c < dim && bodies[node] != slave; ++c)
            of_slave.local_element(dim * node + c) = 0.;
        const auto of_partners = surface.coupling().partner_displacement(of_slave);
        for (std::size_t k = 0; k < of_partners.size(); ++k)
          if (surface.pairs()[surface.nodes()[k].pair].slave == slave)
            result[k] -= of_partners[k];
      }
    return result;
  }


  template <int dim>
  std::vector<PairContact> PairReader<dim>::read(const State &state) const
  {
    PairContact none;
    none.smallest_gap = std::numeric_limits<double>::infinity();
    std::vector<PairContact>  pairs(surface.pairs().size(), none);
    const std::vector<double> gaps   = surface.distance(state.displacement);
    const auto                places = surface.follows() ? levers_at(&state.displacement) : levers;
    const Vector              own    = own_forces(surface, state.contact_force);
    const FrictionState       of_nodes  = own_friction(surface, state.friction);
    const double              round_off = force_of_round_off(surface, discretization, state, own);
    for (unsigned int k = 0; k < surface.nodes().size(); ++k)
      {
        const ContactNode<dim>    &node         = surface.nodes()[k];
        PairContact               &pair         = pairs[node.pair];
        const double               normal_force = node.normal_force(own);
        const FrictionReading<dim> friction     = friction_at(surface, of_nodes, k);
        const Tensor<1, dim>       force        = node.force(own);
        const auto                 moment       = cross<dim>(places[k], force);
        for (unsigned int c = 0; c < 3; ++c)
          {
            pair.force[c] += c < dim ? node.transmission * force[c] : 0.;
            pair.moment[c] += moment[c];
          }
        pair.normal_force += node.transmission * std::abs(normal_force);
        pair.friction_force += node.transmission * friction.force.norm();
        pair.n_active += std::abs(normal_force) > round_off;
        if (!surface.faces_nothing(k))
          pair.smallest_gap = std::min(pair.smallest_gap, gaps[k]);
      }
    over_all_processes(pairs, discretization.communicator());
    for (unsigned int k = 0; k < pairs.size(); ++k)
      {
        double &gap = pairs[k].smallest_gap;
        if (!std::isfinite(gap)) // nothing faces anything
          gap = surface.follows() && surface.pairs()[k].of_two_bodies() ? surface.clear_distance(k)
                                                                        : 0.;
        pairs[k].max_penetration = std::max(0., -gap);
        pairs[k].depth           = surface.depth(k);
      }
    return pairs;
  }


  template class PairReader<2>;
  template class PairReader<3>;
} // namespace signorini
