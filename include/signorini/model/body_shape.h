// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_body_shape_h
#define signorini_model_body_shape_h

#include <signorini/model/placement.h>

#include <deal.II/base/types.h>

#include <deal.II/grid/tria.h>

#include <map>
#include <string>
#include <vector>

namespace signorini
{
  /** Boundary ids by the names that a scene may give instead. */
  using BoundaryNames = std::map<std::string, std::vector<dealii::types::boundary_id>>;

  /**
   * What a body is before it is placed: its boundaries, and the coarse mesh that refinement starts
   * from. Coordinates are those of the shape, but for the mesh.
   */
  template <int dim>
  class BodyShape
  {
  public:
    virtual ~BodyShape() = default;

    /** Its centre, about which a scene turns it. */
    virtual dealii::Point<dim> midpoint() const = 0;

    /** Of all faces that the mesh has at its boundary; in ascending order. */
    virtual std::vector<dealii::types::boundary_id> boundary_ids() const = 0;

    /** A few points on one boundary, for trying expressions. */
    virtual std::vector<dealii::Point<dim>>
    boundary_points(dealii::types::boundary_id id) const = 0;

    /** Boundaries may have names besides their ids. */
    virtual BoundaryNames boundary_names() const { return {}; }

    /**
     * Make the coarse mesh of the body in its place, with the boundary ids. Manifolds say where
     * refinement puts new vertices; they are attached, in their place, too: round surfaces stay
     * round.
     */
    virtual void make_coarse_mesh(const Placement<dim>       &placement,
                                  dealii::Triangulation<dim> &mesh) const = 0;

    /** Two opposite corners of a box around it; nothing if only the mesh tells. */
    virtual std::vector<dealii::Point<dim>> corners_around() const { return {}; }

    /** How many cells the coarse mesh will have; 0 if only the mesh tells. */
    virtual double n_coarse_cells() const { return 0.; }

    /** Two sentences for more than a million coarse cells: the key that wants them; the remedy. */
    virtual std::string too_many_cells() const
    {
      return "Shape gives more than 1000000 coarse cells, which every process must keep. Use a "
             "shape with fewer coarse cells and more Refinements.";
    }

    /** Whether cells with straight edges are only an approximation of the shape. */
    virtual bool is_round() const { return false; }

    /** Whether all cells are parallelepipeds, however often they are refined. */
    virtual bool has_only_parallelepipeds() const { return false; }

    /** The path in its key `File`, where the mesh comes from; empty if there is none. */
    virtual std::string file() const { return {}; }

    /** What the log says about the mesh, in clauses. */
    virtual std::vector<std::string> notes() const { return {}; }
  };

  /**
   * The boundary ids that a scene means by a number, or by a name, whatever its capital letters and
   * blanks; empty if there are none.
   */
  template <int dim>
  std::vector<dealii::types::boundary_id> boundary_ids_named(const BodyShape<dim> &shape,
                                                             const std::string    &word);

  /** All boundary ids, with names behind them, for messages: `1 (face), 2`. */
  template <int dim>
  std::string list_of_boundaries(const BodyShape<dim> &shape);
} // namespace signorini

#endif
