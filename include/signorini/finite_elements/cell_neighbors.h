// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_finite_elements_cell_neighbors_h
#define signorini_finite_elements_cell_neighbors_h

#include <signorini/discretization/discretization.h>
#include <signorini/finite_elements/point_table.h>

namespace signorini
{
  /** An owned cell or a neighbour of owned cells. */
  template <int dim>
  struct LocalCell
  {
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    Cell cell;
    std::array<unsigned int, 1u << dim>
                 nodes; ///< numbers in CellNeighbors::partitioner, in the order of the vertices
    unsigned int index; ///< active_cell_index
    unsigned int body;
    bool         owned;
  };

  /**
   * A face between two cells of which one is owned. The second cell is as large as the first or
   * larger.
   */
  template <int dim>
  struct InnerFace
  {
    std::array<unsigned int, 2>  cells; ///< numbers of local cells
    std::array<unsigned char, 2> faces; ///< numbers in the cells
    int subface; ///< of the second cell, at which vertex of its face; -1: the whole face
    std::array<unsigned char, GaussTables<dim>::n_subfaces>
           points; ///< the second's number of each point of the first
    double size;   ///< of the first's face: diameter, scaled to the edge
  };

  template <int dim>
  struct OuterFace
  {
    unsigned int cell; ///< number of a local cell, which is owned
    unsigned int face;
    double       size; ///< as of an inner face
  };

  /**
   * The cells of this process and what is next to them, in arrays, so that sums over cells and
   * faces neither walk through the mesh nor look up degrees of freedom. Refers to one mesh. Vectors
   * have values at all nodes of these cells, hanging ones included: local entry dim * node +
   * component.
   */
  template <int dim>
  class CellNeighbors
  {
  public:
    /** Collective. */
    explicit CellNeighbors(const Discretization<dim> &discretization);

    const Discretization<dim>  &discretization;
    std::vector<LocalCell<dim>> cells;
    std::vector<InnerFace<dim>> inner_faces;
    std::vector<OuterFace<dim>> outer_faces;

    /** A vector of zeros. */
    Vector make_vector() const { return Vector(partitioner); }

    /** Like Discretization::interpolate_hanging_nodes(). Collective. */
    Vector interpolate_hanging_nodes(const Vector &vector) const;

    /**
     * Sum up what processes have added at nodes, hanging ones give theirs to their masters, and
     * become zero. First components only. Collective.
     */
    void sum_over_processes(Vector &sums) const;

    /** The values of a vector at the vertices of a cell, dim for each. */
    void gather(const LocalCell<dim> &cell, const Vector &vector, double *values) const
    {
      for (const unsigned int node : cell.nodes)
        for (unsigned int c = 0; c < dim; ++c)
          *values++ = vector.local_element(dim * node + c);
    }

  private:
    struct HangingNode
    {
      unsigned int                                 node;
      std::vector<std::pair<unsigned int, double>> masters;
    };

    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner;
    std::vector<HangingNode> hanging_nodes; ///< those with known masters

    void find_cells();
    void find_hanging_nodes();
    void find_faces();
  };
} // namespace signorini

#endif
