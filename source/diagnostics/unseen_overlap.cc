// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/unseen_overlap.h>

#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <sstream>

namespace signorini
{
  namespace
  {
    constexpr unsigned int looks_after_calls = 10;
    /** Over the diameter of a face. On a circle it is a bulge with 78 faces around. */
    constexpr double told_depth = 0.01;
    /** Facets of curved surfaces and released nodes may be inside by some per cent. */
    constexpr double told_depth_of_nodes = 0.1;
  } // namespace


  template <int dim>
  UnseenOverlap<dim>::UnseenOverlap(const std::size_t n_pairs, const std::string &remedy)
    : remedy(remedy)
    , is_told(n_pairs, 0)
  {
  }


  template <int dim>
  void UnseenOverlap<dim>::use_mesh(const Discretization<dim> &new_discretization,
                                    const ContactSurface<dim> &new_surface)
  {
    discretization = &new_discretization;
    surface        = &new_surface;
    unseen.reset();
  }


  template <int dim>
  std::vector<std::string> UnseenOverlap<dim>::judge(const State &state, const bool last)
  {
    const bool is_time = n_calls++ % looks_after_calls == 0 || last;
    if (!is_time || std::find(is_told.begin(), is_told.end(), 0) == is_told.end())
      return {};
    if (!unseen)
      unseen.emplace(*discretization, *surface);
    const auto found = unseen->find(state.displacement, state.contact_force, state.time);
    std::vector<std::string> news;
    for (unsigned int pair = 0; pair < is_told.size(); ++pair)
      if (!is_told[pair] && found.relative_depths_of_nodes[pair] > told_depth_of_nodes)
        {
          is_told[pair] = 1;
          std::ostringstream text;
          text
            << "at time " << state.time << " the bodies of the pair '"
            << surface->pairs()[pair].name
            << "' go through each other: they are inside with whole faces, and no node there "
               "bears anything. Nodes of the slave take no part in contact if their displacement "
               "is prescribed along its normal: exchange slave and master, or prescribe it on "
               "another side. And where contact is linearised, nodes take no part that were not "
               "opposite to the master at the start.";
          news.push_back(text.str());
        }
    for (unsigned int pair = 0; pair < is_told.size(); ++pair)
      if (!is_told[pair] && found.relative_depths[pair] > told_depth)
        {
          is_told[pair] = 1;
          std::ostringstream text;
          text.precision(3);
          text << "at time " << state.time << " the two sides of the pair '"
               << surface->pairs()[pair].name << "' overlap by " << found.depths[pair]
               << " (length) between nodes, where none of them touches: contact begins too late, "
                  "or never, as the mesh is too coarse to see it. "
               << remedy;
          news.push_back(text.str());
        }
    return news;
  }


  template class UnseenOverlap<2>;
  template class UnseenOverlap<3>;
} // namespace signorini
