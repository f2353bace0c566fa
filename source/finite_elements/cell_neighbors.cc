// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/finite_elements/cell_neighbors.h>

#include <algorithm>
#include <cmath>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** The vertices of a face, by their numbers in the mesh. */
    template <int dim, typename Cell>
    std::array<unsigned int, GaussTables<dim>::n_subfaces> vertices_of_face(const Cell        &cell,
                                                                            const unsigned int face)
    {
      std::array<unsigned int, GaussTables<dim>::n_subfaces> result;
      for (unsigned int v = 0; v < result.size(); ++v)
        result[v] = cell->vertex_index(vertex_of_face<dim>(face, v));
      return result;
    }

    /** At which vertex of its parent's face a cell lies. */
    template <int dim, typename Cell>
    unsigned int place_in_face_of_parent(const Cell &cell, const unsigned int face)
    {
      const auto   parent = cell->parent();
      unsigned int v      = 0;
      while (parent->child_index(vertex_of_face<dim>(face, v)) != cell->index())
        ++v;
      return v;
    }
  } // namespace


  template <int dim>
  CellNeighbors<dim>::CellNeighbors(const Discretization<dim> &discretization)
    : discretization(discretization)
    , partitioner(std::make_shared<Utilities::MPI::Partitioner>(discretization.locally_owned(),
                                                                discretization.locally_relevant(),
                                                                discretization.communicator()))
  {
    find_cells();
    find_hanging_nodes();
    find_faces();
  }


  template <int dim>
  void CellNeighbors<dim>::find_cells()
  {
    cells.reserve(discretization.mesh().triangulation().n_active_cells());
    for (const auto &cell : discretization.cells())
      if (!cell->is_artificial())
        {
          cells.push_back(
            {cell, {}, cell->active_cell_index(), cell->material_id(), cell->is_locally_owned()});
          for (const unsigned int v : cell->vertex_indices())
            cells.back().nodes[v] =
              partitioner->global_to_local(cell->vertex_dof_index(v, 0)) / dim;
        }
  }


  template <int dim>
  void CellNeighbors<dim>::find_hanging_nodes()
  {
    for (const auto &line : discretization.hanging_node_constraints().get_lines())
      if (line.index % dim == 0)
        {
          HangingNode node{partitioner->global_to_local(line.index) / dim, {}};
          bool        known = true; // not at the far end of cells of other processes
          for (const auto &[dof, weight] : line.entries)
            {
              known =
                known && (partitioner->in_local_range(dof) || partitioner->is_ghost_entry(dof));
              if (known)
                node.masters.emplace_back(partitioner->global_to_local(dof) / dim, weight);
            }
          if (known)
            hanging_nodes.push_back(std::move(node));
        }
  }


  template <int dim>
  void CellNeighbors<dim>::find_faces()
  {
    const double              scale = 1. / std::sqrt(dim - 1.);
    std::vector<unsigned int> number(discretization.mesh().triangulation().n_active_cells());
    for (unsigned int i = 0; i < cells.size(); ++i)
      number[cells[i].index] = i;
    inner_faces.reserve(dim * cells.size());
    for (unsigned int i = 0; i < cells.size(); ++i)
      for (const unsigned int face : cells[i].cell->face_indices())
        {
          const auto &cell = cells[i].cell;
          if (cell->at_boundary(face))
            {
              if (cells[i].owned)
                outer_faces.push_back({i, face, scale * cell->face(face)->diameter()});
              continue;
            }
          const auto neighbor = cell->neighbor(face);
          if (!neighbor->is_active() || neighbor->is_artificial())
            continue; // smaller cells look at this face
          const unsigned int j       = number[neighbor->active_cell_index()];
          const bool         coarser = neighbor->level() < cell->level();
          if ((!coarser && j < i) || !(cells[i].owned || cells[j].owned))
            continue;
          const unsigned int neighbor_face = coarser
                                               ? cell->neighbor_of_coarser_neighbor(face).first
                                               : cell->neighbor_of_neighbor(face);
          InnerFace<dim>     inner{
            {{i, j}},
            {{static_cast<unsigned char>(face), static_cast<unsigned char>(neighbor_face)}},
            -1,
            {},
            scale * cell->face(face)->diameter()};
          // There is a Gauss point for each vertex. The parent has the same vertices as a coarser
          // neighbour.
          const auto mine   = coarser ? vertices_of_face<dim>(cell->parent(), face)
                                      : vertices_of_face<dim>(cell, face);
          const auto theirs = vertices_of_face<dim>(neighbor, neighbor_face);
          for (unsigned int v = 0; v < mine.size(); ++v)
            inner.points[v] = std::find(theirs.begin(), theirs.end(), mine[v]) - theirs.begin();
          if (coarser)
            inner.subface = inner.points[place_in_face_of_parent<dim>(cell, face)];
          inner_faces.push_back(inner);
        }
  }


  template <int dim>
  Vector CellNeighbors<dim>::interpolate_hanging_nodes(const Vector &vector) const
  {
    Vector result = make_vector();
    std::copy_n(vector.begin(), result.locally_owned_size(), result.begin());
    result.update_ghost_values();
    for (const HangingNode &hanging : hanging_nodes)
      for (unsigned int c = 0; c < dim; ++c)
        {
          double value = 0.;
          for (const auto &[master, weight] : hanging.masters)
            value += weight * result.local_element(dim * master + c);
          result.local_element(dim * hanging.node + c) = value;
        }
    result.update_ghost_values();
    return result;
  }


  template <int dim>
  void CellNeighbors<dim>::sum_over_processes(Vector &sums) const
  {
    for (const HangingNode &hanging : hanging_nodes)
      {
        double &sum = sums.local_element(dim * hanging.node);
        for (const auto &[master, weight] : hanging.masters)
          sums.local_element(dim * master) += weight * sum;
        sum = 0.;
      }
    sums.compress(VectorOperation::add);
    sums.update_ghost_values();
  }


  template class CellNeighbors<2>;
  template class CellNeighbors<3>;
} // namespace signorini
