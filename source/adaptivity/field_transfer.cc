// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/field_transfer.h>

#include <memory>

namespace signorini
{
  using namespace dealii;

  template <int dim>
  FieldTransfer<dim>::FieldTransfer(Discretization<dim> &discretization, const std::vector<Source> &old_fields)
    : discretization(discretization)
  {
    for (const Source &source : old_fields) // not by assignment, which would keep the ghosts of the old vector
      sources.push_back({discretization.interpolate_hanging_nodes(source.field), source.moments});
    for (const Source &source : sources)
      source.field.update_ghost_values(); // copies have none
    const auto moments = std::make_shared<CellMoments<dim>>(discretization);
    handle             = discretization.triangulation.register_data_attach(
      [this, moments](const Cell &cell, const CellStatus status) { return pack(cell, status, *moments); }, true);
  }


  template <int dim>
  typename FieldTransfer<dim>::Values FieldTransfer<dim>::vertex_values(const Cell   &active_cell,
                                                                        const Vector &field) const
  {
    const typename DoFHandler<dim>::cell_iterator cell(
      &discretization.triangulation, active_cell->level(), active_cell->index(), &discretization.dof_handler);
    Values values;
    for (const unsigned int v : cell->vertex_indices())
      for (unsigned int c = 0; c < dim; ++c)
        values.push_back(field(cell->vertex_dof_index(v, c)));
    return values;
  }


  template <int dim>
  typename FieldTransfer<dim>::Values FieldTransfer<dim>::prolongate(const Values      &parent,
                                                                     const unsigned int child) const
  {
    const FullMatrix<double> &weights = discretization.fe.base_element(0).get_prolongation_matrix(child);
    Values                    values(parent.size(), 0.);
    for (unsigned int a = 0; a < weights.m(); ++a)
      for (unsigned int b = 0; b < weights.n(); ++b)
        for (unsigned int c = 0; c < dim; ++c)
          values[dim * a + c] += weights(a, b) * parent[dim * b + c];
    return values;
  }


  template <int dim>
  std::vector<char> FieldTransfer<dim>::pack(const Cell &cell, const CellStatus status, CellMoments<dim> &moments) const
  {
    const bool         coarsened = status == Triangulation<dim>::CELL_COARSEN;
    const unsigned int n_values  = dim * GeometryInfo<dim>::vertices_per_cell;
    CellFields         fields;
    for (const Source &source : sources)
      {
        if (!coarsened)
          {
            fields.values.push_back(vertex_values(cell, source.field));
            continue;
          }
        // `cell` is the parent. Its vertex v is vertex v of child v.
        Values injected(n_values), sum(source.moments != nullptr ? n_values : 0, 0.);
        for (unsigned int child = 0; child < cell->n_children(); ++child)
          {
            const Values values = vertex_values(cell->child(child), source.field);
            for (unsigned int c = 0; c < dim; ++c)
              injected[dim * child + c] = values[dim * child + c];
            if (source.moments == nullptr)
              continue;
            const FullMatrix<double> &weights  = discretization.fe.base_element(0).get_prolongation_matrix(child);
            const Values              of_child = (moments.*source.moments)(cell->child(child), values);
            for (unsigned int a = 0; a < weights.m(); ++a)
              for (unsigned int b = 0; b < weights.n(); ++b)
                for (unsigned int c = 0; c < dim; ++c)
                  sum[dim * b + c] += weights(a, b) * of_child[dim * a + c];
          }
        fields.values.push_back(std::move(injected));
        fields.moments.push_back(std::move(sum));
      }
    return Utilities::pack(std::make_pair(fields.values, fields.moments), false);
  }


  template <int dim>
  std::vector<typename FieldTransfer<dim>::CellFields> FieldTransfer<dim>::receive()
  {
    std::vector<CellFields> cells(discretization.triangulation.n_active_cells());
    discretization.triangulation.notify_ready_to_unpack(
      handle,
      [&](const Cell                                                     &cell,
          const CellStatus                                                status,
          const boost::iterator_range<std::vector<char>::const_iterator> &data) {
        using Lists            = std::pair<std::vector<Values>, std::vector<Values>>;
        auto [values, moments] = Utilities::unpack<Lists>(data.begin(), data.end(), false);
        if (status != Triangulation<dim>::CELL_REFINE)
          {
            cells[cell->active_cell_index()] = {std::move(values), std::move(moments)};
            return;
          }
        for (unsigned int child = 0; child < cell->n_children(); ++child)
          for (const Values &parent : values)
            cells[cell->child(child)->active_cell_index()].values.push_back(prolongate(parent, child));
      });
    return cells;
  }


  template <int dim>
  Vector FieldTransfer<dim>::set_nodes(const std::vector<CellFields> &cells, const unsigned int source) const
  {
    Vector field = discretization.make_vector();
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          if (const auto dof = cell->vertex_dof_index(v, 0);
              discretization.locally_owned.is_element(dof)
              && !discretization.hanging_node_constraints.is_constrained(dof))
            for (unsigned int c = 0; c < dim; ++c)
              field(dof + c) = cells[cell->active_cell_index()].values[source][dim * v + c];
    return field;
  }


  template <int dim>
  Vector
  FieldTransfer<dim>::lost_moments(const std::vector<CellFields> &cells, const unsigned int source, const Vector &field)
  {
    const Vector                         filled = discretization.interpolate_hanging_nodes(field);
    Vector                               result = discretization.make_vector();
    CellMoments<dim>                     moments(discretization);
    std::vector<types::global_dof_index> dofs(discretization.fe.n_dofs_per_cell());
    dealii::Vector<double>               local(dofs.size());
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const CellFields &old        = cells[cell->active_cell_index()];
          Values            difference = vertex_values(cell, filled);
          const bool        coarsened  = !old.moments.empty();
          bool              any        = coarsened;
          for (unsigned int i = 0; i < difference.size(); ++i)
            {
              difference[i] = (coarsened ? 0. : old.values[source][i]) - difference[i];
              any           = any || difference[i] != 0.;
            }
          if (!any) // neither this cell nor a neighbour was coarsened
            continue;
          const Values sum = (moments.*sources[source].moments)(cell, difference);
          for (unsigned int i = 0; i < sum.size(); ++i)
            local[i] = sum[i] + (coarsened ? old.moments[source][i] : 0.);
          cell->get_dof_indices(dofs);
          discretization.hanging_node_constraints.distribute_local_to_global(local, dofs, result);
        }
    result.compress(VectorOperation::add);
    return result;
  }


  template <int dim>
  std::vector<typename FieldTransfer<dim>::Result> FieldTransfer<dim>::unpack()
  {
    const std::vector<CellFields> cells     = receive();
    unsigned int                  coarsened = 0;
    for (const CellFields &cell : cells)
      coarsened = coarsened || !cell.moments.empty();
    coarsened = Utilities::MPI::max(coarsened, discretization.communicator());

    std::vector<Result> results(sources.size());
    for (unsigned int s = 0; s < sources.size(); ++s)
      {
        results[s].field = set_nodes(cells, s);
        if (coarsened > 0 && sources[s].moments != nullptr)
          results[s].lost_moments = lost_moments(cells, s, results[s].field);
      }
    return results;
  }


  template class FieldTransfer<2>;
  template class FieldTransfer<3>;
} // namespace signorini
