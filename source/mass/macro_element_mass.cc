// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/mass/macro_element_mass.h>
#include <signorini/mass/quadratic_moments.h>

#include <deal.II/base/geometry_info.h>

#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    [[noreturn]] void
    fail(const Point<dim> &place, const std::string &reason, const std::string &remedy)
    {
      std::ostringstream message;
      message << "Time/Mass redistribution = macro-elements: " << reason << " at (" << place
              << "). " << remedy;
      throw UserError(message.str());
    }


    /**
     * Cells without contact nodes that share most vertices with a cell at the boundary; the
     * nearest one of them.
     */
    template <int dim>
    unsigned int cell_behind(const ContactStrip<dim> &strip, const unsigned int strip_cell)
    {
      const StripCell<dim>                &cell = strip.cells[strip_cell];
      std::map<unsigned int, unsigned int> n_shared;
      for (const auto node : cell.nodes)
        if (node != StripCell<dim>::hanging && !strip.is_massless(node))
          for (const unsigned int k : strip.cells_of_node.at(node))
            ++n_shared[k];
      unsigned int best = numbers::invalid_unsigned_int, most = 0;
      double       nearest = 0.;
      for (const auto &[k, n] : n_shared)
        {
          const auto &nodes = strip.cells[k].nodes;
          if (std::any_of(nodes.begin(), nodes.end(), [&](const auto node) {
                return strip.is_massless(node);
              }))
            continue;
          const double distance = strip.cells[k].centre().distance(cell.centre());
          if (n > most || (n == most && distance < nearest * (1. - 1e-10)))
            {
              best    = k;
              most    = n;
              nearest = distance;
            }
        }
      if (best == numbers::invalid_unsigned_int)
        fail(cell.centre(),
             "there is no cell behind the one at the contact boundary",
             "The body needs at least two layers of cells there: increase Refinements or "
             "Repetitions.");
      return best;
    }


    /**
     * Take the element matrices of the cells of a macro-element out of the mass.
     * @return their quadratic moments
     */
    template <int dim>
    typename QuadraticMoments<dim>::Values take_out(const ContactStrip<dim>         &strip,
                                                    const std::vector<unsigned int> &members,
                                                    const QuadraticMoments<dim>     &quadratics,
                                                    MassChange                      &change)
    {
      constexpr unsigned int                 n_vertices = StripCell<dim>::n_vertices;
      typename QuadraticMoments<dim>::Values moments    = QuadraticMoments<dim>::Values::Zero();
      for (const unsigned int k : members)
        for (unsigned int a = 0; a < n_vertices; ++a)
          for (unsigned int b = 0; b < n_vertices; ++b)
            {
              const StripCell<dim> &member = strip.cells[k];
              const double          mass   = member.mass[a * n_vertices + b];
              if (member.nodes[a] == StripCell<dim>::hanging
                  || member.nodes[b] == StripCell<dim>::hanging)
                fail(member.vertices[a],
                     "a cell near the contact boundary has a hanging node",
                     "Take Mass redistribution = extrapolation, or refine uniformly there.");
              moments += mass * quadratics.at(member.vertices[a], member.vertices[b]);
              change[{member.nodes[a], member.nodes[b]}] -= mass;
            }
      return moments;
    }


    /**
     * Simpson's rule on a cell: the shape functions at its points, and its weights, times the mass
     * of the cell.
     */
    template <int dim>
    struct SimpsonsRule
    {
      static constexpr unsigned int n_points   = dim == 2 ? 9 : 27,
                                    n_vertices = StripCell<dim>::n_vertices;

      std::array<std::array<double, n_vertices>, n_points> shapes;
      std::array<Point<dim>, n_points>                     points;
      std::array<double, n_points>                         weights;

      explicit SimpsonsRule(const StripCell<dim> &cell)
      {
        double cell_mass = 0.;
        for (const double mass : cell.mass)
          cell_mass += mass;
        for (unsigned int q = 0; q < n_points; ++q)
          {
            Point<dim> xi;
            weights[q] = cell_mass;
            for (unsigned int c = 0, rest = q; c < dim; ++c, rest /= 3)
              {
                xi[c] = 0.5 * (rest % 3);
                weights[q] *= rest % 3 == 1 ? 4. / 6. : 1. / 6.;
              }
            for (unsigned int v = 0; v < n_vertices; ++v)
              {
                shapes[q][v] = GeometryInfo<dim>::d_linear_shape_function(xi, v);
                points[q] += shapes[q][v] * cell.vertices[v];
              }
          }
      }
    };


    /**
     * The mass matrix of a macro-element on the nodes of the cell behind, minus the element
     * matrices of its cells.
     */
    template <int dim>
    void exchange_mass(const ContactStrip<dim>         &strip,
                       const unsigned int               behind,
                       const std::vector<unsigned int> &at_boundary,
                       MassChange                      &change)
    {
      using Moments                    = typename QuadraticMoments<dim>::Values;
      const StripCell<dim>       &cell = strip.cells[behind];
      const QuadraticMoments<dim> quadratics{cell.centre(),
                                             cell.vertices[0].distance(cell.centre())};
      std::vector<unsigned int>   members = at_boundary;
      members.push_back(behind);
      const Moments wanted = take_out(strip, members, quadratics, change);

      // The weights w of Simpson's rule on the cell behind become w (1 + p) with a quadratic
      // polynomial p.
      const SimpsonsRule<dim>                                                       rule(cell);
      std::array<Moments, SimpsonsRule<dim>::n_points>                              values;
      Eigen::Matrix<double, Moments::RowsAtCompileTime, Moments::RowsAtCompileTime> gram;
      gram.setZero();
      Moments before = Moments::Zero();
      for (unsigned int q = 0; q < rule.n_points; ++q)
        {
          values[q] = quadratics.at(rule.points[q], rule.points[q]);
          before += rule.weights[q] * values[q];
          gram += rule.weights[q] * values[q] * values[q].transpose();
        }
      const Moments polynomial = gram.fullPivLu().solve(wanted - before);
      for (unsigned int q = 0; q < rule.n_points; ++q)
        {
          const double weight = rule.weights[q] * (1. + polynomial.dot(values[q]));
          for (unsigned int a = 0; a < rule.n_vertices; ++a)
            for (unsigned int b = 0; b < rule.n_vertices; ++b)
              change[{cell.nodes[a], cell.nodes[b]}] +=
                weight * rule.shapes[q][a] * rule.shapes[q][b];
        }
    }
  } // namespace


  template <int dim>
  MassChange macro_element_mass(const Discretization<dim> &discretization,
                                const ContactStrip<dim>   &strip)
  {
    std::map<unsigned int, std::vector<unsigned int>>
      macro_elements; // cell behind -> cells at the boundary
    for (unsigned int k = 0; k < strip.cells.size(); ++k)
      {
        const auto &nodes = strip.cells[k].nodes;
        if (std::any_of(
              nodes.begin(), nodes.end(), [&](const auto node) { return strip.is_massless(node); }))
          macro_elements[cell_behind(strip, k)].push_back(k);
      }

    // Each process knows all of the strip, so that it adds up the rows it owns on its own.
    MassChange change;
    for (const auto &[behind, at_boundary] : macro_elements)
      exchange_mass(strip, behind, at_boundary, change);
    const auto &partitioner = *discretization.matrices().pattern.partitioner;
    for (auto entry = change.begin(); entry != change.end();)
      entry = partitioner.in_local_range(dim * entry->first.first) ? std::next(entry)
                                                                   : change.erase(entry);
    return change;
  }


  template MassChange macro_element_mass(const Discretization<2> &, const ContactStrip<2> &);
  template MassChange macro_element_mass(const Discretization<3> &, const ContactStrip<3> &);
} // namespace signorini
