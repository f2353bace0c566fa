// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/contact/own_forces.h>
#include <signorini/diagnostics/supports.h>

#include <deal.II/base/mpi.h>

namespace signorini
{
  template <int dim>
  Supports<dim>::Supports(const DirichletConditions<dim> &dirichlet,
                          const ContactSurface<dim>      &surface)
    : dirichlet(dirichlet)
    , surface(surface)
  {
    constexpr unsigned int none = DirichletConditions<dim>::none;
    for (const auto &[node, conditions] : dirichlet.nodes())
      for (unsigned int c = 0; c < dim; ++c)
        if (conditions[c] != none)
          entries.push_back({dim * node + c, conditions[c], c});
    // Where contact follows the motion an obstacle may become oblique to them later.
    for (unsigned int k = 0; k < surface.nodes().size(); ++k)
      if (const auto node = dirichlet.nodes().find(surface.nodes()[k].node);
          node != dirichlet.nodes().end())
        for (unsigned int c = 0; c < dim; ++c)
          if (node->second[c] != none)
            oblique.push_back({k, node->second[c], c});
  }


  template <int dim>
  typename Supports<dim>::Forces Supports<dim>::sums(const Vector &nodal_forces) const
  {
    Forces forces(dirichlet.n_conditions());
    for (const Entry &entry : entries)
      forces[entry.condition][entry.component] += nodal_forces.local_element(entry.index);
    return over_all_processes(std::move(forces));
  }


  template <int dim>
  typename Supports<dim>::Forces Supports<dim>::handed_on(const Vector &contact_force) const
  {
    const Vector own = own_forces(surface, contact_force);
    Forces       forces(dirichlet.n_conditions());
    for (const Entry &entry : oblique)
      {
        const ContactNode<dim> &node = surface.nodes()[entry.index];
        forces[entry.condition][entry.component] +=
          node.normal_force(own) * node.prescribed_part[entry.component];
      }
    return over_all_processes(std::move(forces));
  }


  template <int dim>
  typename Supports<dim>::Forces Supports<dim>::over_all_processes(Forces &&forces) const
  {
    std::vector<double> numbers;
    for (const auto &force : forces)
      numbers.insert(numbers.end(), force.begin(), force.end());
    dealii::Utilities::MPI::sum(numbers, dirichlet.communicator(), numbers);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      forces[i / 3][i % 3] = numbers[i];
    return std::move(forces);
  }


  template class Supports<2>;
  template class Supports<3>;
} // namespace signorini
