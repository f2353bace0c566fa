// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/obstacles/integral_of_rate.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <cmath>

namespace signorini
{
  namespace
  {
    constexpr double next_to_nothing = 1e-9; ///< of a panel: round-off of times
  }


  IntegralOfRate::IntegralOfRate(std::function<double(double)> rate,
                                 const bool                    varies,
                                 const double                  panel)
    : rate(std::move(rate))
    , varies(varies)
    , panel(panel)
    , up_to(1, 0.)
  {
    Assert(panel > 0., dealii::ExcMessage("A panel has a length."));
  }


  double IntegralOfRate::operator()(const double time)
  {
    Assert(time >= 0., dealii::ExcMessage("The motion begins at time 0."));
    if (!varies)
      return time * rate(0.);
    const std::size_t k = std::llround(time / panel); // steps end at panels, but for round-off
    while (up_to.size() <= k)
      up_to.push_back(up_to.back() + between((up_to.size() - 1) * panel, up_to.size() * panel));
    return up_to[k] + between(k * panel, time);
  }


  std::vector<double>
  IntegralOfRate::over_parts(const double start, const double end, const unsigned int n_parts) const
  {
    const double size = (end - start) / n_parts;
    if (!varies)
      return std::vector<double>(n_parts, size * rate(0.));
    std::vector<double> result;
    for (unsigned int k = 0; k < n_parts; ++k)
      {
        const double first = start + k * size;
        result.push_back(size / 6.
                         * (rate(first) + 4. * rate(first + 0.5 * size) + rate(first + size)));
      }
    return result;
  }


  double IntegralOfRate::between(const double start, const double end) const
  {
    if (std::abs(end - start) < next_to_nothing * panel)
      return (end - start) * rate(start);
    // A constant and all polynomials that one may think of are exact at once.
    return boost::math::quadrature::gauss_kronrod<double, 15>::integrate(
      rate, start, end, 12, 1e-13);
  }
} // namespace signorini
