// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/surfaces/covered_surface.h>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    // A sliver this small has no well-conditioned dual basis.
    constexpr double smallest_covered_face = 1e-3;
  } // namespace


  template <int dim>
  CoveredSurface<dim>::CoveredSurface(FacingSurfaces<dim>     surfaces,
                                      const MPI_Comm          communicator,
                                      const SearchRules<dim> &rules)
    : slaves(std::move(surfaces.slaves))
  {
    covered.reserve(slaves.size());
    MeanCurvature<dim> slave_curvature, master_curvature;
    const auto         on_face = [&](const FacedByMasters<dim> &face) {
      const std::size_t n_before = covered.size();
      add(face, rules);
      if (rules.rule == SegmentRule::degree_9 && covered.size() > n_before)
        for (const Segment<dim> &segment : face.segments)
          for (const SegmentPoint<dim> &point : segment.points)
            {
              const Point<dim> position = slaves[face.slave].position(point.slave);
              slave_curvature.add(point.weight, position, point.normal);
              master_curvature.add(point.weight, position + point.apart, point.opposite);
            }
    };
    find_opposite<dim>(
      slaves, std::move(surfaces.masters), surfaces.sweeps, communicator, rules, on_face);
    if (rules.rule == SegmentRule::degree_9)
      weights = signorini::weights_of_normals(slave_curvature.value(communicator),
                                              master_curvature.value(communicator));
    std::vector<double> sums{total_area, total_covered_area, static_cast<double>(any_segment)};
    Utilities::MPI::sum(sums, communicator, sums);
    total_area         = sums[0];
    total_covered_area = sums[1];
    any_segment        = sums[2] > 0.;
  }


  template <int dim>
  void CoveredSurface<dim>::add(const FacedByMasters<dim> &face, const SearchRules<dim> &rules)
  {
    CoveredFace<dim> result(slaves[face.slave]);
    double           full = 0., covered_part = 0.;
    for (const double integral : result.full)
      full += integral;
    total_area += full;
    for (const Segment<dim> &segment : face.segments)
      covered_part += segment.area;
    any_segment = any_segment || covered_part > 0.;
    if (!(covered_part > 0.) || covered_part < smallest_covered_face * face.projected_area)
      return;
    for (const Segment<dim> &segment : face.segments)
      result.add(segment, face.masters[segment.master]);
    const double counted = result.mass.sum();
    if (rules.facing && counted < smallest_covered_face * full)
      return;
    total_covered_area += counted;
    covered.push_back(std::move(result));
  }


  template class CoveredSurface<2>;
  template class CoveredSurface<3>;
} // namespace signorini
