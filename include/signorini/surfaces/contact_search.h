// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_surfaces_contact_search_h
#define signorini_surfaces_contact_search_h

#include <signorini/surfaces/face_segments.h>
#include <signorini/surfaces/sweep.h>

#include <functional>

namespace signorini
{
  /**
   * The owned slave faces of a pair, the master faces that they may meet, and the segments on each
   * slave face.
   */
  template <int dim>
  struct FacingSurfaces
  {
    std::vector<SurfaceFace<dim>> slaves, masters;
    std::vector<std::vector<Segment<dim>>>
      segments; ///< per slave face; empty where nothing is opposite
  };

  /**
   * Find what is opposite to the slave faces of a pair of bodies, along their normals. If several
   * sheets of the master surface are opposite, the closest counts. Collective: each process
   * receives the master faces near its own slave faces and no others; bounding boxes, a few per
   * process, tell who may need what.
   *
   * Parts of the master that lie behind the slave face count as long as they are less than a
   * quarter of both bodies deep; so bodies that overlap are noticed, and the far sides of bodies
   * are not mistaken for contact.
   */
  template <int dim>
  FacingSurfaces<dim> find_facing_surfaces(const Discretization<dim> &discretization,
                                           const PairDescription     &pair);

  template <int dim>
  using MayMeet = std::function<bool(const SurfaceFace<dim> &, const SurfaceFace<dim> &)>;

  /**
   * The same with faces in any configuration, and for each slave face how far it looks.
   * @param slaves, masters owned faces
   * @param may_meet whether a slave face (the first one) and a master face may face each other at
   * all; null: any
   * @param rule see intersect()
   */
  template <int dim>
  FacingSurfaces<dim> find_facing_surfaces(std::vector<SurfaceFace<dim>>        slaves,
                                           const std::vector<SurfaceFace<dim>> &masters,
                                           const std::vector<Sweep<dim>>       &sweeps,
                                           MPI_Comm                             communicator,
                                           const MayMeet<dim>                  &may_meet,
                                           SegmentRule                          rule);
} // namespace signorini

#endif
