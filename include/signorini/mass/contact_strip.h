// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mass_contact_strip_h
#define signorini_mass_contact_strip_h

#include <signorini/contact/contact_surface.h>

#include <Eigen/Dense>

#include <map>
#include <set>

namespace signorini
{
  /** A cell with its nodes, detached from the mesh, so that it can travel to another process. */
  template <int dim>
  struct StripCell
  {
    static constexpr unsigned int n_vertices = 1u << dim;

    std::array<dealii::types::global_dof_index, n_vertices>
      nodes; ///< in deal.II's order; `hanging` where a vertex is no node
    std::array<dealii::Point<dim>, n_vertices>  vertices;
    std::array<double, n_vertices * n_vertices> mass; ///< element matrix of the consistent mass

    static constexpr dealii::types::global_dof_index hanging = dealii::numbers::invalid_dof_index;

    dealii::Point<dim> centre() const;

    template <class Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &nodes &vertices &mass;
    }
  };

  /**
   * Two layers of cells at the possible contact boundary, all that a redistribution of mass has to
   * know: the cells at the nodes that lose their mass, and the cells at the other nodes of those.
   * The same on every process (memory of the size of the contact surface), in an order that does
   * not depend on the number of processes.
   */
  template <int dim>
  struct ContactStrip
  {
    /** Collective. */
    ContactStrip(const Discretization<dim> &discretization, const ContactSurface<dim> &surface);

    using Node = dealii::types::global_dof_index;

    std::map<Node, dealii::Tensor<1, dim>>
      massless; ///< contact nodes of all processes, with normals out of the body
    std::vector<StripCell<dim>>            cells;
    std::map<Node, dealii::Point<dim>>     positions;     ///< of all nodes of the cells
    std::map<Node, std::set<unsigned int>> cells_of_node; ///< indices into `cells`

    bool is_massless(const Node node) const { return massless.count(node) > 0; }

  private:
    void find_massless_nodes(const Discretization<dim> &discretization,
                             const ContactSurface<dim> &surface);
    /** Bring the cells of all processes into their order, and note where their nodes are. */
    void index_cells();
  };
} // namespace signorini

#endif
