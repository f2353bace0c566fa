// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/mass/extrapolated_mass.h>
#include <signorini/mass/macro_element_mass.h>
#include <signorini/mass/mass_solver.h>
#include <signorini/mass/minimised_mass.h>
#include <signorini/mass/redistribute_mass.h>

#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /**
     * Rows and columns of massless nodes become exactly empty; up to here they may hold round-off.
     * Macro-elements take the mass of all nodes of the contact surface, also of those whose normal
     * displacement is prescribed.
     */
    template <int dim>
    void clear_massless_rows(ElasticMatrices<dim> &matrices, const ContactStrip<dim> &strip)
    {
      const NodePattern &pattern = matrices.pattern;
      std::vector<bool>  is_massless(pattern.n_local);
      for (unsigned int node = 0; node < pattern.n_local; ++node)
        if (!pattern.is_empty(node))
          {
            const unsigned int diagonal = pattern.row_start[node];
            is_massless[node] =
              strip.is_massless(pattern.partitioner->local_to_global(dim * node) / dim)
              || std::abs(matrices.mass[diagonal]) < 1e-10 * matrices.standard_mass[diagonal];
          }
      for (unsigned int row = 0; row < pattern.n_local; ++row)
        {
          const bool massless = is_massless[row];
          if (massless && row < pattern.n_owned)
            matrices.massless_nodes.push_back(row);
          for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
            if (massless || is_massless[pattern.columns[k]])
              matrices.mass[k] = 0.;
        }
    }


    /**
     * Every body with contact nodes needs others, too: a body without any mass would not move but
     * jump.
     */
    template <int dim>
    void check_that_mass_is_left(const Discretization<dim> &discretization,
                                 const ContactStrip<dim>   &strip,
                                 const std::string         &head)
    {
      const auto               &bodies = discretization.mesh().bodies();
      std::vector<unsigned int> has_mass(bodies.size(), 0);
      for (const auto &cell : discretization.cells())
        if (cell->is_locally_owned())
          for (const unsigned int v : cell->vertex_indices())
            if (const auto dof = cell->vertex_dof_index(v, 0);
                !discretization.hanging_node_constraints().is_constrained(dof)
                && !strip.is_massless(dof / dim))
              has_mass[cell->material_id()] = 1;
      Utilities::MPI::max(has_mass, discretization.communicator(), has_mass);
      for (unsigned int body = 0; body < bodies.size(); ++body)
        if (!has_mass[body])
          throw UserError(head + "all nodes of the body '" + bodies[body].name
                          + "' are contact nodes, so that it would have no mass at all. Increase "
                            "Refinements or Repetitions.");
    }


    template <int dim>
    void build(Discretization<dim>     &discretization,
               const ContactStrip<dim> &strip,
               const MassParameters    &mass)
    {
      if (mass.kind == MassKind::zero_on_contact_boundary)
        discretization.matrices().standard_mass = discretization.matrices().mass;
      else if (mass.redistribution == MassRedistribution::minimisation)
        minimise_change_of_mass(discretization, strip);
      else if (mass.redistribution == MassRedistribution::macro_elements)
        discretization.change_mass(macro_element_mass(discretization, strip));
      else
        discretization.change_mass(extrapolated_mass(discretization, strip));
      clear_massless_rows(discretization.matrices(), strip);
    }
  } // namespace


  template <int dim>
  std::string redistribute_mass(Discretization<dim>       &discretization,
                                const ContactSurface<dim> &surface,
                                const MassParameters      &mass)
  {
    if (!mass.has_massless_contact_nodes())
      return "";

    const std::string head = "Time/Mass = " + name_of(mass.kind) + ": ";
    if (surface.n_global_nodes() == 0)
      throw UserError(
        head
        + "no node can come into contact (no pair, nothing faces an obstacle, or all nodes are "
          "prescribed), so that there is no mass to move. Set `Mass = consistent`, and a scheme "
          "that does not need massless contact nodes (see `signorini --print-schemes`).");

    const ContactStrip<dim> strip(discretization, surface);
    check_that_mass_is_left(discretization, strip, head);
    build(discretization, strip, mass);

    const double       smallest = MassSolver<dim>(discretization.matrices(), {}).smallest_ratio();
    std::ostringstream text;
    text.precision(3);
    text << name_of(mass.kind);
    if (mass.kind == MassKind::redistributed)
      text << " by " << name_of(mass.redistribution);
    if (!(smallest > 0.))
      throw UserError(head + "the construction `" + name_of(mass.redistribution)
                      + "` gives a mass that is not positive definite on this mesh, and every run "
                        "with it would blow up. Set Mass redistribution = extrapolation, which is "
                        "always positive definite.");
    text << ", smallest eigenvalue " << smallest << " of its diagonal";
    return text.str();
  }


  template std::string
  redistribute_mass(Discretization<2> &, const ContactSurface<2> &, const MassParameters &);
  template std::string
  redistribute_mass(Discretization<3> &, const ContactSurface<3> &, const MassParameters &);
} // namespace signorini
