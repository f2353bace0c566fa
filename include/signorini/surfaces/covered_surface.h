// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_covered_surface_h
#define signorini_surfaces_covered_surface_h

#include <signorini/surfaces/contact_search.h>
#include <signorini/surfaces/covered_face.h>
#include <signorini/surfaces/mean_curvature.h>

namespace signorini
{
  /** The part of a slave surface that is opposite to the master, in any configuration. */
  template <int dim>
  class CoveredSurface
  {
  public:
    /** Search. Collective. */
    CoveredSurface(FacingSurfaces<dim>     surfaces,
                   MPI_Comm                communicator,
                   const SearchRules<dim> &rules);

    CoveredSurface(const CoveredSurface &)            = delete;
    CoveredSurface &operator=(const CoveredSurface &) = delete;

    /** Owned faces, without those of which next to nothing is covered. */
    const std::vector<CoveredFace<dim>> &faces() const { return covered; }

    /** Areas (lengths in 2d) on all processes: of the slave surface, and of faces(). */
    double area() const { return total_area; }
    double covered_area() const { return total_covered_area; }

    /** Whether any slave face of any process sees a master face, however little of it. */
    bool any() const { return any_segment; }

    /** By the mean curvatures of both sides; SegmentRule::degree_9 only. */
    const NormalWeights &weights_of_normals() const { return weights; }

  private:
    const std::vector<SurfaceFace<dim>> slaves;
    std::vector<CoveredFace<dim>>       covered; ///< refer to slaves
    double                              total_area = 0., total_covered_area = 0.;
    bool                                any_segment = false;
    NormalWeights                       weights;

    void add(const FacedByMasters<dim> &face, const SearchRules<dim> &rules);
  };
} // namespace signorini

#endif
