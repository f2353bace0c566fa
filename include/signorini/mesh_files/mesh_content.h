// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_mesh_files_mesh_content_h
#define signorini_mesh_files_mesh_content_h

#include <signorini/mesh_files/cell_shape.h>

#include <deal.II/base/point.h>

#include <map>
#include <string>
#include <vector>

namespace signorini
{
  /** A cell of a mesh file, or one of its faces, edges or points. */
  struct MeshElement
  {
    CellKind                    kind    = CellKind::point;
    std::array<unsigned int, 8> corners = {}; ///< points
    long                        label   = 0;  ///< its number in the file
    std::vector<unsigned int>   groups  = {}; ///< which of the groups of the content have it
  };

  /** A physical group of Gmsh, a surface or an element set of Abaqus. */
  struct MeshGroup
  {
    unsigned int dim;    ///< of its elements
    unsigned int number; ///< boundary id if they are faces; 0: none in the file
    std::string  name;   ///< may be empty
  };

  /** What a mesh file says, whatever its format. */
  struct MeshContent
  {
    std::vector<dealii::Point<3>> points;
    std::vector<MeshElement>      elements;
    /** Points in the middle of edges of second order, by the ends of the edge, smaller first. */
    std::map<CellShape::Edge, unsigned int> middles;
    std::vector<MeshGroup>                  groups;
    /** Whether the order of corners may turn a cell inside out without a meaning. */
    bool turns_cells = false;

    /**
     * The group with this dimension and number; a new one if there is none. Without a group if
     * number = 0.
     * @throws MeshFileError if a boundary id cannot be so large
     */
    std::vector<unsigned int> group_of(unsigned int dim, long number);
    /**
     * Add an element of @p nodes, of which the first are corners, and those behind, if there are
     * any, in the middle of the @p edges, in their order; further ones are passed over.
     */
    void add(const MeshElement                  &element,
             const std::vector<unsigned int>    &nodes,
             const std::vector<CellShape::Edge> &edges);
    /** Give numbers that are free to the groups without one. */
    void number_groups();

  private:
    std::map<std::array<unsigned int, 2>, unsigned int> known_groups; ///< by dimension and number
  };

  /** The content of a Gmsh file in text. @throws MeshFileError, as all of these */
  MeshContent content_of_gmsh(const std::string &text);
  MeshContent content_of_ucd(const std::string &text);
  /** Of a legacy VTK file in text. Groups are what deal.II writes as `MaterialID`. */
  MeshContent content_of_vtk(const std::string &text);
  /**
   * Of an Abaqus input file. A surface (`*SURFACE`, of elements or element sets) is a group of
   * faces with the number that its name contains; elements of faces are in groups by their sets.
   */
  MeshContent content_of_abaqus(const std::string &text);

  /** Whether the extension of a path, in small letters, is one of a mesh of cells. */
  bool is_mesh_extension(const std::string &extension);
  /** The formats with their extensions, for messages. */
  std::string list_of_mesh_formats();
  /** Read a file by its extension and content. @throws MeshFileError */
  MeshContent read_mesh_content_of(const std::string &path);
} // namespace signorini

#endif
