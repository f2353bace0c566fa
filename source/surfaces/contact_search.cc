// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/surfaces/contact_search.h>
#include <signorini/surfaces/sweep.h>

#include <deal.II/numerics/rtree.h>

#include <boost/geometry/algorithms/intersects.hpp>

#include <algorithm>
#include <map>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Boxes = std::vector<BoundingBox<dim>>;

    template <int dim>
    Boxes<dim> bounding_boxes(const std::vector<SurfaceFace<dim>> &faces)
    {
      Boxes<dim> boxes;
      for (const SurfaceFace<dim> &face : faces)
        boxes.push_back(face.bounding_box());
      return boxes;
    }


    /** Send each master face to the processes in whose boxes it lies. */
    template <int dim>
    std::vector<SurfaceFace<dim>> exchange(const std::vector<SurfaceFace<dim>> &owned,
                                           const Boxes<dim>                    &search_boxes,
                                           const MPI_Comm                       communicator)
    {
      if (Utilities::MPI::n_mpi_processes(communicator) == 1)
        return owned;
      // A few boxes that contain all: the top of the tree.
      const Boxes<dim> summary =
        search_boxes.empty() ? Boxes<dim>() : extract_rtree_level(pack_rtree(search_boxes), 0);
      const auto summaries = Utilities::MPI::all_gather(communicator, summary);
      std::map<unsigned int, std::vector<SurfaceFace<dim>>> outgoing;
      for (const SurfaceFace<dim> &face : owned)
        {
          const BoundingBox<dim> box = face.bounding_box();
          for (unsigned int rank = 0; rank < summaries.size(); ++rank)
            if (std::any_of(summaries[rank].begin(),
                            summaries[rank].end(),
                            [&](const BoundingBox<dim> &search_box) {
                              return boost::geometry::intersects(box, search_box);
                            }))
              outgoing[rank].push_back(face);
        }
      std::vector<SurfaceFace<dim>> received;
      for (auto &[rank, faces] : Utilities::MPI::some_to_some(communicator, outgoing))
        received.insert(received.end(), faces.begin(), faces.end());
      return received;
    }


    /** Of the segments on a slave face keep those of the closest sheet. */
    template <int dim>
    void keep_closest_sheet(std::vector<Segment<dim>> &segments, const double face_size)
    {
      double closest = std::numeric_limits<double>::max();
      for (const Segment<dim> &segment : segments)
        closest = std::min(closest, std::abs(segment.gap));
      segments.erase(std::remove_if(segments.begin(),
                                    segments.end(),
                                    [&](const Segment<dim> &segment) {
                                      return std::abs(segment.gap) > closest + face_size;
                                    }),
                     segments.end());
    }
  } // namespace


  template <int dim>
  FacingSurfaces<dim> find_facing_surfaces(const Discretization<dim> &discretization,
                                           const PairDescription     &pair)
  {
    const auto slaves = owned_surface_faces(discretization, pair.slave, pair.slave_boundary_ids);
    std::vector<Sweep<dim>> sweeps;
    for (const SurfaceFace<dim> &face : slaves)
      sweeps.emplace_back(face,
                          discretization.mesh().bounding_box(pair.slave),
                          discretization.mesh().bounding_box(pair.master));
    return find_facing_surfaces(
      slaves,
      owned_surface_faces(discretization, pair.master, pair.master_boundary_ids),
      sweeps,
      discretization.communicator(),
      {},
      SegmentRule::degree_9);
  }


  template <int dim>
  FacingSurfaces<dim> find_facing_surfaces(std::vector<SurfaceFace<dim>>        slaves,
                                           const std::vector<SurfaceFace<dim>> &masters,
                                           const std::vector<Sweep<dim>>       &sweeps,
                                           const MPI_Comm                       communicator,
                                           const MayMeet<dim>                  &may_meet,
                                           const SegmentRule                    rule)
  {
    AssertDimension(sweeps.size(), slaves.size());
    FacingSurfaces<dim> result;
    result.slaves = std::move(slaves);
    Boxes<dim> search_boxes;
    for (const Sweep<dim> &sweep : sweeps)
      search_boxes.push_back(sweep.box());
    result.masters = exchange(masters, search_boxes, communicator);

    const Boxes<dim> master_boxes = bounding_boxes(result.masters); // the tree refers to them
    const auto       tree         = pack_rtree_of_indices(master_boxes);
    result.segments.resize(result.slaves.size());
    for (std::size_t f = 0; f < result.slaves.size(); ++f)
      {
        const SurfaceFace<dim> &slave = result.slaves[f];
        double                  size  = slave.diameter();
        for (const std::size_t m : sweeps[f].meets(tree))
          {
            if (!sweeps[f].reaches(result.masters[m])
                || (may_meet && !may_meet(slave, result.masters[m])))
              continue;
            Segment<dim> segment = intersect(slave, result.masters[m], rule);
            if (segment.points.empty() || segment.gap < -sweeps[f].depth()
                || segment.gap > sweeps[f].height())
              continue;
            segment.master = m;
            size           = std::max(size, result.masters[m].diameter());
            result.segments[f].push_back(std::move(segment));
          }
        keep_closest_sheet(result.segments[f], size);
      }
    return result;
  }


  template FacingSurfaces<2> find_facing_surfaces(const Discretization<2> &,
                                                  const PairDescription &);
  template FacingSurfaces<3> find_facing_surfaces(const Discretization<3> &,
                                                  const PairDescription &);
  template FacingSurfaces<2> find_facing_surfaces(std::vector<SurfaceFace<2>>,
                                                  const std::vector<SurfaceFace<2>> &,
                                                  const std::vector<Sweep<2>> &,
                                                  MPI_Comm,
                                                  const MayMeet<2> &,
                                                  SegmentRule);
  template FacingSurfaces<3> find_facing_surfaces(std::vector<SurfaceFace<3>>,
                                                  const std::vector<SurfaceFace<3>> &,
                                                  const std::vector<Sweep<3>> &,
                                                  MPI_Comm,
                                                  const MayMeet<3> &,
                                                  SegmentRule);
} // namespace signorini
