// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/shift_row.h>

#include <boost/container/small_vector.hpp>

#include <Eigen/Dense>

#include <cmath>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** Largest change of a weight of P, as a part of it. */
    constexpr double largest_shift = 0.5;
  } // namespace


  template <int dim>
  void shift_row(ContactNode<dim>     &node,
                 const Tensor<1, dim> &position,
                 const Tensor<1, dim> *of_partners,
                 const Tensor<1, dim> *are_slaves)
  {
    using Shift         = Eigen::Matrix<double, dim - 1, 1>;
    const std::size_t n = node.partners.size();
    Tensor<1, dim>    mean, relative = position;
    double            sum = 0.;
    for (std::size_t l = 0; l < n; ++l)
      {
        const double weight = node.partners[l].second;
        relative -= weight * of_partners[l];
        mean += std::abs(weight) * of_partners[l];
        sum += std::abs(weight);
      }
    mean /= sum;
    std::array<Tensor<1, dim>, dim - 1> tangents;
    for (unsigned int d = 0; d < dim - 1; ++d)
      tangents[d] = node.direction(d + 1);
    const auto along = [&](const Tensor<1, dim> &x) {
      Shift result;
      for (unsigned int d = 0; d < dim - 1; ++d)
        result[d] = tangents[d] * x;
      return result;
    };
    boost::container::small_vector<Shift, 16> offsets;
    Eigen::Matrix<double, dim - 1, dim - 1>   spread =
      Eigen::Matrix<double, dim - 1, dim - 1>::Zero();
    for (std::size_t l = 0; l < n; ++l)
      {
        offsets.push_back(along(of_partners[l] - mean));
        spread += std::abs(node.partners[l].second) * offsets[l] * offsets[l].transpose();
      }
    const Shift a = spread.fullPivLu().solve(along(relative));
    for (const Shift &offset : offsets)
      if (!(std::abs(a.dot(offset)) <= largest_shift))
        return;
    const Tensor<1, dim> normal = node.normal();
    for (std::size_t l = 0; l < n; ++l)
      {
        double      &weight = node.partners[l].second;
        const double change = std::abs(weight) * a.dot(offsets[l]);
        weight += change;
        node.transmission -= change * are_slaves[l][0]; // what stays in the slave
        node.gap += change * (normal * (of_partners[l] - mean));
      }
  }


  template void
  shift_row(ContactNode<2> &, const Tensor<1, 2> &, const Tensor<1, 2> *, const Tensor<1, 2> *);
  template void
  shift_row(ContactNode<3> &, const Tensor<1, 3> &, const Tensor<1, 3> *, const Tensor<1, 3> *);
} // namespace signorini
