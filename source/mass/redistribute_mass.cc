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
    /** Rows and columns of massless nodes become exactly empty; up to here they may hold round-off. */
    template <int dim>
    void clear_massless_rows(ElasticMatrices<dim> &matrices, const ContactStrip<dim> &strip)
    {
      const NodePattern &pattern     = matrices.pattern;
      const auto         is_massless = [&](const unsigned int node) {
        return strip.is_massless(pattern.partitioner->local_to_global(dim * node) / dim);
      };
      for (unsigned int row = 0; row < pattern.n_local; ++row)
        {
          const bool massless = is_massless(row);
          if (massless && row < pattern.n_owned)
            matrices.massless_nodes.push_back(row);
          for (unsigned int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
            if (massless || is_massless(pattern.columns[k]))
              matrices.mass[k] = 0.;
        }
    }


    template <int dim>
    void build(Discretization<dim> &discretization, const ContactStrip<dim> &strip)
    {
      const std::string &construction = discretization.scene.time.redistribution;
      if (discretization.scene.time.mass == "zero on contact boundary")
        discretization.matrices.standard_mass = discretization.matrices.mass;
      else if (construction == "minimisation")
        minimise_change_of_mass(discretization, strip);
      else if (construction == "macro-elements")
        discretization.assemble(macro_element_mass(discretization, strip));
      else
        discretization.assemble(extrapolated_mass(discretization, strip));
      clear_massless_rows(discretization.matrices, strip);
    }
  } // namespace


  template <int dim>
  std::string redistribute_mass(Discretization<dim> &discretization, const ContactSurface<dim> &surface)
  {
    const TimeParameters &time = discretization.scene.time;
    if (!time.has_massless_contact_nodes())
      return "";
    const std::string head = discretization.scene.file_name + ": Time/Mass = " + time.mass + ": ";
    if (surface.n_global_nodes() == 0)
      throw UserError(head + "no node can come into contact, so that there is no mass to move. Set Mass = consistent"
                      + (time.mass == "redistributed" ? " and another scheme than khenous-laborde-renard and "
                                                        "hager-hueeber-wohlmuth."
                                                      : "."));

    const ContactStrip<dim> strip(discretization, surface);
    build(discretization, strip);

    const double       smallest = MassSolver<dim>(discretization.matrices, {}).smallest_ratio();
    std::ostringstream text;
    text.precision(3);
    text << time.mass;
    if (time.mass == "redistributed")
      text << " by " << time.redistribution;
    if (!(smallest > 0.))
      throw UserError(
        head + "the construction `" + time.redistribution
        + "` gives a mass that is not positive definite on this mesh, and every run with it would blow up. Set "
          "Mass redistribution = extrapolation, which is always positive definite.");
    text << ", smallest eigenvalue " << smallest << " of its diagonal";
    return text.str();
  }


  template std::string redistribute_mass(Discretization<2> &, const ContactSurface<2> &);
  template std::string redistribute_mass(Discretization<3> &, const ContactSurface<3> &);
} // namespace signorini
