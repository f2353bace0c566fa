// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/shared_condition.h>
#include <signorini/surfaces/contact_frame.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Differences of gaps, in sizes of the node, and of unit normals that are too large. */
    constexpr double too_far = 0.05, too_oblique = 0.1;
    /** Of unit normals: round-off. */
    constexpr double same_normal = 1e-12;
  } // namespace


  template <int dim>
  SharedCondition<dim>::SharedCondition(std::vector<Part> facing, const bool turns)
  {
    const auto &closest = *std::min_element(facing.begin(), facing.end(), [](auto &a, auto &b) {
                             return a.condition->gap_at_start < b.condition->gap_at_start;
                           })->condition;
    double      area    = 0.;
    for (const Part &part : facing)
      area = std::max(area, part.condition->geometry.weight);
    const double size = std::pow(area, 1. / (dim - 1));
    for (const Part &part : facing)
      {
        const double farther = part.condition->gap_at_start - closest.gap_at_start,
                     oblique =
                       (part.condition->geometry.normal() - closest.geometry.normal()).norm();
        const double counts =
          std::max(0., 1. - farther / (too_far * size)) * std::max(0., 1. - oblique / too_oblique);
        if (counts > 0.)
          parts.push_back({part, counts * part.condition->geometry.weight});
      }
    std::stable_sort(parts.begin(), parts.end(), [](const Weighed &a, const Weighed &b) {
      return a.weight > b.weight;
    });
    condition = *parts.front().condition;
    if (!is_shared())
      return;
    merge_geometry(turns);
    take_end_over();
  }


  template <int dim>
  bool SharedCondition<dim>::has(const unsigned int pair) const
  {
    return std::any_of(
      parts.begin(), parts.end(), [&](const Weighed &part) { return part.pair == pair; });
  }


  template <int dim>
  void SharedCondition<dim>::merge_geometry(const bool turns)
  {
    ContactNode<dim>                         &node = condition.geometry;
    std::map<types::global_dof_index, double> partners;
    Tensor<1, dim>                            normal, displacement;
    double gap = 0., gap_at_start = 0., transmission = 0., sum = 0.;
    for (const Weighed &part : parts)
      {
        const ContactNode<dim> &other = part.condition->geometry;
        sum += part.weight;
        normal += part.weight * other.normal();
        displacement += part.weight * part.condition->displacement;
        gap += part.weight * other.gap;
        gap_at_start += part.weight * part.condition->gap_at_start;
        transmission += part.weight * other.transmission;
        node.clearance = std::min(node.clearance, other.clearance);
        for (const auto &[partner, weight] : other.partners)
          partners[partner] += part.weight * weight;
      }
    normal /= normal.norm();
    if (turns && (normal - node.normal()).norm() > same_normal)
      node.frame = contact_frame<dim>(normal);
    node.partners.clear();
    for (const auto &[partner, weight] : partners)
      node.partners.emplace_back(partner, weight / sum);
    node.gap               = gap / sum;
    node.transmission      = transmission / sum;
    node.weight            = sum;
    condition.gap_at_start = gap_at_start / sum;
    condition.displacement = displacement / sum;
  }


  template <int dim>
  void SharedCondition<dim>::take_end_over()
  {
    condition.motion     = Tensor<1, dim>();
    condition.gap_at_end = 0.;
    double sum = 0., facing_at_end = 0.;
    for (const Weighed &part : parts)
      {
        sum += part.weight;
        condition.motion += part.weight * part.condition->motion;
        if (std::isnan(part.condition->gap_at_end))
          continue;
        facing_at_end += part.weight;
        condition.gap_at_end += part.weight * part.condition->gap_at_end;
      }
    condition.motion /= sum;
    condition.gap_at_end = facing_at_end > 0. ? condition.gap_at_end / facing_at_end
                                              : std::numeric_limits<double>::quiet_NaN();
  }


  template class SharedCondition<2>;
  template class SharedCondition<3>;
} // namespace signorini
