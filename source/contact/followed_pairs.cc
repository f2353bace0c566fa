// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/followed_pairs.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Of the motion that is expected: it may turn out to be larger. */
    constexpr double reserve = 2.;
    /** Of the smaller body of a pair in a step. */
    constexpr double large_motion = 0.25;
  } // namespace


  template <int dim>
  FollowedPairs<dim>::FollowedPairs(const Discretization<dim>          &discretization,
                                    const DirichletConditions<dim>     &dirichlet,
                                    const std::vector<PairDescription> &pairs)
    : discretization(discretization)
    , dirichlet(dirichlet)
    , descriptions(pairs)
  {
    for (unsigned int pair = 0; pair < pairs.size(); ++pair)
      if (pairs[pair].of_two_bodies())
        geometries[pair] =
          std::make_unique<FacingPair<dim>>(discretization, dirichlet, pairs, pair);
    const Vector nothing = discretization.make_vector();
    for (const auto &[pair, geometry] : geometries)
      clear[pair] = geometry->distance_of_boxes(nothing);
    find_order();
    std::set<unsigned int> slaves;
    for (const auto &[pair, geometry] : geometries)
      may_share = !slaves.insert(pairs[pair].slave).second || may_share;
  }


  template <int dim>
  void FollowedPairs<dim>::find_order()
  {
    std::set<unsigned int> left;
    for (const auto &[pair, geometry] : geometries)
      left.insert(pair);
    while (!left.empty())
      {
        const auto waits = [&](const unsigned int pair) {
          return std::any_of(left.begin(), left.end(), [&](const unsigned int other) {
            return other != pair && descriptions[other].slave == descriptions[pair].master;
          });
        };
        auto next = std::find_if_not(left.begin(), left.end(), waits);
        if (next == left.end())
          {
            is_cyclic = true;
            next      = left.begin();
          }
        order.push_back(*next);
        left.erase(next);
      }
  }


  template <int dim>
  std::vector<unsigned int> FollowedPairs<dim>::nodes() const
  {
    std::set<unsigned int> result;
    for (const auto &[pair, geometry] : geometries)
      {
        for (const auto &[node, area] : geometry->slave_nodes())
          result.insert(node);
        result.insert(geometry->master_nodes().begin(), geometry->master_nodes().end());
      }
    return std::vector<unsigned int>(result.begin(), result.end());
  }


  template <int dim>
  void FollowedPairs<dim>::begin_step(const Vector     &displacement,
                                      const Vector     &expected_motion,
                                      const StepNormals normals)
  {
    at_end    = normals == StepNormals::at_end;
    start     = displacement;
    expected  = expected_motion;
    looked_at = Vector();
    is_kept   = false;
    missed_gaps.clear();
    missed_by_shared.clear();
    follow(expected);
    // What clipped bounds are expected to miss, so that a motion as expected needs no repetition.
    look_what_is_missed();
  }


  template <int dim>
  void FollowedPairs<dim>::bound(PairCondition<dim> &condition) const
  {
    const double moved = condition.geometry.normal() * condition.motion;
    const double gap =
      std::isnan(condition.gap_at_end) ? condition.gap_at_start : condition.gap_at_end + moved;
    // The mean gap of a curved surface may be negative though nothing touches.
    condition.is_clipped = gap < 0. && !at_end;
    condition.bound      = condition.is_clipped ? 0. : gap;
  }


  template <int dim>
  void FollowedPairs<dim>::keep_geometry_of_expected()
  {
    follow(expected);
    is_kept = true;
  }


  template <int dim>
  void FollowedPairs<dim>::follow(const Vector &increment)
  {
    if (!is_kept)
      search_middle(increment);
    if (looked_at.size() == 0)
      search_end(increment);
    take_end_over();
    for (auto &[pair, of_pair] : conditions)
      for (auto &[node, condition] : of_pair)
        bound(condition);
    if (may_share)
      find_shared_nodes();
  }


  template <int dim>
  void FollowedPairs<dim>::find_shared_nodes()
  {
    using Parts = std::vector<typename SharedCondition<dim>::Part>;
    std::map<unsigned int, Parts> facing;
    for (const auto &[pair, of_pair] : conditions)
      for (const auto &[node, condition] : of_pair)
        facing[node].push_back({pair, &condition});
    shared.clear();
    for (auto &[node, parts] : facing)
      if (parts.size() > 1)
        {
          SharedCondition<dim> condition(std::move(parts), dirichlet.nodes().count(node) == 0);
          if (!condition.is_shared())
            continue;
          bound(condition.condition);
          shared.emplace(node, std::move(condition));
        }
  }


  template <int dim>
  void FollowedPairs<dim>::look_at_end(const Vector &increment)
  {
    search_end(increment);
    take_end_over();
    for (auto &[node, condition] : shared)
      condition.take_end_over();
    look_what_is_missed();
  }


  template <int dim>
  void FollowedPairs<dim>::look_what_is_missed()
  {
    for (auto &[node, of_node] : shared)
      {
        const double now                = of_node.condition.missed();
        const auto   known              = missed_by_shared.emplace(node, 0.).first;
        of_node.condition.missed_before = std::exchange(known->second, now);
      }
    const auto before = std::exchange(missed_gaps, {});
    for (auto &[pair, of_pair] : conditions)
      for (auto &[node, condition] : of_pair)
        {
          missed_gaps[pair][node] = condition.missed();
          if (const auto nodes = before.find(pair); nodes != before.end())
            if (const auto known = nodes->second.find(node); known != nodes->second.end())
              condition.missed_before = known->second;
        }
  }


  template <int dim>
  void FollowedPairs<dim>::take_end_over()
  {
    for (auto &[pair, of_pair] : conditions)
      {
        const auto  motion = relative(pair, looked_at);
        auto        next   = motion.begin();
        const auto &gaps   = end_gaps[pair];
        for (auto &[node, condition] : of_pair)
          {
            condition.motion = *next++;
            const auto gap   = gaps.find(node);
            condition.gap_at_end =
              gap != gaps.end() ? gap->second : std::numeric_limits<double>::quiet_NaN();
          }
      }
  }


  template <int dim>
  void FollowedPairs<dim>::search_middle(const Vector &increment)
  {
    Vector middle = start;
    middle.add(at_end ? 1. : 0.5, increment);
    const std::vector<bool> none(discretization.matrices().pattern.n_owned, false);
    std::map<unsigned int, std::vector<bool>> excluded; // by slave; in a ring of bodies for all
    conditions.clear();
    for (const unsigned int pair : order)
      {
        const unsigned int slave = descriptions[pair].slave, master = descriptions[pair].master;
        std::vector<bool> &followed = excluded.emplace(is_cyclic ? 0 : slave, none).first->second;
        auto               nodes = geometries[pair]->at(middle, reach(pair, increment), &followed);
        auto              &coupling = couplings[pair];
        coupling                    = std::make_unique<NodeCoupling<dim>>(
          nodes, discretization.matrices().pattern.partitioner, true);
        // No node must follow itself: in a ring of bodies, or where two pairs of a body leave a
        // node without multiplier to each other's nodes.
        for (const unsigned int node : coupling->owned_partners())
          if (is_cyclic || (slave != master && geometries[pair]->slave_nodes().count(node) > 0))
            followed[node] = true;
        Conditions &of_pair = conditions[pair];
        for (ContactNode<dim> &node : nodes) // ascending
          {
            auto &condition      = of_pair.try_emplace(of_pair.end(), node.node)->second;
            condition.geometry   = std::move(node);
            condition.gap_at_end = std::numeric_limits<double>::quiet_NaN();
          }
        const auto  displacement = relative(pair, start), motion = relative(pair, increment);
        std::size_t k = 0;
        for (auto &[node, condition] : of_pair)
          {
            condition.displacement = displacement[k];
            condition.motion       = motion[k++];
            condition.gap_at_start =
              condition.geometry.gap
              + (at_end ? 1. : 0.5) * (condition.geometry.normal() * condition.motion);
          }
      }
  }


  template <int dim>
  void FollowedPairs<dim>::search_end(const Vector &increment)
  {
    looked_at  = increment;
    Vector end = start;
    end += increment;
    end_gaps.clear();
    for (const auto &[pair, geometry] : geometries)
      {
        const double in_reach = reach(pair, increment);
        const auto   nodes    = geometry->at(end, in_reach);
        auto        &gaps     = end_gaps[pair];
        for (const ContactNode<dim> &node : nodes)
          gaps.emplace_hint(gaps.end(), node.node, node.gap);
        end_depths[pair] = FacingPair<dim>::depth(nodes);
        clear[pair]      = std::max(geometry->distance_of_boxes(end), in_reach);
      }
  }


  template <int dim>
  std::vector<Tensor<1, dim>> FollowedPairs<dim>::relative(const unsigned int pair,
                                                           const Vector      &v) const
  {
    std::vector<Tensor<1, dim>> result = couplings.at(pair)->partner_displacement(v);
    std::size_t                 k      = 0;
    for (const auto &[node, condition] : conditions.at(pair))
      {
        for (unsigned int c = 0; c < dim; ++c)
          result[k][c] = v.local_element(dim * node + c) - result[k][c];
        ++k;
      }
    return result;
  }


  template <int dim>
  double FollowedPairs<dim>::reach(const unsigned int pair, const Vector &increment) const
  {
    return reserve * geometries.at(pair)->relative_motion(increment);
  }


  template <int dim>
  const PairCondition<dim> *FollowedPairs<dim>::find(const unsigned int pair,
                                                     const unsigned int node) const
  {
    if (const auto known = shared.find(node); known != shared.end() && known->second.has(pair))
      return known->second.is_of(pair) ? &known->second.condition : nullptr;
    const auto of_pair = conditions.find(pair);
    if (of_pair == conditions.end())
      return nullptr;
    const auto condition = of_pair->second.find(node);
    return condition == of_pair->second.end() ? nullptr : &condition->second;
  }


  template <int dim>
  double FollowedPairs<dim>::depth(const unsigned int pair) const
  {
    const auto found = end_depths.find(pair);
    return Utilities::MPI::max(found != end_depths.end() ? found->second : 0.,
                               discretization.communicator());
  }


  template <int dim>
  bool FollowedPairs<dim>::move_too_far(const Vector &increment) const
  {
    const Mesh<dim> &mesh = discretization.mesh();
    bool             any  = false;
    for (const auto &[pair, geometry] : geometries)
      {
        if (descriptions[pair].slave == descriptions[pair].master)
          continue; // it does not fly past itself
        const double relative = geometry->relative_motion(increment);
        any                   = any
              || (relative > large_motion
                               * std::min(mesh.body_size(descriptions[pair].slave),
                                          mesh.body_size(descriptions[pair].master))
                  && geometry->distance_of_boxes(start) < relative);
      }
    return any;
  }


  template class FollowedPairs<2>;
  template class FollowedPairs<3>;
} // namespace signorini
