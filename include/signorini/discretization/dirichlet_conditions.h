// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_dirichlet_conditions_h
#define signorini_discretization_dirichlet_conditions_h

#include <signorini/discretization/discretization.h>

#include <deal.II/base/function_parser.h>

#include <map>
#include <string>
#include <vector>

namespace signorini
{
  /** Which components of which owned nodes are prescribed, and their values in time. */
  template <int dim>
  class DirichletConditions
  {
  public:
    explicit DirichletConditions(const Discretization<dim> &discretization);

    /** Per component the index of the (first) condition that prescribes it, or `none`. */
    using Components                   = std::array<unsigned int, dim>;
    static constexpr unsigned int none = static_cast<unsigned int>(-1);

    /** Prescribed components by owned node. */
    const std::map<unsigned int, Components> &nodes() const { return prescribed; }

    /** Of all bodies, in their order, and there in that of the scene. */
    unsigned int n_conditions() const { return places.size(); }

    /** Whether there are any conditions, on any process. */
    bool any() const { return !places.empty(); }

    /** Whose boundary a condition prescribes. */
    unsigned int body(const unsigned int condition) const { return places[condition].first; }

    /** Body, key and boundary of a condition, for the user. */
    std::string name(unsigned int condition) const;

    MPI_Comm communicator() const { return mesh.communicator(); }

    /** Whether the displacement that a condition prescribes for a component depends on time. */
    bool moves(const unsigned int condition, const unsigned int component) const
    {
      return depends_on_time[condition][component];
    }

    /**
     * Where two conditions prescribe the same component of a node, they must agree. Collective.
     * @param end_time they are compared at some times up to this
     * @throws UserError naming body, boundaries, place, component and values
     * @return a sentence for the user for each pair of boundaries that share nodes and agree
     */
    std::vector<std::string> check_shared_nodes(double end_time) const;

    /** Displacement prescribed by a condition for a component at a point. */
    double value(unsigned int              condition,
                 const dealii::Point<dim> &point,
                 unsigned int              component,
                 double                    time) const;

  private:
    /** A component of a node that two conditions prescribe; the first one counts. */
    struct Shared
    {
      dealii::Point<dim> point;
      unsigned int       component, first, second;
    };

    const Mesh<dim>                   &mesh;
    std::vector<Shared>                shared;
    std::vector<std::array<bool, dim>> depends_on_time; ///< of each condition
    /** Body and boundary id of each condition. */
    std::vector<std::pair<unsigned int, dealii::types::boundary_id>> places;
    std::map<unsigned int, Components>                               prescribed;
    std::vector<dealii::FunctionParser<dim> *>
      functions; ///< of each condition; the mesh keeps them
  };
} // namespace signorini

#endif
