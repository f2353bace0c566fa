// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/own_forces.h>
#include <signorini/diagnostics/probe.h>
#include <signorini/goals/contact_zones.h>
#include <signorini/goals/stress_of_interest.h>
#include <signorini/output/point_probe.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    /**
     * Squared estimates in units of the squared error in the energy norm, all over a body. The
     * factors of calibration() were measured with it. That of the force is another one, which small
     * contacts have a part in.
     */
    template <int dim>
    constexpr double effectivity_of_waves = dim == 2 ? 15. : 65.;


    /** What cells of a body do to the stress at a point of it. */
    template <int dim>
    dealii::Vector<double> squared_errors_at(const dealii::Point<dim>     &point,
                                             const unsigned int            body,
                                             const Mesh<dim>              &mesh,
                                             const dealii::Vector<double> &squares)
    {
      dealii::Vector<double> result(squares.size());
      const double           mu = mesh.bodies()[body].material.mu();
      for (const auto &cell : mesh.active_cells())
        if (cell->is_locally_owned() && cell->material_id() == body)
          {
            const unsigned int index = cell->active_cell_index();
            const double       h     = cell->diameter() / std::sqrt(double(dim));
            const double       d     = std::max(cell->center().distance(point), h);
            result(index) = squares(index) * mu / std::pow(h, dim) * std::pow(h / d, 2 * dim + 2);
          }
      return result;
    }


    template <int dim>
    class PressureAtProbe : public StressOfInterest<dim>
    {
    public:
      PressureAtProbe(const ProbeDescription<dim> &description,
                      const Discretization<dim>   &discretization,
                      const ContactSurface<dim>   &surface)
        : probe(description, surface, discretization.communicator())
        , surface(surface)
        , of_pair(make_contact_pressure(discretization, surface, probe.pair()))
      {
      }

      typename StressOfInterest<dim>::Calibration calibration() const override
      {
        return {dim == 2 ? 0.14 : 0.06, 1.5};
      }

      std::string name() const override
      {
        return "the pressure at the probe '" + probe.name() + "'";
      }

      double squared_size(const State &state) const override
      {
        return state.contact_force.size() > 0 ? std::pow(probe.read(state).pressure, 2) : 0.;
      }

      /** The mean of the contact, if the probe is in contact: at its edge the pressure is zero. */
      double usual_squared_size(const State &state) const override
      {
        const double area = squared_size(state) > 0. ? loaded_area(state) : 0.;
        return area > 0. ? of_pair->squared_size(state) / area : 0.;
      }

      dealii::Vector<double> squared_errors(const State                  &state,
                                            const ContactZones<dim>      &zones,
                                            const dealii::Vector<double> &squares) const override
      {
        dealii::Vector<double> result = of_pair->squared_errors(state, zones, squares);
        if (const double area = loaded_area(state); area > 0.)
          result /= area;
        return result;
      }

    private:
      const Probe<dim>                             probe;
      const ContactSurface<dim>                   &surface;
      const std::unique_ptr<StressOfInterest<dim>> of_pair;

      /** What the force would need to have the same square with a constant pressure. */
      double loaded_area(const State &state) const
      {
        if (state.contact_force.size() == 0)
          return 0.;
        double       force = 0.;
        const Vector own   = own_forces(surface, state.contact_force);
        for (const ContactNode<dim> &node : surface.nodes())
          if (node.pair == probe.pair())
            force += std::abs(node.normal_force(own));
        force = dealii::Utilities::MPI::sum(force, own.get_mpi_communicator());
        return force > 0. ? std::pow(force, 2) / of_pair->squared_size(state) : 0.;
      }
    };


    /**
     * Of bodies: the mean of sigma:sigma is at least four times the shear modulus times the elastic
     * energy per volume, which it is in shear.
     */
    template <int dim>
    std::vector<double> squared_mean_stresses(const Discretization<dim> &discretization,
                                              const std::vector<double> &volumes,
                                              const State               &state)
    {
      const auto          bodies = discretization.bodies_of_nodes();
      std::vector<double> result(volumes.size(), 0.);
      for (unsigned int node = 0; node < discretization.matrices().pattern.n_owned; ++node)
        if (bodies[node] < result.size()) // hanging nodes are of none
          for (unsigned int i = dim * node; i < dim * (node + 1); ++i)
            result[bodies[node]] +=
              state.displacement.local_element(i) * state.internal_force.local_element(i);
      dealii::Utilities::MPI::sum(result, discretization.communicator(), result);
      for (unsigned int body = 0; body < result.size(); ++body)
        {
          const double mu = discretization.mesh().bodies()[body].material.mu();
          result[body]    = std::max(0., 2. * mu * result[body] / volumes[body]);
        }
      return result;
    }


    template <int dim>
    class StressAtPoint : public StressOfInterest<dim>
    {
    public:
      StressAtPoint(const PointProbeDescription<dim> &description,
                    const Discretization<dim>        &discretization)
        : description(description)
        , discretization(discretization)
        , probe(description, discretization)
        , volumes(discretization.mesh().volumes_of_bodies())
      {
      }

      typename StressOfInterest<dim>::Calibration calibration() const override
      {
        return {factor, 1.};
      }

      bool lasts_in(const unsigned int body) const override { return body == description.body; }

      double usual_squared_size(const State &state) const override
      {
        const std::vector<double> means = squared_mean_stresses(discretization, volumes, state);
        const double              most  = *std::max_element(means.begin(), means.end());
        return std::max(means[description.body], negligible * negligible * most);
      }

      std::string name() const override
      {
        return "the stress at the probe '" + description.name + "'";
      }

      double squared_size(const State &state) const override
      {
        const PointReading reading =
          probe.read(discretization.interpolate_hanging_nodes(state.displacement),
                     discretization.interpolate_hanging_nodes(state.velocity));
        double result = 0.;
        for (unsigned int c = 0; c < 6; ++c) // those beside the diagonal are there twice
          result += (c < 3 ? 1. : 2.) * std::pow(reading.stress[c], 2);
        return result;
      }

      /**
       * And waves bring the errors of cells that are far from contact to wherever it is, with their
       * mean, for which no calibration is needed: it is divided out.
       */
      dealii::Vector<double> squared_errors(const State &,
                                            const ContactZones<dim>      &zones,
                                            const dealii::Vector<double> &squares) const override
      {
        const Mesh<dim> &mesh = discretization.mesh();
        const double     mean_of_waves =
          2. * shear_modulus()
          / (effectivity_of_waves<dim> * volumes[description.body] * factor * factor);
        dealii::Vector<double> result =
          squared_errors_at(description.point, description.body, mesh, squares);
        for (const auto &cell : mesh.active_cells())
          if (cell->is_locally_owned() && cell->material_id() == description.body
              && zones.is_far(cell))
            result(cell->active_cell_index()) += mean_of_waves * squares(cell->active_cell_index());
        return result;
      }

    private:
      static constexpr double factor = dim == 2 ? 0.4 : 0.1;

      /** Of the mean stress in the body that has most: below is what no wave has brought. */
      static constexpr double negligible = 0.01;

      double shear_modulus() const
      {
        return discretization.mesh().bodies()[description.body].material.mu();
      }

      const PointProbeDescription<dim> description;
      const Discretization<dim>       &discretization;
      const PointProbe<dim>            probe;
      const std::vector<double>        volumes; ///< of bodies
    };
  } // namespace


  template <int dim>
  std::unique_ptr<StressOfInterest<dim>>
  make_probed_stress(const ProbeDescription<dim> &probe,
                     const Discretization<dim>   &discretization,
                     const ContactSurface<dim>   &surface)
  {
    return std::make_unique<PressureAtProbe<dim>>(probe, discretization, surface);
  }


  template <int dim>
  std::unique_ptr<StressOfInterest<dim>>
  make_probed_stress(const PointProbeDescription<dim> &probe,
                     const Discretization<dim>        &discretization)
  {
    return std::make_unique<StressAtPoint<dim>>(probe, discretization);
  }


#define INSTANTIATE(dim)                                                                           \
  template std::unique_ptr<StressOfInterest<dim>> make_probed_stress(                              \
    const ProbeDescription<dim> &, const Discretization<dim> &, const ContactSurface<dim> &);      \
  template std::unique_ptr<StressOfInterest<dim>> make_probed_stress(                              \
    const PointProbeDescription<dim> &, const Discretization<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
