// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/system/take_out_motion.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace signorini
{
  namespace
  {
    /** The bodies that free motions couple: for each body the first one of its group. */
    std::vector<Eigen::Index> groups_of_bodies(const Eigen::MatrixXd &projector,
                                               const Eigen::Index     n_motions)
    {
      const Eigen::Index        n_bodies = projector.rows() / n_motions;
      std::vector<Eigen::Index> group(n_bodies);
      for (Eigen::Index i = 0; i < n_bodies; ++i)
        group[i] = i;
      for (Eigen::Index i = 0; i < n_bodies; ++i)
        for (Eigen::Index j = 0; j < i; ++j)
          if (group[i] != group[j]
              && projector.block(i * n_motions, j * n_motions, n_motions, n_motions)
                     .cwiseAbs()
                     .maxCoeff()
                   > 1e-10)
            std::replace(
              group.begin(), group.end(), Eigen::Index(group[i]), Eigen::Index(group[j]));
      return group;
    }


    /** The free motion in contact coordinates, one part for each group of bodies that has one. */
    template <int dim>
    std::vector<Vector> independent_motions(const RigidModes<dim> &rigid,
                                            const Eigen::MatrixXd &free,
                                            const Eigen::VectorXd &amplitudes,
                                            const Vector          &pattern)
    {
      constexpr Eigen::Index          n         = RigidModes<dim>::n_motions;
      const Eigen::MatrixXd           projector = free * free.transpose();
      const Eigen::VectorXd           motion    = projector * amplitudes;
      const std::vector<Eigen::Index> group     = groups_of_bodies(projector, n);
      std::vector<Vector>             parts;
      for (Eigen::Index first = 0; first < static_cast<Eigen::Index>(group.size()); ++first)
        {
          Eigen::VectorXd part = Eigen::VectorXd::Zero(motion.size());
          for (std::size_t body = 0; body < group.size(); ++body)
            if (group[body] == first)
              part.segment(body * n, n) = motion.segment(body * n, n);
          if (part.squaredNorm() == 0.)
            continue;
          parts.push_back(pattern);
          parts.back() = 0.;
          rigid.add_in_contact(part, parts.back());
        }
      return parts;
    }
  } // namespace


  template <int dim>
  void take_out_motion(const RigidModes<dim>         &rigid,
                       const Eigen::MatrixXd         &free,
                       const Eigen::VectorXd         &amplitudes,
                       const ContactCoordinates<dim> &coordinates,
                       const ActiveSet               &status,
                       const NormalGap               &bounds,
                       const double                   tolerance,
                       Vector                        &increment)
  {
    const std::vector<unsigned int> &normals = coordinates.normal_entries();
    AssertDimension(status.size(), normals.size());
    AssertDimension(bounds.size(), normals.size());
    const std::vector<Vector> parts = independent_motions(rigid, free, amplitudes, increment);
    std::vector<unsigned int> stays(parts.size(), 0);
    std::vector<double>       possible(normals.size());
    const auto                goes_towards = [&](const std::size_t part, const std::size_t k) {
      return stays[part] > 0 ? 0. : -parts[part].local_element(normals[k]);
    };
    for (double left = 1.; left > 0.;)
      {
        double step = left;
        for (std::size_t k = 0; k < normals.size(); ++k)
          {
            double speed = 0.;
            for (std::size_t part = 0; part < parts.size(); ++part)
              speed += goes_towards(part, k);
            const double distance = std::max(0., bounds[k] - increment.local_element(normals[k]));
            possible[k]           = speed > tolerance && !contact_status::is_closed(status[k])
                                      ? distance / speed
                                      : std::numeric_limits<double>::infinity();
            step                  = std::min(step, possible[k]);
          }
        step = dealii::Utilities::MPI::min(step, increment.get_mpi_communicator());
        for (std::size_t part = 0; part < parts.size(); ++part)
          if (stays[part] == 0)
            increment.add(-step, parts[part]);
        left -= step;
        std::vector<unsigned int> arrive(stays);
        for (std::size_t k = 0; k < normals.size(); ++k)
          if (possible[k] <= step)
            for (std::size_t part = 0; part < parts.size(); ++part)
              if (goes_towards(part, k) > 0.)
                arrive[part] = 1;
        dealii::Utilities::MPI::max(arrive, increment.get_mpi_communicator(), stays);
      }
  }


#define INSTANTIATE(dim)                                                                           \
  template void take_out_motion(const RigidModes<dim> &,                                           \
                                const Eigen::MatrixXd &,                                           \
                                const Eigen::VectorXd &,                                           \
                                const ContactCoordinates<dim> &,                                   \
                                const ActiveSet &,                                                 \
                                const NormalGap &,                                                 \
                                double,                                                            \
                                Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
