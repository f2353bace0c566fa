// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/adaptivity/field_transfer.h>

#include <algorithm>
#include <cstring>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    void append(const VertexValues &values, std::vector<double> &fields)
    {
      fields.insert(fields.end(), values.begin(), values.end());
    }


    /**
     * Numbers as bytes, blocks of zeros left out: a byte per block says whether it is there.
     * Contact is on few cells.
     */
    std::vector<char> compress(const std::vector<double> &numbers, const std::size_t block_size)
    {
      const std::size_t n_blocks = numbers.size() / block_size;
      std::vector<char> bytes;
      bytes.reserve(1 + n_blocks + numbers.size() * sizeof(double));
      bytes.resize(1 + n_blocks);
      bytes[0] = static_cast<char>(n_blocks);
      for (std::size_t b = 0; b < n_blocks; ++b)
        {
          const double *const begin = &numbers[block_size * b], *const end = begin + block_size;
          bytes[1 + b] = std::any_of(begin, end, [](const double number) { return number != 0.; });
          if (bytes[1 + b])
            bytes.insert(bytes.end(),
                         reinterpret_cast<const char *>(begin),
                         reinterpret_cast<const char *>(end));
        }
      return bytes;
    }


    std::vector<double> expand(const char *const bytes, const std::size_t block_size)
    {
      const std::size_t   n_blocks = bytes[0];
      std::vector<double> numbers(n_blocks * block_size);
      const char         *next = bytes + 1 + n_blocks;
      for (std::size_t b = 0; b < n_blocks; ++b)
        if (bytes[1 + b])
          {
            std::memcpy(&numbers[block_size * b], next, block_size * sizeof(double));
            next += block_size * sizeof(double);
          }
      return numbers;
    }
  } // namespace


  template <int dim>
  FieldTransfer<dim>::FieldTransfer(Mesh<dim>                 &mesh,
                                    const Discretization<dim> &before,
                                    const std::vector<Source> &old_fields)
    : mesh(mesh)
    , discretization(&before)
  {
    for (const Source &source :
         old_fields) // not by assignment, which would keep the ghosts of the old vector
      sources.push_back({discretization->interpolate_hanging_nodes(source.field),
                         source.moments,
                         source.has_strain});
    for (const Source &source : sources)
      source.field.update_ghost_values(); // copies have none
    handle = mesh.triangulation().register_data_attach(
      [this](const Cell &cell, const CellStatus status) { return pack(cell, status); }, true);
  }


  template <int dim>
  VertexValues FieldTransfer<dim>::vertex_values(const Cell &active_cell, const Vector &field) const
  {
    const typename DoFHandler<dim>::cell_iterator cell(&mesh.triangulation(),
                                                       active_cell->level(),
                                                       active_cell->index(),
                                                       &discretization->dof_handler());
    VertexValues                                  values;
    values.reserve(n_values);
    for (const unsigned int v : cell->vertex_indices())
      {
        const unsigned int first =
          field.get_partitioner()->global_to_local(cell->vertex_dof_index(v, 0));
        for (unsigned int c = 0; c < dim; ++c) // a node has consecutive degrees of freedom
          values.push_back(field.local_element(first + c));
      }
    return values;
  }


  template <int dim>
  std::vector<char> FieldTransfer<dim>::pack(const Cell &cell, const CellStatus status) const
  {
    CellFields fields;
    fields.reserve(n_values * sources.size());
    for (const Source &source : sources)
      if (status != Triangulation<dim>::CELL_COARSEN)
        append(vertex_values(cell, source.field), fields);
      else // `cell` is the parent; its vertex v is vertex v of child v
        {
          VertexValues injected;
          for (unsigned int child = 0; child < cell->n_children(); ++child)
            {
              const VertexValues values = vertex_values(cell->child(child), source.field);
              injected.insert(injected.end(), &values[dim * child], &values[dim * child] + dim);
            }
          append(injected, fields);
        }
    if (status == Triangulation<dim>::CELL_COARSEN)
      for (const Source &source : sources)
        for (const Moments moments : source.moments)
          append(moments_of_children(cell, source, moments), fields);
    return compress(fields, n_values);
  }


  template <int dim>
  VertexValues FieldTransfer<dim>::moments_of_children(const Cell   &parent,
                                                       const Source &source,
                                                       const Moments moments) const
  {
    VertexValues sum(n_values, 0.);
    for (unsigned int child = 0; child < parent->n_children(); ++child)
      {
        const VertexValues of_child = moments(*discretization,
                                              parent->child(child),
                                              vertex_values(parent->child(child), source.field),
                                              parent);
        for (unsigned int i = 0; i < n_values; ++i)
          sum[i] += of_child[i];
      }
    return sum;
  }


  template <int dim>
  std::vector<typename FieldTransfer<dim>::CellFields> FieldTransfer<dim>::receive()
  {
    std::vector<CellFields> cells(mesh.triangulation().n_active_cells());
    mesh.triangulation().notify_ready_to_unpack(
      handle,
      [&](const Cell                                                     &cell,
          const CellStatus                                                status,
          const boost::iterator_range<std::vector<char>::const_iterator> &data) {
        CellFields fields = expand(&*data.begin(), n_values);
        coarsened         = coarsened || status == Triangulation<dim>::CELL_COARSEN;
        if (status != Triangulation<dim>::CELL_REFINE)
          {
            cells[cell->active_cell_index()] = std::move(fields);
            return;
          }
        const bool has_modes =
          !strain_modes<dim>(mesh.bodies()[cell->material_id()].element).empty();
        refined_with_modes = refined_with_modes || has_modes;
        for (unsigned int child = 0; child < cell->n_children(); ++child)
          {
            CellFields &of_child = cells[cell->child(child)->active_cell_index()];
            of_child             = prolongate(fields, child);
            if (has_modes)
              append_moments(fields, cell, cell->child(child), of_child);
          }
      });
    return cells;
  }


  template <int dim>
  void FieldTransfer<dim>::append_moments(const CellFields &parent_fields,
                                          const Cell       &parent,
                                          const Cell       &child,
                                          CellFields       &fields) const
  {
    auto values = parent_fields.begin();
    for (const Source &source : sources)
      {
        const VertexValues of_parent(values, values + n_values);
        for (const Moments moments : source.moments)
          append(moments(*discretization, parent, of_parent, child), fields);
        values += n_values;
      }
  }


  template <int dim>
  typename FieldTransfer<dim>::CellFields
  FieldTransfer<dim>::prolongate(const CellFields &parent, const unsigned int child) const
  {
    const FullMatrix<double> &weights =
      discretization->fe().base_element(0).get_prolongation_matrix(child);
    CellFields fields(parent.size(), 0.);
    for (unsigned int begin = 0; begin < parent.size(); begin += n_values)
      for (unsigned int a = 0; a < weights.m(); ++a)
        for (unsigned int b = 0; b < weights.n(); ++b)
          for (unsigned int c = 0; c < dim; ++c)
            fields[begin + dim * a + c] += weights(a, b) * parent[begin + dim * b + c];
    return fields;
  }


  template <int dim>
  std::vector<typename FieldTransfer<dim>::Result>
  FieldTransfer<dim>::values_at_nodes(const std::vector<CellFields> &cells) const
  {
    std::vector<Result> results(sources.size());
    for (Result &result : results)
      result.field = discretization->make_vector();
    const auto       &partitioner = *discretization->matrices().pattern.partitioner;
    std::vector<char> is_done(discretization->matrices().pattern.n_owned);
    for (const auto &cell : discretization->cells())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          {
            const auto dof = cell->vertex_dof_index(v, 0);
            if (!partitioner.in_local_range(dof))
              continue;
            const unsigned int first = partitioner.global_to_local(dof);
            if (is_done[first / dim])
              continue;
            is_done[first / dim] = 1;
            if (discretization->hanging_node_constraints().is_constrained(dof))
              continue;
            const double *value = &cells[cell->active_cell_index()][dim * v];
            for (Result &result : results)
              {
                for (unsigned int c = 0; c < dim; ++c)
                  result.field.local_element(first + c) = value[c];
                value += n_values;
              }
          }
    return results;
  }


  template <int dim>
  Vector FieldTransfer<dim>::lost_moments(const std::vector<CellFields> &cells,
                                          const unsigned int             source,
                                          const unsigned int             block,
                                          const Moments                  moments,
                                          const Vector                  &field)
  {
    const Vector                         filled = discretization->interpolate_hanging_nodes(field);
    Vector                               result = discretization->make_vector();
    std::vector<types::global_dof_index> dofs(n_values);
    dealii::Vector<double>               local(n_values);
    for (const auto &cell : discretization->cells())
      if (cell->is_locally_owned())
        {
          const CellFields &old        = cells[cell->active_cell_index()];
          const bool        changed    = has_moments(old);
          VertexValues      difference = vertex_values(cell, filled);
          bool              any        = changed;
          for (unsigned int i = 0; i < n_values; ++i)
            {
              difference[i] = (changed ? 0. : old[n_values * source + i]) - difference[i];
              any           = any || difference[i] != 0.;
            }
          if (!any) // neither this cell nor a neighbour was changed
            continue;
          const VertexValues sum = moments(*discretization, cell, difference, cell);
          for (unsigned int i = 0; i < n_values; ++i)
            local[i] = sum[i] + (changed ? old[n_values * block + i] : 0.);
          cell->get_dof_indices(dofs);
          discretization->hanging_node_constraints().distribute_local_to_global(
            local, dofs, result);
        }
    result.compress(VectorOperation::add);
    return result;
  }


  template <int dim>
  std::vector<typename FieldTransfer<dim>::Result>
  FieldTransfer<dim>::unpack(const Discretization<dim> &after)
  {
    discretization                      = &after;
    const std::vector<CellFields> cells = receive();
    const bool                    any_coarsened =
      Utilities::MPI::logical_or(coarsened, discretization->communicator());
    const bool any_refined =
      Utilities::MPI::logical_or(refined_with_modes, discretization->communicator());

    std::vector<Result> results = values_at_nodes(cells);
    unsigned int        block   = sources.size();
    for (unsigned int s = 0; s < sources.size(); ++s)
      for (const Moments moments : sources[s].moments)
        {
          if (any_coarsened || (any_refined && sources[s].has_strain))
            results[s].lost_moments.push_back(
              lost_moments(cells, s, block, moments, results[s].field));
          ++block;
        }
    return results;
  }


  template class FieldTransfer<2>;
  template class FieldTransfer<3>;
} // namespace signorini
