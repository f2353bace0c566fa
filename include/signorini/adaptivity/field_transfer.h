// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_field_transfer_h
#define signorini_adaptivity_field_transfer_h

#include <signorini/finite_elements/cell_moments.h>

namespace signorini
{
  /**
   * Carries Q1 fields from a mesh to the next one, cell by cell and to whatever process owns the
   * cell then.
   *
   * On refined cells the function stays what it is, but for the strain of an element that has
   * strain modes of its own on each cell. Where cells are coarsened the function is first replaced
   * by its values at the remaining nodes; the moments of what got lost, against all functions of
   * the new mesh, are kept, so that the owner of the fields can turn the result into a projection:
   * with c from (M or A) c = lost moments, field + c is the projection in the norm of M or A.
   */
  template <int dim>
  class FieldTransfer
  {
  public:
    using Cell = typename dealii::Triangulation<dim>::cell_iterator;

    /** Moments that a projection of a field needs: mass_moments or stiffness_moments. */
    using Moments = VertexValues (*)(const Discretization<dim> &,
                                     const Cell &,
                                     const VertexValues &,
                                     const Cell &);

    /** A field of the old mesh. */
    struct Source
    {
      Vector               field;   ///< hanging nodes need not be filled
      std::vector<Moments> moments; ///< none: values at nodes are good enough
      bool has_strain = false; ///< what elements with strain modes see changes by refinement, too
    };

    /** A field on the new mesh. */
    struct Result
    {
      Vector              field;        ///< values at nodes
      std::vector<Vector> lost_moments; ///< of old minus new function, in the order of the
                                        ///< source; empty if the function is the old one
    };

    /**
     * Take the fields. The mesh must carry its final flags, and must change next; what was before
     * must live until then. Collective.
     */
    FieldTransfer(Mesh<dim>                 &mesh,
                  const Discretization<dim> &before,
                  const std::vector<Source> &old_fields);

    /** The fields on the new mesh, in the order of the sources. Once. Collective. */
    std::vector<Result> unpack(const Discretization<dim> &after);

  private:
    using CellStatus = typename dealii::Triangulation<dim>::CellStatus;

    static constexpr unsigned int n_values = dim * (1u << dim); ///< per cell and field

    /**
     * The old functions on a cell: the values of each source, and where they are other functions
     * now also all the moments of each: on coarsened cells, and with strain modes on refined ones.
     */
    using CellFields = std::vector<double>;

    Mesh<dim>                 &mesh;
    const Discretization<dim> *discretization; ///< of the old mesh, from unpack() on of the new one
    std::vector<Source>        sources;
    unsigned int               handle;
    bool                       coarsened          = false; ///< some cell of this process
    bool                       refined_with_modes = false; ///< some cell of this process

    bool has_moments(const CellFields &fields) const
    {
      return fields.size() > n_values * sources.size();
    }

    std::vector<char> pack(const Cell &cell, CellStatus status) const;
    VertexValues      vertex_values(const Cell &active_cell, const Vector &field) const;
    VertexValues      moments_of_children(const Cell &, const Source &, Moments) const;
    CellFields        prolongate(const CellFields &parent, unsigned int child) const;
    void              append_moments(const CellFields &of_parent,
                                     const Cell       &parent,
                                     const Cell       &child,
                                     CellFields &) const;

    std::vector<CellFields> receive();
    std::vector<Result>     values_at_nodes(const std::vector<CellFields> &cells) const;
    /** @param source, block where values and moments are in the fields of a cell */
    Vector lost_moments(const std::vector<CellFields> &cells,
                        unsigned int                   source,
                        unsigned int                   block,
                        Moments                        moments,
                        const Vector                  &field);
  };
} // namespace signorini

#endif
