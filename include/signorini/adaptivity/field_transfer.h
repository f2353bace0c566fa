// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_adaptivity_field_transfer_h
#define signorini_adaptivity_field_transfer_h

#include <signorini/adaptivity/cell_moments.h>

namespace signorini
{
  /**
   * Carries Q1 fields from a mesh to the next one, cell by cell and to whatever process owns the cell then.
   *
   * On refined cells the function stays what it is. Where cells are coarsened it is first replaced by its values at the remaining nodes; the
   * moments of what got lost, against all functions of the new mesh, are kept, so that the owner of the fields can turn the result into a
   * projection: with c from (M or A) c = lost moments, field + c is the projection in the norm of M or A.
   */
  template <int dim>
  class FieldTransfer
  {
  public:
    /** Moments that a field shall be projected with. */
    using Moments = std::vector<double> (CellMoments<dim>::*)(const typename CellMoments<dim>::Cell &,
                                                              const std::vector<double> &);

    /** A field of the old mesh. */
    struct Source
    {
      Vector  field;             ///< hanging nodes need not be filled
      Moments moments = nullptr; ///< null: values at nodes are good enough
    };

    /** A field on the new mesh. */
    struct Result
    {
      Vector field; ///< values at nodes
      Vector
        lost_moments; ///< of old minus new function; empty for sources without moments and if nothing was coarsened
    };

    /**
     * Take the fields. The mesh must carry its final flags, and must change next.
     * Collective.
     */
    FieldTransfer(Discretization<dim> &discretization, const std::vector<Source> &old_fields);

    /** The fields on the new mesh, in the order of the sources; needs numbered degrees of freedom and matrices. Once. Collective. */
    std::vector<Result> unpack();

  private:
    using Values     = typename CellMoments<dim>::Values;
    using Cell       = typename CellMoments<dim>::Cell;
    using CellStatus = typename dealii::Triangulation<dim>::CellStatus;

    /** The old functions on a cell of the new mesh. */
    struct CellFields
    {
      std::vector<Values> values;  ///< at the vertices, by source
      std::vector<Values> moments; ///< of coarsened cells only, by source
    };

    Discretization<dim> &discretization;
    std::vector<Source>  sources;
    unsigned int         handle;

    std::vector<char>       pack(const Cell &cell, CellStatus status, CellMoments<dim> &moments) const;
    Values                  vertex_values(const Cell &active_cell, const Vector &field) const;
    Values                  prolongate(const Values &parent, unsigned int child) const;
    std::vector<CellFields> receive();
    Vector                  set_nodes(const std::vector<CellFields> &cells, unsigned int source) const;
    Vector lost_moments(const std::vector<CellFields> &cells, unsigned int source, const Vector &field);
  };
} // namespace signorini

#endif
