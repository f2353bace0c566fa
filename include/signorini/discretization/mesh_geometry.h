// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_discretization_mesh_geometry_h
#define signorini_discretization_mesh_geometry_h

#include <signorini/discretization/cell_id_hash.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q_cache.h>

#include <unordered_map>

namespace signorini
{
  /**
   * The maps from the reference cell to the cells of a mesh, of degree 1 or 2.
   *
   * A mesh that changes during a run has to fill the same body at all times, or a body would gain
   * and lose mass: there each cell is a part of its ancestor in the base mesh (the uniformly
   * refined one that a scene starts from), with the map of this ancestor. Spaces on finer meshes
   * then contain those on coarser ones. Meshes that stay have the finer geometry, every cell with a
   * map of its own.
   */
  template <int dim>
  class MeshGeometry
  {
  public:
    /**
     * @param base_levels per body the refinement level of the base mesh; empty: every cell has a
     *                    map of its own
     */
    MeshGeometry(unsigned int degree, std::vector<unsigned int> base_levels);

    /**
     * To be called whenever the mesh has changed. Moves vertices of cells beyond the base mesh to
     * where they belong.
     */
    void update(dealii::parallel::distributed::Triangulation<dim> &triangulation);

    const dealii::MappingQ<dim> &mapping() const
    {
      return is_straight() ? static_cast<const dealii::MappingQ<dim> &>(straight_mapping)
                           : cached_mapping;
    }

    /** Whether cells are parts of their ancestors in a base mesh. */
    bool has_base() const { return !base_levels.empty(); }

  private:
    /**
     * By the vertices of cells, wherever they are. deal.II is not to take cells for translations of
     * each other: values would depend on the order of cells by round-off.
     */
    class StraightMapping : public dealii::MappingQ<dim>
    {
    public:
      StraightMapping()
        : dealii::MappingQ<dim>(1)
      {
      }
      std::unique_ptr<dealii::Mapping<dim>> clone() const override
      {
        return std::make_unique<StraightMapping>();
      }
      bool preserves_vertex_locations() const override { return false; }
    };

    using Points = std::vector<dealii::Point<dim>>;
    /** Rows of a sparse matrix: columns and values. */
    using Interpolation = std::vector<std::vector<std::pair<unsigned int, double>>>;

    const std::vector<unsigned int> base_levels;
    const dealii::FE_Q<dim>         polynomials;
    std::vector<Interpolation>      parts; ///< support points of the children of a cell
    const StraightMapping           straight_mapping;
    dealii::MappingQCache<dim>      cached_mapping; ///< of degree 2; support points are not cheap
    std::unordered_map<dealii::CellId, Points, CellIdHash<dim>>
      base_points; ///< support points of cells up to the base level

    bool is_straight() const { return polynomials.degree == 1; }
  };
} // namespace signorini

#endif
