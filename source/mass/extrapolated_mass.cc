// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/mass/extrapolated_mass.h>
#include <signorini/mass/owned_rows.h>

#include <cmath>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    using Node = types::global_dof_index;

    /**
     * The node with mass at the end of an edge from `node` that points best along `direction`,
     * within 60 degrees.
     */
    template <int dim>
    Node neighbour_along(const ContactStrip<dim> &strip,
                         const Node               node,
                         const Tensor<1, dim>    &direction)
    {
      Node        best    = numbers::invalid_dof_index;
      double      largest = 0.5 * direction.norm();
      const auto &around  = strip.cells_of_node.at(node);
      for (const unsigned int k : around)
        {
          const auto &nodes = strip.cells[k].nodes;
          const auto  v     = std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
          for (unsigned int d = 0; d < dim; ++d)
            {
              const Node other = nodes[v ^ (1 << d)];
              if (other == StripCell<dim>::hanging || strip.is_massless(other))
                continue;
              const Tensor<1, dim> edge   = strip.positions.at(other) - strip.positions.at(node);
              const double         cosine = edge * direction / edge.norm();
              if (cosine > largest * (1. + 1e-10))
                {
                  largest = cosine;
                  best    = other;
                }
            }
        }
      return best;
    }


    /** Nodes with mass in the cells around some nodes. */
    template <int dim>
    std::set<Node> patch_around(const ContactStrip<dim> &strip, const std::set<Node> &centres)
    {
      std::set<Node> found;
      for (const Node centre : centres)
        for (const unsigned int k : strip.cells_of_node.at(centre))
          for (const Node other : strip.cells[k].nodes)
            if (other != StripCell<dim>::hanging && !strip.is_massless(other))
              found.insert(other);
      return found;
    }


    /**
     * Weights 1 + t and -t of the two nodes on the line of the mesh that leads inwards; empty if
     * there is none.
     */
    template <int dim>
    std::map<Node, double> weights_on_line(const ContactStrip<dim> &strip, const Node node)
    {
      const Node first = neighbour_along<dim>(strip, node, -strip.massless.at(node));
      if (first == numbers::invalid_dof_index)
        return {};
      const Point<dim> x = strip.positions.at(node), x1 = strip.positions.at(first);
      const Node       second = neighbour_along<dim>(strip, first, x1 - x);
      if (second == numbers::invalid_dof_index)
        return {};
      const Tensor<1, dim> line = x1 - strip.positions.at(second);
      const double         t    = (x - x1) * line / line.norm_square();
      if (t > 3.) // a thin second layer: its weights would be huge
        return {};
      return {{first, 1. + t}, {second, -t}};
    }
  } // namespace


  template <int dim>
  NodeWeights extrapolation_weights(const ContactStrip<dim> &strip, const Node node)
  {
    std::map<Node, double> weights = weights_on_line(strip, node);
    const Point<dim>       x       = strip.positions.at(node);

    // What is missing to reproduce 1 and x (relative to the node itself, in units of the cell).
    double size = 0.;
    for (const unsigned int k : strip.cells_of_node.at(node))
      size = std::max(size, strip.cells[k].centre().distance(x));
    Eigen::VectorXd missing = Eigen::VectorXd::Zero(1 + dim);
    missing(0)              = 1.;
    const auto values       = [&](const Node other) {
      Eigen::VectorXd row(1 + dim);
      row(0)                    = 1.;
      const Tensor<1, dim> away = (strip.positions.at(other) - x) / size;
      for (unsigned int c = 0; c < dim; ++c)
        row(1 + c) = away[c];
      return row;
    };
    for (const auto &[other, weight] : weights)
      missing -= weight * values(other);

    constexpr double round_off = 1e-12;
    if (missing.norm() > round_off)
      {
        // The fewer nodes, the fewer new couplings.
        std::set<Node> centres =
          weights.empty() ? patch_around(strip, {node}) : std::set<Node>{node};
        if (!weights.empty())
          centres.insert(neighbour_along<dim>(strip, node, -strip.massless.at(node)));
        const std::set<Node> patch = patch_around(strip, centres);
        Eigen::MatrixXd      moments(1 + dim, patch.size());
        unsigned int         column = 0;
        for (const Node other : patch)
          moments.col(column++) = values(other);
        const Eigen::VectorXd least = moments.completeOrthogonalDecomposition().solve(missing);
        if (!((moments * least - missing).norm() < 1e-9))
          return {};
        column = 0;
        for (const Node other : patch)
          weights[other] += least(column++);
      }
    return NodeWeights(weights.begin(), weights.end());
  }


  template <int dim>
  MassChange extrapolated_mass(const Discretization<dim> &discretization,
                               const ContactStrip<dim>   &strip)
  {
    std::map<Node, NodeWeights> weights;
    for (const auto &[node, normal] : strip.massless)
      {
        weights[node] = extrapolation_weights(strip, node);
        if (weights[node].empty())
          {
            std::ostringstream message;
            message << "Time/Mass = redistributed: behind the contact node at ("
                    << strip.positions.at(node)
                    << ") are too few nodes that could take its mass. The body needs at least two "
                       "layers of cells there: increase Refinements or Repetitions.";
            throw UserError(message.str());
          }
      }

    // M~ - M from the rows of M that this process owns; only couplings with contact nodes change.
    const auto &matrices    = discretization.matrices();
    const auto &partitioner = *matrices.pattern.partitioner;
    const auto  global      = [&](const unsigned int local) {
      return partitioner.local_to_global(dim * local) / dim;
    };
    const auto spread = [&](const Node node) {
      return strip.is_massless(node) ? weights.at(node) : NodeWeights{{node, 1.}};
    };
    MassChange contributions;
    const auto move = [&](const Node i, const Node j, const double mass) {
      contributions[{i, j}] -= mass;
      for (const auto &[q, weight_q] : spread(i))
        for (const auto &[r, weight_r] : spread(j))
          contributions[{q, r}] += weight_q * weight_r * mass;
    };
    for (unsigned int row = 0; row < matrices.pattern.n_owned; ++row)
      for (unsigned int k = matrices.pattern.row_start[row];
           k < matrices.pattern.row_start[row + 1];
           ++k)
        {
          const unsigned int column = matrices.pattern.columns[k];
          const Node         i = global(row), j = global(column);
          if (!strip.is_massless(i) && !strip.is_massless(j))
            continue;
          move(i, j, matrices.mass[k]);
          if (column != row
              && column < matrices.pattern.n_owned) // the owner of a ghost does its row
            move(j, i, matrices.mass[k]);
        }
    return sum_of_owned_rows<dim>(contributions, partitioner);
  }


  template NodeWeights extrapolation_weights(const ContactStrip<2> &, Node);
  template NodeWeights extrapolation_weights(const ContactStrip<3> &, Node);
  template MassChange  extrapolated_mass(const Discretization<2> &, const ContactStrip<2> &);
  template MassChange  extrapolated_mass(const Discretization<3> &, const ContactStrip<3> &);
} // namespace signorini
