// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_body_description_h
#define signorini_model_body_description_h

#include <signorini/base/rayleigh_damping.h>
#include <signorini/model/body_shape.h>
#include <signorini/model/element_kind.h>

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <array>
#include <cmath>
#include <memory>
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
   * Section `Bodies/<name>`: shape, mesh, material, initial state, loads and Dirichlet conditions
   * of one body.
   */
  template <int dim>
  struct BodyDescription
  {
    std::string                           name;
    std::string                           shape_name; ///< as the scene says it
    std::shared_ptr<const BodyShape<dim>> shape;
    Placement<dim> placement;             ///< from the shape as described to its place in space
    unsigned int   refinements       = 0; ///< uniform refinements
    unsigned int   local_refinements = 0; ///< further refinements of the cells selected below
    std::string    refine_where;          ///< expression in x, y, z of the cell centre; > 0 selects

    Material                     material;
    ElementKind                  element = ElementKind::enhanced;
    std::array<std::string, dim> initial_displacement; ///< expressions in x, y, z
    std::array<std::string, dim> initial_velocity;
    std::array<std::string, dim>
      body_force; ///< force per *mass* (f of the paper's rho f), expressions in x, y, z, t
    std::vector<BoundaryCondition<dim>> dirichlet; ///< prescribed displacement
    std::vector<BoundaryCondition<dim>> traction;  ///< prescribed stress vector
  };
} // namespace signorini

#endif
