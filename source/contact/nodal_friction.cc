// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/complaints.h>
#include <signorini/base/expressions.h>
#include <signorini/contact/nodal_friction.h>
#include <signorini/surfaces/contact_frame.h>

#include <cmath>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** A number of the law of a pair as a function of the place, and what is wrong with it. */
    template <int dim>
    class LawExpression
    {
    public:
      LawExpression(const std::string &key, const std::string &text)
        : head(key + " = " + text + ": this")
        , function(make_function<dim, 1>({{text}}))
      {
      }

      double at(const Point<dim> &place)
      {
        const double value = function->value(place);
        if (!(value >= 0. && std::isfinite(value)))
          {
            std::ostringstream message;
            message << head << " is " << value << " at (" << place
                    << "). Write an expression that is a number >= 0 on the whole contact surface.";
            complaints.emplace_back(0., message.str());
          }
        return value;
      }

      /** All processes throw the same, if any has a complaint. Collective. */
      void check(const MPI_Comm communicator) const { throw_worst(complaints, communicator); }

    private:
      const std::string                          head;
      const std::unique_ptr<FunctionParser<dim>> function;
      std::vector<Complaint>                     complaints;
    };


    template <int dim>
    void assign_law_of_pair(const MPI_Comm                 communicator,
                            const PairDescription         &description,
                            const unsigned int             pair,
                            std::vector<ContactNode<dim>> &nodes)
    {
      const FrictionDescription &friction = description.friction;
      const std::string          head     = "Contact/" + description.name + "/";
      LawExpression<dim>         coefficient(head + "Friction coefficient", friction.coefficient),
        bound(head + "Friction bound", friction.bound);
      for (ContactNode<dim> &node : nodes)
        if (node.pair == pair)
          {
            if (friction.law == FrictionKind::tresca)
              node.friction.constant = bound.at(node.position) * node.weight;
            else
              {
                // The law is one of nodal forces, of which the normal one is the free part.
                node.friction.coefficient = coefficient.at(node.position) / node.free_part;
                if (!friction.bound.empty())
                  node.friction.cap = bound.at(node.position) * node.weight;
              }
          }
      coefficient.check(communicator);
      bound.check(communicator);
    }


  } // namespace


  template <int dim>
  std::array<bool, dim>
  relative_directions(const ContactNode<dim>                              &node,
                      const typename DirichletConditions<dim>::Components *conditions)
  {
    std::array<bool, dim> relative{};
    if (node.partners.empty())
      return relative;
    relative[node.row] = true;
    if (node.row == 0) // tangents go with the first of several contact nodes
      for (unsigned int k = node.n_bounds; k < dim; ++k)
        relative[k] = node.friction.any();
    if (conditions != nullptr)
      {
        const auto row = rows_along_axes<dim>(node.frame);
        for (unsigned int c = 0; c < dim; ++c)
          if ((*conditions)[c] != DirichletConditions<dim>::none && row[c] < dim)
            relative[row[c]] = false;
      }
    return relative;
  }


  template <int dim>
  void assign_friction(const Discretization<dim>          &discretization,
                       const DirichletConditions<dim>     &dirichlet,
                       const std::vector<PairDescription> &pairs,
                       std::vector<ContactNode<dim>>      &nodes)
  {
    for (unsigned int pair = 0; pair < pairs.size(); ++pair)
      if (pairs[pair].friction.any)
        assign_law_of_pair(discretization.communicator(), pairs[pair], pair, nodes);
    for (ContactNode<dim> &node : nodes)
      {
        const auto conditions = dirichlet.nodes().find(node.node);
        node.relative         = relative_directions<dim>(
          node, conditions == dirichlet.nodes().end() ? nullptr : &conditions->second);
      }
  }


  template std::array<bool, 2> relative_directions<2>(const ContactNode<2> &,
                                                      const DirichletConditions<2>::Components *);
  template std::array<bool, 3> relative_directions<3>(const ContactNode<3> &,
                                                      const DirichletConditions<3>::Components *);
  template void                assign_friction(const Discretization<2> &,
                                               const DirichletConditions<2> &,
                                               const std::vector<PairDescription> &,
                                               std::vector<ContactNode<2>> &);
  template void                assign_friction(const Discretization<3> &,
                                               const DirichletConditions<3> &,
                                               const std::vector<PairDescription> &,
                                               std::vector<ContactNode<3>> &);
} // namespace signorini
