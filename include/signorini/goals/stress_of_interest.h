// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_goals_stress_of_interest_h
#define signorini_goals_stress_of_interest_h

#include <signorini/contact/contact_surface.h>
#include <signorini/goals/contact_zones.h>
#include <signorini/model/adaptivity_parameters.h>
#include <signorini/model/contact_description.h>
#include <signorini/model/point_probe.h>
#include <signorini/time/state.h>

#include <deal.II/lac/vector.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace signorini
{
  /** A stress that a mesh is made for. Lives as long as the mesh. */
  template <int dim>
  class StressOfInterest
  {
  public:
    virtual ~StressOfInterest() = default;

    /** As the summary calls it. */
    virtual std::string name() const = 0;

    /** How errors follow from estimates; measured (doc/adaptivity.md). */
    struct Calibration
    {
      double factor, power; ///< relative error = factor estimate^power
    };
    virtual Calibration calibration() const = 0;

    /**
     * Its square now, integrated over the places that it is known at. Collective; the same on all
     * processes.
     */
    virtual double squared_size(const State &state) const = 0;

    /**
     * The same of a stress as it is usual now: what is small beside it, as a place that no wave has
     * come to yet, need not be known any better. Not negative. Collective.
     */
    virtual double usual_squared_size(const State &) const { return 0.; }

    /** Whether it is of interest when nothing touches this body any more, but something has. */
    virtual bool lasts_in(const unsigned int /*body*/) const { return false; }

    /**
     * What the errors of cells do to it, squared, in the same unit and but for the calibration:
     * collective, by active_cell_index.
     *
     * The residual of a cell of size h, whose squared estimate is eta^2 = h^(2+dim) r^2/mu with the
     * residual r per volume, acts at the distance d like what a smooth field cannot see of a force:
     * second derivatives of the influence of a force on a stress, which are as 1/d^(dim+1). So the
     * error of the stress there is sqrt(mu) eta h^(1+dim/2) / d^(dim+1), and within the cell itself
     * sqrt(mu) eta/h^(dim/2), its mean error: dual-weighted residuals (Becker and Rannacher, Acta
     * Numerica 10, 2001), with what is known of the dual solution instead of one that is computed.
     *
     * @param squares eta_T^2 at rest
     */
    virtual dealii::Vector<double> squared_errors(const State                  &state,
                                                  const ContactZones<dim>      &zones,
                                                  const dealii::Vector<double> &squares) const = 0;
  };


  template <int dim>
  using Stresses = std::vector<std::unique_ptr<StressOfInterest<dim>>>;

  /** Those of a goal, in the order of the probes. Collective. @throws UserError as probes */
  template <int dim>
  Stresses<dim> stresses_of_interest(GoalKind                                       goal,
                                     const std::vector<ProbeDescription<dim>>      &probes,
                                     const std::vector<PointProbeDescription<dim>> &point_probes,
                                     const Discretization<dim>                     &discretization,
                                     const ContactSurface<dim>                     &surface);

  /** The pressure of all contact surfaces, or of those of one pair: p^2 integrated over them. */
  template <int dim>
  std::unique_ptr<StressOfInterest<dim>>
  make_contact_pressure(const Discretization<dim>  &discretization,
                        const ContactSurface<dim>  &surface,
                        std::optional<unsigned int> pair = std::nullopt);

  /**
   * The pressure at the contact node of a probe. All nodes of a pair in contact share its force, so
   * that the error is the mean one of the contact. Collective.
   * @throws UserError as Probe
   */
  template <int dim>
  std::unique_ptr<StressOfInterest<dim>>
  make_probed_stress(const ProbeDescription<dim> &probe,
                     const Discretization<dim>   &discretization,
                     const ContactSurface<dim>   &surface);

  /**
   * The stress at a point of a body: sigma:sigma. Collective.
   * @throws UserError as PointProbe
   */
  template <int dim>
  std::unique_ptr<StressOfInterest<dim>>
  make_probed_stress(const PointProbeDescription<dim> &probe,
                     const Discretization<dim>        &discretization);
} // namespace signorini

#endif
