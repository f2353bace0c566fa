// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mass/contact_strip.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** The elements of lists of all processes as one set. */
    std::set<types::global_dof_index> unite(const std::set<types::global_dof_index> &own,
                                            const MPI_Comm                           communicator)
    {
      std::set<types::global_dof_index> result;
      for (const auto &part : Utilities::MPI::all_gather(
             communicator, std::vector<types::global_dof_index>(own.begin(), own.end())))
        result.insert(part.begin(), part.end());
      return result;
    }


    template <int dim, typename Function>
    void for_each_owned_cell(const Discretization<dim> &discretization, const Function &function)
    {
      for (const auto &cell : discretization.cells())
        if (cell->is_locally_owned())
          {
            std::array<types::global_dof_index, StripCell<dim>::n_vertices> nodes;
            for (const unsigned int v : cell->vertex_indices())
              {
                const auto dof = cell->vertex_dof_index(v, 0);
                nodes[v]       = discretization.hanging_node_constraints().is_constrained(dof)
                                   ? StripCell<dim>::hanging
                                   : dof / dim;
              }
            function(cell, nodes);
          }
    }


    /** Element matrices of the mass with one number per pair of vertices. */
    template <int dim>
    class CellMass
    {
    public:
      explicit CellMass(const Mesh<dim> &mesh)
        : mesh(mesh)
        , fe(1)
        , fe_values(mesh.mapping(),
                    fe,
                    QGauss<dim>(mesh.n_quadrature_points()),
                    update_values | update_JxW_values)
      {
      }

      template <typename Cell, typename Nodes>
      StripCell<dim> strip_cell(const Cell &cell, const Nodes &nodes) const
      {
        StripCell<dim> result;
        result.nodes = nodes;
        result.mass.fill(0.);
        fe_values.reinit(static_cast<typename Triangulation<dim>::cell_iterator>(cell));
        const double density = mesh.bodies()[cell->material_id()].material.density;
        for (unsigned int a = 0; a < nodes.size(); ++a)
          {
            result.vertices[a] = cell->vertex(a);
            for (unsigned int b = 0; b < nodes.size(); ++b)
              for (const unsigned int q : fe_values.quadrature_point_indices())
                result.mass[a * nodes.size() + b] += density * fe_values.shape_value(a, q)
                                                     * fe_values.shape_value(b, q)
                                                     * fe_values.JxW(q);
          }
        return result;
      }

    private:
      const Mesh<dim>      &mesh;
      const FE_Q<dim>       fe;
      mutable FEValues<dim> fe_values;
    };
  } // namespace


  template <int dim>
  Point<dim> StripCell<dim>::centre() const
  {
    Point<dim> sum;
    for (const Point<dim> &vertex : vertices)
      sum += vertex / n_vertices;
    return sum;
  }


  template <int dim>
  ContactStrip<dim>::ContactStrip(const Discretization<dim> &discretization,
                                  const ContactSurface<dim> &surface)
  {
    const MPI_Comm communicator = discretization.communicator();
    find_massless_nodes(discretization, surface);
    const auto touches = [](const auto &nodes, const auto &set) {
      return std::any_of(
        nodes.begin(), nodes.end(), [&](const Node node) { return set.count(node) > 0; });
    };

    std::set<Node> first_layer; // nodes of the cells at massless nodes
    for_each_owned_cell(discretization, [&](const auto &, const auto &nodes) {
      if (touches(nodes, massless))
        first_layer.insert(nodes.begin(), nodes.end());
    });
    first_layer.erase(StripCell<dim>::hanging);
    first_layer = unite(first_layer, communicator);

    const CellMass<dim>         mass(discretization.mesh());
    std::vector<StripCell<dim>> own_cells;
    for_each_owned_cell(discretization, [&](const auto &cell, const auto &nodes) {
      if (touches(nodes, first_layer))
        own_cells.push_back(mass.strip_cell(cell, nodes));
    });
    for (const auto &part : Utilities::MPI::all_gather(communicator, own_cells))
      cells.insert(cells.end(), part.begin(), part.end());
    index_cells();
  }


  template <int dim>
  void ContactStrip<dim>::find_massless_nodes(const Discretization<dim> &discretization,
                                              const ContactSurface<dim> &surface)
  {
    const auto &partitioner = *discretization.matrices().pattern.partitioner;
    std::vector<std::pair<Node, std::array<double, dim>>> own;
    for (const ContactNode<dim> &node : surface.nodes())
      {
        std::array<double, dim> normal;
        std::copy_n(node.frame.begin(), dim, normal.begin());
        own.emplace_back(partitioner.local_to_global(dim * node.node) / dim, normal);
      }
    for (const auto &part : Utilities::MPI::all_gather(discretization.communicator(), own))
      for (const auto &[node, normal] : part)
        for (unsigned int c = 0; c < dim; ++c)
          massless[node][c] = normal[c];
  }


  template <int dim>
  void ContactStrip<dim>::index_cells()
  {
    // Cells of one body never share their centre; bodies may touch, but not overlap.
    std::sort(cells.begin(), cells.end(), [](const StripCell<dim> &a, const StripCell<dim> &b) {
      const Point<dim> x = a.centre(), y = b.centre();
      for (unsigned int c = 0; c < dim; ++c)
        if (x[c] != y[c])
          return x[c] < y[c];
      return false;
    });
    for (unsigned int k = 0; k < cells.size(); ++k)
      for (unsigned int v = 0; v < StripCell<dim>::n_vertices; ++v)
        if (cells[k].nodes[v] != StripCell<dim>::hanging)
          {
            positions[cells[k].nodes[v]] = cells[k].vertices[v];
            cells_of_node[cells[k].nodes[v]].insert(k);
          }
  }


  template struct StripCell<2>;
  template struct StripCell<3>;
  template struct ContactStrip<2>;
  template struct ContactStrip<3>;
} // namespace signorini
