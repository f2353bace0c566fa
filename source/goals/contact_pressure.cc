// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/own_forces.h>
#include <signorini/goals/contact_zones.h>
#include <signorini/goals/distance_to_places.h>
#include <signorini/goals/stress_of_interest.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  namespace
  {
    template <int dim>
    class ContactPressure : public StressOfInterest<dim>
    {
    public:
      ContactPressure(const Discretization<dim>        &discretization,
                      const ContactSurface<dim>        &surface,
                      const std::optional<unsigned int> pair)
        : discretization(discretization)
        , surface(surface)
        , pair(pair)
      {
      }

      std::string name() const override { return "the contact pressure"; }

      /** Nodal pressures are means over areas, which are better than the stress in the cells. */
      typename StressOfInterest<dim>::Calibration calibration() const override
      {
        return {dim == 2 ? 0.28 : 0.12, 1.5};
      }

      double squared_size(const State &state) const override
      {
        double result = 0.;
        if (state.contact_force.size() > 0)
          {
            const Vector own = own_forces(surface, state.contact_force);
            for (const ContactNode<dim> &node : surface.nodes())
              if (!pair || node.pair == *pair)
                result += std::pow(node.normal_force(own), 2) / node.weight;
          }
        return dealii::Utilities::MPI::sum(result, discretization.communicator());
      }

      /**
       * Squared errors at the distance d from a plane of contact, integrated over it, are as
       * 1/d^(dim+3), and as 1/d^(2 dim+2) where its size a is small from there.
       */
      dealii::Vector<double> squared_errors(const State &,
                                            const ContactZones<dim>      &zones,
                                            const dealii::Vector<double> &squares) const override
      {
        const Mesh<dim>            &mesh = discretization.mesh();
        const DistanceToPlaces<dim> distance(mesh, zones.cells());
        dealii::Vector<double>      result(squares.size());
        for (const auto &cell : mesh.active_cells())
          if (cell->is_locally_owned() && zones.touches(cell->material_id())
              && is_of_pair(cell->material_id()))
            {
              const unsigned int body = cell->material_id(), index = cell->active_cell_index();
              const double       h = cell->diameter() / std::sqrt(double(dim));
              const double       d = std::max(distance(cell), h);
              const double       a = std::max(zones.size(body), h);
              result(index)        = squares(index) * mesh.bodies()[body].material.mu() / h
                              * std::pow(h / d, dim + 3) * std::pow(std::min(1., a / d), dim - 1);
            }
        return result;
      }

    private:
      const Discretization<dim>        &discretization;
      const ContactSurface<dim>        &surface;
      const std::optional<unsigned int> pair; ///< none: all

      bool is_of_pair(const unsigned int body) const
      {
        if (!pair)
          return true;
        const auto &bodies = surface.pairs()[*pair];
        return bodies.slave == body || (bodies.of_two_bodies() && bodies.master == body);
      }
    };
  } // namespace


  template <int dim>
  std::unique_ptr<StressOfInterest<dim>>
  make_contact_pressure(const Discretization<dim>        &discretization,
                        const ContactSurface<dim>        &surface,
                        const std::optional<unsigned int> pair)
  {
    return std::make_unique<ContactPressure<dim>>(discretization, surface, pair);
  }


  template std::unique_ptr<StressOfInterest<2>> make_contact_pressure(const Discretization<2> &,
                                                                      const ContactSurface<2> &,
                                                                      std::optional<unsigned int>);
  template std::unique_ptr<StressOfInterest<3>> make_contact_pressure(const Discretization<3> &,
                                                                      const ContactSurface<3> &,
                                                                      std::optional<unsigned int>);
} // namespace signorini
