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
      boxes.reserve(faces.size());
      for (const SurfaceFace<dim> &face : faces)
        boxes.push_back(face.bounding_box());
      return boxes;
    }


    /** Send each master face to the processes in whose boxes it lies. */
    template <int dim>
    std::vector<SurfaceFace<dim>> exchange(std::vector<SurfaceFace<dim>>  owned,
                                           const std::vector<Sweep<dim>> &sweeps,
                                           const MPI_Comm                 communicator)
    {
      if (Utilities::MPI::n_mpi_processes(communicator) == 1)
        return owned;
      Boxes<dim> search_boxes;
      for (const Sweep<dim> &sweep : sweeps)
        search_boxes.push_back(sweep.box());
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
  FacingSurfaces<dim> facing_surfaces(const Discretization<dim> &discretization,
                                      const PairDescription     &pair)
  {
    FacingSurfaces<dim> result;
    result.slaves  = owned_surface_faces(discretization, pair.slave, pair.slave_boundary_ids);
    result.masters = owned_surface_faces(discretization, pair.master, pair.master_boundary_ids);
    for (const SurfaceFace<dim> &face : result.slaves)
      result.sweeps.emplace_back(face,
                                 discretization.mesh().bounding_box(pair.slave),
                                 discretization.mesh().bounding_box(pair.master));
    return result;
  }


  template <int dim>
  void find_opposite(const std::vector<SurfaceFace<dim>> &slaves,
                     std::vector<SurfaceFace<dim>>        owned_masters,
                     const std::vector<Sweep<dim>>       &sweeps,
                     const MPI_Comm                       communicator,
                     const SearchRules<dim>              &rules,
                     const OnFace<dim>                   &on_face)
  {
    AssertDimension(sweeps.size(), slaves.size());
    const auto       masters      = exchange(std::move(owned_masters), sweeps, communicator);
    const Boxes<dim> master_boxes = bounding_boxes(masters); // the tree refers to them
    const auto       tree         = pack_rtree_of_indices(master_boxes);

    std::vector<std::size_t>  found;
    std::vector<Segment<dim>> segments;
    for (std::size_t f = 0; f < slaves.size(); ++f)
      {
        const SurfaceFace<dim> &slave = slaves[f];
        double                  size = slave.diameter(), projected_area = 0.;
        segments.clear();
        if (sweeps[f].find(tree, found); !found.empty())
          {
            const SegmentFinder<dim> finder(
              slave, rules.rule, rules.facing.value_or(FacingWeight()));
            projected_area = finder.projected_area();
            for (const std::size_t m : found)
              {
                if (!sweeps[f].reaches(masters[m])
                    || (rules.may_meet && !rules.may_meet(slave, masters[m])))
                  continue;
                segments.emplace_back();
                Segment<dim> &segment = segments.back();
                finder.find(masters[m], segment);
                if (segment.is_empty() || segment.gap < -sweeps[f].depth()
                    || segment.gap > sweeps[f].height())
                  {
                    segments.pop_back();
                    continue;
                  }
                segment.master = m;
                size           = std::max(size, masters[m].diameter());
              }
            keep_closest_sheet(segments, size);
          }
        on_face({f, projected_area, segments, masters});
      }
  }


#define INSTANTIATE(dim)                                                                           \
  template FacingSurfaces<dim> facing_surfaces(const Discretization<dim> &,                        \
                                               const PairDescription &);                           \
  template void                find_opposite(const std::vector<SurfaceFace<dim>> &,                \
                                             std::vector<SurfaceFace<dim>>,                        \
                                             const std::vector<Sweep<dim>> &,                      \
                                             MPI_Comm,                                             \
                                             const SearchRules<dim> &,                             \
                                             const OnFace<dim> &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace signorini
