// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/distance_indicator.h>
#include <signorini/adaptivity/marking.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini
{
  namespace
  {
    /** A threshold that no cell reaches. */
    constexpr double out_of_reach = std::numeric_limits<double>::infinity();


    template <int dim>
    double coarsen_ratio(const AdaptivityParameters &parameters)
    {
      return parameters.coarsen_ratio > 0. ? parameters.coarsen_ratio : smooth_coarsen_ratio<dim>();
    }

    /** Bulk criterion of Doerfler (1996). */
    template <int dim>
    class FixedFraction : public Marking
    {
    public:
      explicit FixedFraction(const AdaptivityParameters &parameters)
        : parameters(parameters)
      {
      }

      MarkingThresholds thresholds(const IndicatorDistribution &distribution) const override
      {
        const double bulk    = distribution.threshold_of_part(parameters.refine_fraction);
        const double coarsen = distribution.threshold_of_rest(parameters.coarsen_fraction);
        const bool   is_good = std::sqrt(distribution.total()) <= parameters.tolerance;
        return {is_good ? out_of_reach : bulk,
                std::min(coarsen, coarsen_ratio<dim>(parameters) * bulk)};
      }

    private:
      const AdaptivityParameters parameters;
    };

    /** Every cell may have the same part of the tolerance. */
    template <int dim>
    class EqualShare : public Marking
    {
    public:
      explicit EqualShare(const AdaptivityParameters &parameters)
        : tolerance(parameters.tolerance)
        , ratio(coarsen_ratio<dim>(parameters))
      {
      }

      MarkingThresholds thresholds(const IndicatorDistribution &distribution) const override
      {
        if (distribution.total() == 0.)
          return {out_of_reach, 0.};
        const double share   = tolerance * tolerance / distribution.n_cells();
        const bool   is_good = std::sqrt(distribution.total()) <= tolerance;
        return {is_good ? out_of_reach : share, ratio * share};
      }

    private:
      const double tolerance, ratio;
    };

    /** Of DistanceIndicator, which is no estimate. */
    template <int dim>
    class FixedThresholds : public Marking
    {
    public:
      MarkingThresholds thresholds(const IndicatorDistribution &) const override
      {
        using Distance = DistanceIndicator<dim>;
        return {Distance::too_close * Distance::too_close,
                Distance::far_enough * Distance::far_enough};
      }
      bool weighs_parts() const override { return false; }
    };
  } // namespace


  template <int dim>
  std::unique_ptr<Marking> make_marking(const AdaptivityParameters &parameters)
  {
    if (parameters.indicator == IndicatorKind::distance)
      return std::make_unique<FixedThresholds<dim>>();
    if (parameters.marking == MarkingKind::tolerance)
      return std::make_unique<EqualShare<dim>>(parameters);
    return std::make_unique<FixedFraction<dim>>(parameters);
  }


  template std::unique_ptr<Marking> make_marking<2>(const AdaptivityParameters &);
  template std::unique_ptr<Marking> make_marking<3>(const AdaptivityParameters &);
} // namespace signorini
