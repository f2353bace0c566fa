// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_contact_search_h
#define signorini_surfaces_contact_search_h

#include <signorini/surfaces/face_segments.h>
#include <signorini/surfaces/sweep.h>

#include <functional>
#include <optional>

namespace signorini
{
  /** The owned faces of a pair of bodies, and for each slave face how far it looks. */
  template <int dim>
  struct FacingSurfaces
  {
    std::vector<SurfaceFace<dim>> slaves, masters;
    std::vector<Sweep<dim>>       sweeps; ///< per slave face
  };

  /**
   * Those of the reference configuration. Parts of the master that lie behind the slave face count
   * as long as they are less than a quarter of both bodies deep; so bodies that overlap are
   * noticed, and the far sides of bodies are not mistaken for contact.
   */
  template <int dim>
  FacingSurfaces<dim> facing_surfaces(const Discretization<dim> &discretization,
                                      const PairDescription     &pair);

  template <int dim>
  struct SearchRules
  {
    SegmentRule rule = SegmentRule::degree_9;
    /** How much points count. Without: 1. */
    std::optional<FacingWeight> facing;
    /** Whether a slave face (the first one) and a master face may meet at all. Null: any. */
    std::function<bool(const SurfaceFace<dim> &, const SurfaceFace<dim> &)> may_meet;
  };

  /** What is opposite to a slave face. */
  template <int dim>
  struct FacedByMasters
  {
    std::size_t                          slave;          ///< index
    double                               projected_area; ///< of the slave face; 0 if none is near
    const std::vector<Segment<dim>>     &segments;       ///< empty where nothing is opposite
    const std::vector<SurfaceFace<dim>> &masters;        ///< what the segments refer to
  };

  template <int dim>
  using OnFace = std::function<void(const FacedByMasters<dim> &)>;

  /**
   * Find what is opposite to the slave faces of a pair of bodies, along their normals, and hand it
   * over face by face, in their order: all segments would take more memory than all else. If
   * several sheets of the master surface are opposite, the closest counts. Collective: each process
   * receives the master faces near its own slave faces and no others; bounding boxes, a few per
   * process, tell who may need what.
   */
  template <int dim>
  void find_opposite(const std::vector<SurfaceFace<dim>> &slaves,
                     std::vector<SurfaceFace<dim>>        masters,
                     const std::vector<Sweep<dim>>       &sweeps,
                     MPI_Comm                             communicator,
                     const SearchRules<dim>              &rules,
                     const OnFace<dim>                   &on_face);
} // namespace signorini

#endif
