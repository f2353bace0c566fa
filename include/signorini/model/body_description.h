// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_body_description_h
#define signorini_model_body_description_h

#include <signorini/base/enum_names.h>
#include <signorini/base/rayleigh_damping.h>
#include <signorini/model/element_kind.h>
#include <signorini/model/placement.h>

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace signorini
{
  /** Linear elastic, homogeneous, isotropic material (paper, equation (44)). */
  struct Material
  {
    double          youngs_modulus = 1.; ///< E > 0, force per area
    double          poissons_ratio = 0.; ///< nu in (-1, 1/2); plane strain in 2d
    double          density        = 1.; ///< rho > 0, mass per volume
    RayleighDamping damping        = {};
    /** First Lame parameter. */
    double lambda() const
    {
      return youngs_modulus * poissons_ratio / ((1. + poissons_ratio) * (1. - 2. * poissons_ratio));
    }
    /** Shear modulus. */
    double mu() const { return youngs_modulus / (2. * (1. + poissons_ratio)); }
    /** Speed of pressure waves, sqrt((lambda + 2 mu) / rho). */
    double pressure_wave_speed() const { return std::sqrt((lambda() + 2. * mu()) / density); }
  };

  /**
   * A condition on one boundary id: expressions in x, y, z, t, one per component. An empty
   * expression (or a "-") leaves this component free (Dirichlet) or zero (traction).
   */
  template <int dim>
  struct BoundaryCondition
  {
    dealii::types::boundary_id   boundary_id = 0;
    std::array<std::string, dim> expressions;
  };

  /**
   * What the scene needs to know of a mesh from a file: where it comes from, and the vertices on
   * each of its boundaries, as they stand in the file, times the scale.
   */
  template <int dim>
  struct MeshFile
  {
    std::string        path;       ///< absolute, or relative to the current folder
    std::string        part;       ///< names or numbers of groups of cells; empty: all cells
    double             scale = 1.; ///< of all coordinates
    dealii::Point<dim> centre;     ///< of the smallest box that holds all vertices
    std::map<dealii::types::boundary_id, std::vector<dealii::Point<dim>>> boundary_vertices;
    /** Boundary ids of the groups of faces, by their names and numbers. */
    std::map<std::string, std::vector<dealii::types::boundary_id>> boundaries;
    std::vector<std::string>                                       notes; ///< clauses
  };

  /** What a body is before it is placed. */
  enum class BodyShape
  {
    ball, ///< in 2d a disc
    box,
    cylinder, ///< in 3d only
    file      ///< a mesh from a file
  };

  template <>
  struct EnumNames<BodyShape>
  {
    static constexpr EnumName<BodyShape> table[] = {{BodyShape::ball, "ball"},
                                                    {BodyShape::box, "box"},
                                                    {BodyShape::cylinder, "cylinder"},
                                                    {BodyShape::file, "file"}};
  };

  /**
   * Section `Bodies/<name>`: shape, mesh, material, initial state, loads and Dirichlet conditions
   * of one body.
   */
  template <int dim>
  struct BodyDescription
  {
    std::string name;
    BodyShape   shape = BodyShape::ball;

    // The shape before it is placed.
    dealii::Point<dim>            centre; ///< ball, cylinder
    double                        radius = 1.;
    double                        length = 2.;      ///< cylinder: full length, centred at `centre`
    unsigned int                  axis   = dim - 1; ///< cylinder: direction of the axis, 0, 1, 2
    dealii::Point<dim>            lower_corner, upper_corner; ///< box
    std::array<unsigned int, dim> repetitions;                ///< box: coarse cells per direction
    double cap_radius = 0.; ///< box: radius of the bulging face; 0: all faces are flat
    dealii::types::boundary_id cap_boundary = 0; ///< box: the face that bulges
    MeshFile<dim>              mesh_file;        ///< file
    Placement<dim>             placement; ///< from the shape as described to its place in space
    unsigned int               refinements = 0; ///< uniform refinements
    unsigned int local_refinements         = 0; ///< further refinements of the cells selected below
    std::string  refine_where; ///< expression in x, y, z of the cell centre; > 0 selects

    Material                     material;
    ElementKind                  element = ElementKind::enhanced;
    std::array<std::string, dim> initial_displacement; ///< expressions in x, y, z
    std::array<std::string, dim> initial_velocity;
    std::array<std::string, dim>
      body_force; ///< force per *mass* (f of the paper's rho f), expressions in x, y, z, t
    std::vector<BoundaryCondition<dim>> dirichlet; ///< prescribed displacement
    std::vector<BoundaryCondition<dim>> traction;  ///< prescribed stress vector

    /** Whether cells with straight edges are only an approximation of the shape. */
    bool is_round() const
    {
      return shape == BodyShape::ball || shape == BodyShape::cylinder || cap_radius > 0.;
    }
  };
} // namespace signorini

#endif
