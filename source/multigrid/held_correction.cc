// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/multigrid/held_correction.h>

namespace signorini
{
  namespace
  {
    /** Parts of the same node become one, without room for more: there are many rows. */
    template <typename Row>
    void unite(Row &row)
    {
      std::sort(
        row.begin(), row.end(), [](const auto &a, const auto &b) { return a.node < b.node; });
      std::size_t n = 0;
      for (std::size_t k = 0; k < row.size(); ++k)
        if (n > 0 && row[n - 1].node == row[k].node)
          row[n - 1].value += row[k].value;
        else
          row[n++] = row[k];
      row.resize(n);
      row.shrink_to_fit();
    }
  } // namespace


  template <int dim, typename Number>
  HeldCorrection<dim, Number>::HeldCorrection(const LevelHierarchy<dim>     &hierarchy,
                                              const ContactCoordinates<dim> &coordinates,
                                              const MatrixSum               &sum,
                                              const double                   scale)
    : hierarchy(hierarchy)
    , scale(scale)
    , any_partners(coordinates.coupling().any())
    , rows(hierarchy.matrices(hierarchy.n_levels() - 1),
           coordinates,
           sum,
           hierarchy.clamped_nodes())
    , levels(hierarchy.n_levels() - 1)
  {
    for (unsigned int level = 0; level < levels.size(); ++level)
      localise(level);
  }


  template <int dim, typename Number>
  void HeldCorrection<dim, Number>::set_mask(const Mask &mask)
  {
    add_rows(rows.set_mask(mask));
    held = rows.owned_held();
    sum_up();
    for (unsigned int level = 0; level < levels.size(); ++level)
      localise(level);
  }


  template <int dim, typename Number>
  void HeldCorrection<dim, Number>::add_rows(const std::vector<unsigned int> &numbers)
  {
    std::vector<Row> measures, forces;
    for (const unsigned int number : numbers)
      {
        measures.push_back(rows.measure(number));
        forces.push_back(rows.forces(number));
      }
    for (unsigned int level = levels.size(); level-- > 0;)
      {
        measures = coarsened(level + 1, measures);
        forces   = coarsened(level + 1, forces);
        std::copy(measures.begin(), measures.end(), std::back_inserter(levels[level].measures));
        std::copy(forces.begin(), forces.end(), std::back_inserter(levels[level].forces));
      }
  }


  template <int dim, typename Number>
  std::vector<typename HeldCorrection<dim, Number>::Row>
  HeldCorrection<dim, Number>::coarsened(const unsigned int      level,
                                         const std::vector<Row> &fine_rows) const
  {
    using Node = typename HeldRows<dim>::Node;
    std::vector<Node> nodes;
    for (const Row &row : fine_rows)
      for (const Part &part : row)
        nodes.push_back(part.node);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const auto       parents = hierarchy.parents(level, nodes);
    std::vector<Row> result(fine_rows.size());
    for (std::size_t e = 0; e < fine_rows.size(); ++e)
      {
        for (const Part &part : fine_rows[e])
          for (const auto &[parent, weight] :
               parents[std::lower_bound(nodes.begin(), nodes.end(), part.node) - nodes.begin()])
            result[e].push_back({parent, weight * part.value});
        unite(result[e]);
      }
    return result;
  }


  template <int dim, typename Number>
  void HeldCorrection<dim, Number>::sum_up()
  {
    couplings.resize(rows.size());
    for (Level &level : levels)
      level.sums.resize(rows.size());
    for (const unsigned int number : held)
      {
        auto now = rows.couplings(number);
        if (now == couplings[number])
          continue;
        couplings[number] = std::move(now);
        for (Level &level : levels)
          {
            Row &sum = level.sums[number];
            sum      = level.forces[number];
            for (Part &part : sum)
              part.value *= -1.;
            for (const auto &[other, value] : couplings[number])
              for (const Part &part : level.measures[other])
                sum.push_back({part.node, 0.5 * value * part.value});
            unite(sum);
          }
      }
  }


  template <int dim, typename Number>
  void HeldCorrection<dim, Number>::localise(const unsigned int level)
  {
    Level             &here    = levels[level];
    const NodePattern &pattern = hierarchy.matrices(level).pattern;
    here.nodes.n_owned         = pattern.n_owned;
    here.nodes.first_owned     = pattern.partitioner->local_range().first / dim;
    here.nodes.ghosts.clear();
    for_each_held(level, [&](const Row &measure, const Row &sum) {
      for (const Row *row : {&measure, &sum})
        for (const Part &part : *row)
          if (!here.nodes.owns(part.node))
            here.nodes.ghosts.push_back(part.node);
    });
    here.nodes.sort_ghosts();
    if (!here.ghosts || !here.ghosts->is_alone())
      here.ghosts =
        std::make_unique<GhostValues>(here.nodes, pattern.partitioner->get_mpi_communicator());
    here.parts.clear();
    here.starts.assign(1, 0);
    for_each_held(level, [&](const Row &measure, const Row &sum) {
      for (const Row *row : {&measure, &sum})
        {
          for (const Part &part : *row)
            {
              Lanes<Number> value{};
              for (unsigned int c = 0; c < dim; ++c)
                value[c] = (row == &sum ? scale : 1.) * part.value[c];
              here.parts.push_back({here.nodes.local(part.node), value});
            }
          here.starts.push_back(here.parts.size());
        }
    });
  }


  template <int dim, typename Number>
  void HeldCorrection<dim, Number>::subtract_product(const unsigned int         level,
                                                     const LevelVector<Number> &x,
                                                     LevelVector<Number>       &y) const
  {
    const Level &here = levels[level];
    here.ghosts->fetch(x);
    std::vector<Number> products;
    products.reserve(here.starts.size());
    for (std::size_t row = 0; row + 1 < here.starts.size(); ++row)
      {
        Lanes<Number> sum{};
        for (unsigned int k = here.starts[row]; k < here.starts[row + 1]; ++k)
          sum += here.parts[k].value * here.ghosts->value(x, here.parts[k].node);
        products.push_back(sum[0] + sum[1] + sum[2] + sum[3]);
      }
    here.ghosts->template clear<Number>();
    for (std::size_t row = 0; row + 1 < here.starts.size(); ++row)
      for (unsigned int k = here.starts[row]; k < here.starts[row + 1]; ++k)
        here.ghosts->add(y, here.parts[k].node, -products[row ^ 1] * here.parts[k].value);
    here.ghosts->add_to_owners(y);
  }


  template <int dim, typename Number>
  NodeBlocks<dim> HeldCorrection<dim, Number>::diagonal_changes(const unsigned int level) const
  {
    const Level    &here = levels[level];
    NodeBlocks<dim> result;
    for_each_held(level, [&](const Row &measure, const Row &sum) {
      auto other = sum.begin();
      for (const Part &part : measure)
        {
          while (other != sum.end() && other->node < part.node)
            ++other;
          if (other == sum.end() || other->node != part.node)
            continue;
          auto &block =
            result.try_emplace(here.nodes.local(part.node), Eigen::Matrix<double, dim, dim>::Zero())
              .first->second;
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              block(i, j) +=
                scale * (part.value[i] * other->value[j] + other->value[i] * part.value[j]);
        }
    });
    add_to_owners<dim>(result, *here.ghosts);
    return result;
  }


  template class HeldCorrection<2, float>;
  template class HeldCorrection<2, double>;
  template class HeldCorrection<3, float>;
  template class HeldCorrection<3, double>;
} // namespace signorini
