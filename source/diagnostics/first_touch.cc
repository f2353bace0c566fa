// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/first_touch.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/array.hpp>

#include <Eigen/Dense>

#include <cmath>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double patch = 2.5; ///< radius around the place, in distances of nodes
    constexpr double round =
      1e-3; ///< rise of a patch, in distances of nodes, from which it is round
    constexpr double misfit = 0.1; ///< of a paraboloid, part of what rises

    /** Around the node of a pair that touches first. */
    template <int dim>
    struct TouchPlace
    {
      double                        speed = 0., distance = 0., radius = 0.;
      Point<dim>                    position;
      std::array<double, dim * dim> frame{}; ///< rows: normal, tangents

      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &speed &distance &radius &position &frame;
      }
    };


    /** The nodes of a pair as it approaches. */
    template <int dim>
    class Approach
    {
    public:
      Approach(const ContactSurface<dim> &surface,
               const Vector              &displacement,
               const Vector              &velocity,
               const MPI_Comm             communicator)
        : nodes(surface.nodes())
        , distances(surface.normal_gap(displacement)) // infinite past the end of an obstacle
        , speeds(surface.relative_normal(velocity))
        , communicator(communicator)
      {
        for (std::size_t k = 0; k < nodes.size(); ++k)
          {
            distances[k] *= nodes[k].distance_per_gap();
            speeds[k] *= nodes[k].distance_per_gap();
          }
      }

      FirstTouch first_touch(const unsigned int pair) const
      {
        FirstTouch   touch;
        double       time  = std::numeric_limits<double>::infinity();
        unsigned int first = 0;
        for (std::size_t k = 0; k < nodes.size(); ++k)
          if (nodes[k].pair == pair && speeds[k] > 0. && distances[k] / speeds[k] < time)
            {
              time  = distances[k] / speeds[k];
              first = k;
            }
        const auto times = Utilities::MPI::min_max_avg(time, communicator);
        if (!std::isfinite(times.min))
          return touch;
        Place place;
        if (Utilities::MPI::this_mpi_process(communicator) == times.min_index)
          place = {speeds[first],
                   distances[first],
                   patch * std::pow(nodes[first].weight, 1. / (dim - 1)),
                   nodes[first].position,
                   nodes[first].frame};
        place          = Utilities::MPI::broadcast(communicator, place, times.min_index);
        touch.time     = times.min;
        touch.speed    = place.speed;
        touch.distance = place.distance;
        for (unsigned int c = 0; c < dim; ++c)
          touch.position[c] = place.position[c];
        std::copy_n(place.frame.begin(), dim, touch.normal.begin());
        fit(pair, place, touch);
        return touch;
      }

    private:
      static constexpr unsigned int n_unknowns = 1 + (dim - 1) + 1;
      using Place                              = TouchPlace<dim>;
      using Row                                = Eigen::Matrix<double, n_unknowns, 1>;

      const std::vector<ContactNode<dim>> &nodes;
      std::vector<double>                  distances, speeds;
      MPI_Comm                             communicator;

      /** distance - distance of the first node = a + b.t + 1/(2R) |t|^2, by least squares. */
      void fit(const unsigned int pair, const Place &place, FirstTouch &touch) const
      {
        // In one array, as it is summed over the processes: normal equations, then single sums.
        constexpr unsigned int n_entries = n_unknowns * (n_unknowns + 1);
        std::vector<double>    sums(n_entries + 5, 0.);
        Eigen::Map<Eigen::Matrix<double, n_unknowns, n_unknowns>> matrix(sums.data());
        Eigen::Map<Row> right_hand_side(sums.data() + n_unknowns * n_unknowns);
        double         &squares = sums[n_entries], &n_nodes = sums[n_entries + 1],
               &area = sums[n_entries + 2], &area_at_once = sums[n_entries + 3],
               &n_at_once    = sums[n_entries + 4];
        const double spacing = place.radius / patch;
        for (std::size_t k = 0; k < nodes.size(); ++k)
          {
            if (nodes[k].pair != pair || !std::isfinite(distances[k]))
              continue;
            const double rise = distances[k] - place.distance;
            if (std::abs(rise) < 1e-6 * spacing)
              {
                area_at_once += nodes[k].weight;
                n_at_once += 1.;
              }
            const Row row = unknowns_at(nodes[k].position, place);
            if (2. * row[dim] > place.radius * place.radius || std::abs(rise) > place.radius)
              continue; // too far away, or on the far side of the body
            matrix += row * row.transpose();
            right_hand_side += rise * row;
            squares += rise * rise;
            n_nodes += 1.;
            area += nodes[k].weight;
          }
        Utilities::MPI::sum(sums, communicator, sums);
        touch.node_spacing = std::pow(area / n_nodes, 1. / (dim - 1));
        touch.area         = area_at_once;
        touch.n_at_once    = static_cast<unsigned int>(n_at_once);
        if (squares < std::pow(round * spacing, 2) * n_nodes) // all distances are equal
          {
            touch.is_smooth = true;
            return;
          }
        if (n_nodes < n_unknowns)
          return;
        const Row    solution = matrix.ldlt().solve(Row(right_hand_side));
        const double left     = squares - solution.dot(right_hand_side);
        // The lowest point must be near: a tilted face has hardly any curvature.
        const double slope = solution.template segment<dim - 1>(1).norm();
        touch.is_smooth = left < misfit * misfit * squares && slope < solution[dim] * place.radius;
        if (!touch.is_smooth)
          return;
        touch.curvature = solution[dim];
        // The pole may lie between nodes, where a finer mesh will have one.
        const double lowest = touch.distance - slope * slope / (2. * solution[dim]);
        touch.time          = lowest / touch.speed;
        touch.distance      = std::max(0., lowest);
      }

      /** The functions 1, t, |t|^2 / 2 at a position. */
      static Row unknowns_at(const Point<dim> &position, const Place &place)
      {
        Row row = Row::Zero();
        row[0]  = 1.;
        for (unsigned int t = 0; t + 1 < dim; ++t)
          for (unsigned int c = 0; c < dim; ++c)
            row[1 + t] += place.frame[dim * (t + 1) + c] * (position[c] - place.position[c]);
        row[dim] = row.template segment<dim - 1>(1).squaredNorm() / 2.;
        return row;
      }
    };
  } // namespace


  template <int dim>
  std::vector<FirstTouch> first_touches(const ContactSurface<dim> &surface,
                                        const Vector              &displacement,
                                        const Vector              &velocity,
                                        const MPI_Comm             communicator)
  {
    const Approach<dim>     approach(surface, displacement, velocity, communicator);
    std::vector<FirstTouch> touches;
    for (unsigned int pair = 0; pair < surface.pairs().size(); ++pair)
      touches.push_back(approach.first_touch(pair));
    return touches;
  }


  template std::vector<FirstTouch>
  first_touches(const ContactSurface<2> &, const Vector &, const Vector &, MPI_Comm);
  template std::vector<FirstTouch>
  first_touches(const ContactSurface<3> &, const Vector &, const Vector &, MPI_Comm);
} // namespace signorini
