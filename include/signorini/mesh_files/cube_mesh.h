// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mesh_files_cube_mesh_h
#define signorini_mesh_files_cube_mesh_h

#include <signorini/mesh_files/mesh_content.h>
#include <signorini/mesh_files/mesh_text.h>

#include <deal.II/grid/tria_description.h>

namespace signorini
{
  /** There is no such part in a file. */
  class MeshPartError : public MeshFileError
  {
  public:
    using MeshFileError::MeshFileError;
  };

  /** The cells of a body, and all groups of their dimension less one. */
  struct MeshPart
  {
    std::vector<MeshElement> cells;
    /** Whether all cells are quadrilaterals or hexahedra. */
    bool all_are_cubes = true;

    /** A cell in words: its number among the cubes, or its number in the file. */
    std::string name_of(std::size_t cell) const;
  };

  /**
   * The cells of a group, or of several with commas between, by names or numbers; all cells if
   * @p part is empty. Cells that a file has twice, in two groups, are one.
   * @throws MeshFileError if there are no cells of dimension @p dim, or pyramids among them
   */
  MeshPart select_part(const MeshContent &content, unsigned int dim, const std::string &part);

  /**
   * Turn cells whose corners are listed in the wrong direction of rotation: all if these are more
   * than half of them, or each one if @p turns_each. @throws MeshFileError naming one that is in
   * the minority, or has a corner without volume
   */
  void orient_cells(const std::vector<dealii::Point<3>> &points, bool turns_each, MeshPart &part);

  /** A face of a cell of a part. */
  struct FaceOfCell
  {
    std::array<unsigned int, 4> key; ///< see key_of_face()
    unsigned int                cell, face;

    bool operator<(const FaceOfCell &other) const
    {
      return std::tie(key, cell) < std::tie(other.key, other.cell);
    }
  };

  /**
   * All faces of all cells, sorted: the faces of neighbours follow each other. @throws
   * MeshFileError if cells lie on the same side of a face
   */
  std::vector<FaceOfCell> faces_of(const MeshPart &part);

  /** @throws MeshFileError naming two cells, if the middle of one is in the other */
  void check_that_cells_are_apart(const std::vector<dealii::Point<3>> &points,
                                  const MeshPart                      &part);

  /** Boundary ids by the groups that a file names, or gives numbers. */
  struct MeshBoundary
  {
    std::vector<FaceOfCell>                                        faces;
    std::vector<dealii::types::boundary_id>                        ids;    ///< of the faces
    std::map<std::string, std::vector<dealii::types::boundary_id>> groups; ///< names and numbers
    std::size_t n_left_out = 0; ///< faces of groups that belong to no cell
  };

  /**
   * The faces at the boundary of a part. A face in no group has the id 0, one in a single group the
   * number of the group; each other combination of groups has an id of its own.
   * @throws MeshFileError if a face in a group is between two cells
   */
  MeshBoundary boundary_of(const MeshContent &content, const MeshPart &part);

  /** Quadrilaterals or hexahedra, as deal.II wants them. */
  template <int dim>
  struct CubeMesh
  {
    std::vector<dealii::Point<dim>>    points;
    std::vector<dealii::CellData<dim>> cells;
    dealii::SubCellData                faces;   ///< those with a boundary id
    std::vector<unsigned int>          origins; ///< of the cells: which cell of the part
  };

  /** A part without other cells than cubes. */
  template <int dim>
  CubeMesh<dim>
  cubes_of(const MeshContent &content, const MeshPart &part, const MeshBoundary &boundary);

  /**
   * Each cell as many cubes as it has corners. The new vertices are the middles of edges, faces and
   * cells, on curves of second order where the file has them.
   */
  template <int dim>
  CubeMesh<dim>
  split_into_cubes(const MeshContent &content, const MeshPart &part, const MeshBoundary &boundary);

  /**
   * The smallest scaled Jacobian: the volume that the edges at a vertex span over the product of
   * their lengths, at most 1. @throws MeshFileError naming a cell where it is not positive
   */
  template <int dim>
  double smallest_jacobian(const CubeMesh<dim> &mesh, const MeshPart &part);
} // namespace signorini

#endif
