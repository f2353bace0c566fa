// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/diagnostics/rigid_flight.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double       never          = std::numeric_limits<double>::infinity();
    constexpr unsigned int most_looks     = 200;  ///< of equal length in a duration
    constexpr unsigned int refinements    = 8;    ///< of the time of a touch, each by a bisection
    constexpr double       touching       = 1e-9; ///< of the size of the bodies
    constexpr double       reach_of_looks = 0.25; ///< the same

    /** The longest nodal vector of each body. Collective. */
    template <int dim>
    std::vector<double> largest_norms(const Vector                    &vector,
                                      const std::vector<unsigned int> &body_of_node,
                                      const unsigned int               n_bodies,
                                      const MPI_Comm                   communicator)
    {
      std::vector<double> norms(n_bodies, 0.);
      for (unsigned int node = 0; node < body_of_node.size(); ++node)
        if (body_of_node[node] < n_bodies)
          {
            double square = 0.;
            for (unsigned int c = 0; c < dim; ++c)
              square += std::pow(vector.local_element(dim * node + c), 2);
            norms[body_of_node[node]] = std::max(norms[body_of_node[node]], std::sqrt(square));
          }
      Utilities::MPI::max(norms, communicator, norms);
      return norms;
    }


    /** Sums of nodal forces over each body. Collective. */
    template <int dim>
    std::vector<double> resultants(const Vector                    &forces,
                                   const std::vector<unsigned int> &body_of_node,
                                   const unsigned int               n_bodies,
                                   const MPI_Comm                   communicator)
    {
      std::vector<double> sums(dim * n_bodies, 0.);
      for (unsigned int node = 0; node < body_of_node.size(); ++node)
        if (body_of_node[node] < n_bodies)
          for (unsigned int c = 0; c < dim; ++c)
            sums[dim * body_of_node[node] + c] += forces.local_element(dim * node + c);
      Utilities::MPI::sum(sums, communicator, sums);
      return sums;
    }


    /** The bodies of a pair: twice the slave if there is no other. */
    std::array<unsigned int, 2> bodies_of(const PairDescription &pair)
    {
      return {{pair.slave, pair.of_two_bodies() ? pair.master : pair.slave}};
    }


    /** Looks for the times of meeting, one after the other. */
    template <int dim>
    class Search
    {
    public:
      Search(ContactSurface<dim>       &surface,
             const Discretization<dim> &discretization,
             const RigidFlight<dim>    &flight,
             const double               start_time)
        : surface(surface)
        , pairs(surface.pairs())
        , communicator(discretization.communicator())
        , size(discretization.mesh().body_size())
        , flight(flight)
        , start_time(start_time)
        , is_open(pairs.size(), true)
        , times(pairs.size(), never)
      {
      }

      std::vector<double> times_until(const double duration, const bool obstacles_move)
      {
        const double shortest = duration / most_looks;
        look(0.);
        meet(0.);
        for (double now = 0.; now < duration && any_is_open();)
          {
            // Obstacles that move have speeds of their own.
            double next = now + (obstacles_move ? shortest : safe_time(now, shortest, duration));
            next        = std::min(next, duration);
            look(next);
            if (any_meets())
              {
                bisect(now, next);
                meet(now);
              }
            now = next;
          }
        surface.move_obstacles(start_time, start_time);
        return times;
      }

    private:
      ContactSurface<dim>                &surface;
      const std::vector<PairDescription> &pairs;
      const MPI_Comm                      communicator;
      const double                        size;
      const RigidFlight<dim>             &flight;
      const double                        start_time;
      std::vector<bool>                   is_open; ///< has not met, and nothing has met its bodies
      std::vector<double>                 times;
      std::vector<double>                 distances; ///< of pairs, at the latest look

      void look(const double time)
      {
        surface.move_obstacles(start_time + time, start_time + time);
        distances = distances_of_pairs(
          surface, flight.displacement(time), reach_of_looks * size, communicator);
      }

      bool any_is_open() const
      {
        return std::find(is_open.begin(), is_open.end(), true) != is_open.end();
      }

      bool meets(const std::size_t p) const
      {
        return is_open[p] && distances[p] <= touching * size;
      }

      bool any_meets() const
      {
        for (std::size_t p = 0; p < pairs.size(); ++p)
          if (meets(p))
            return true;
        return false;
      }

      /** From a look at which some meet, back to the begin of it. */
      void bisect(double &now, double &next)
      {
        for (unsigned int i = 0; i < refinements; ++i)
          {
            const double middle = 0.5 * (now + next);
            look(middle);
            (any_meets() ? next : now) = middle;
          }
        look(next);
      }

      /** What meets at the latest look has met, and its bodies go other ways from then on. */
      void meet(const double time)
      {
        std::vector<unsigned int> disturbed;
        for (std::size_t p = 0; p < pairs.size(); ++p)
          if (meets(p))
            {
              times[p]   = time;
              is_open[p] = false;
              if (time > 0.)
                for (const unsigned int body : bodies_of(pairs[p]))
                  disturbed.push_back(body);
            }
        for (std::size_t p = 0; p < pairs.size(); ++p)
          for (const unsigned int body : bodies_of(pairs[p]))
            if (std::find(disturbed.begin(), disturbed.end(), body) != disturbed.end())
              is_open[p] = false;
      }

      /** The longest time in which no pair can close its distance, or nearly, from below. */
      double safe_time(const double now, const double shortest, const double longest) const
      {
        double result = longest;
        for (std::size_t p = 0; p < pairs.size(); ++p)
          while (is_open[p] && result > shortest && way(p, now, now + result) > distances[p])
            result *= 0.8;
        return std::max(result, shortest);
      }

      double way(const std::size_t p, const double begin, const double end) const
      {
        double sum = flight.way(pairs[p].slave, begin, end);
        if (pairs[p].of_two_bodies())
          sum += flight.way(pairs[p].master, begin, end);
        return sum;
      }
    };
  } // namespace


  template <int dim>
  RigidFlight<dim>::RigidFlight(const Discretization<dim> &discretization,
                                const State               &start,
                                const Vector              *load,
                                const std::vector<double> &masses,
                                const std::vector<bool>   &falls)
    : start(start)
    , acceleration(discretization.make_vector())
  {
    const MPI_Comm     communicator = discretization.communicator();
    const auto         body_of_node = discretization.bodies_of_nodes();
    const unsigned int n_bodies     = falls.size();
    if (load != nullptr)
      {
        const auto forces = resultants<dim>(*load, body_of_node, n_bodies, communicator);
        for (unsigned int node = 0; node < body_of_node.size(); ++node)
          if (body_of_node[node] < n_bodies && falls[body_of_node[node]])
            for (unsigned int c = 0; c < dim; ++c)
              acceleration.local_element(dim * node + c) =
                forces[dim * body_of_node[node] + c] / masses[body_of_node[node]];
      }
    speeds        = largest_norms<dim>(start.velocity, body_of_node, n_bodies, communicator);
    accelerations = largest_norms<dim>(acceleration, body_of_node, n_bodies, communicator);
  }


  template <int dim>
  Vector RigidFlight<dim>::displacement(const double time) const
  {
    Vector result = start.displacement;
    result.add(time, start.velocity, 0.5 * time * time, acceleration);
    return result;
  }


  template <int dim>
  Vector RigidFlight<dim>::velocity(const double time) const
  {
    Vector result = start.velocity;
    result.add(time, acceleration);
    return result;
  }


  template <int dim>
  double RigidFlight<dim>::way(const unsigned int body, const double begin, const double end) const
  {
    return (end - begin) * (speeds[body] + 0.5 * (begin + end) * accelerations[body]);
  }


  template <int dim>
  std::vector<double> distances_of_pairs(const ContactSurface<dim> &surface,
                                         const Vector              &displacement,
                                         const double               reach,
                                         const MPI_Comm             communicator)
  {
    std::vector<double> result(surface.pairs().size(), reach);
    for (const ContactNode<dim> &node : surface.near_nodes(displacement, reach))
      result[node.pair] = std::min(result[node.pair], node.gap);
    Utilities::MPI::min(result, communicator, result);
    return result;
  }


  template <int dim>
  std::vector<double> times_of_meeting(ContactSurface<dim>       &surface,
                                       const Discretization<dim> &discretization,
                                       const RigidFlight<dim>    &flight,
                                       const double               start_time,
                                       const double               duration,
                                       const bool                 obstacles_move)
  {
    return Search<dim>(surface, discretization, flight, start_time)
      .times_until(duration, obstacles_move);
  }


#define INSTANTIATE(dim)                                                                           \
  template class RigidFlight<dim>;                                                                 \
  template std::vector<double> distances_of_pairs(                                                 \
    const ContactSurface<dim> &, const Vector &, double, MPI_Comm);                                \
  template std::vector<double> times_of_meeting(ContactSurface<dim> &,                             \
                                                const Discretization<dim> &,                       \
                                                const RigidFlight<dim> &,                          \
                                                double,                                            \
                                                double,                                            \
                                                bool);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
