// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/materials/material_table.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  void declare_hooke(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.declare_entry("Young's modulus", "1", Double(), "E > 0 (force per area).");
    prm.declare_entry("Poisson's ratio",
                      "0",
                      Double(),
                      "nu, larger than -1 and smaller than 0.5 (no unit). In 2d: plane strain.");
    prm.declare_entry("Density", "1", Double(), "Mass per volume, > 0.");
  }

  namespace
  {
    /** Energies are products of such numbers with squares of others, and so are their squares. */
    constexpr double largest_number = 1e150;

    double number_of_material(const SectionReader &in, const char *key, const char *reason)
    {
      const double value = in.positive_number(key, reason);
      if (value > largest_number || value < 1. / largest_number)
        in.fail(key,
                "is so far from 1 that energies overflow or vanish. Choose other units, for all "
                "quantities alike.");
      return value;
    }
  } // namespace


  Material parse_hooke(const SectionReader &in)
  {
    Material material;
    material.youngs_modulus =
      number_of_material(in, "Young's modulus", "an elastic body resists deformation");
    material.poissons_ratio = in.number("Poisson's ratio");
    material.density        = number_of_material(in, "Density", "every body has mass");

    const double nu = material.poissons_ratio;
    if (nu == .5)
      in.fail(
        "Poisson's ratio",
        "0.5 is an incompressible material, whose first Lame parameter is infinite; it would need "
        "a mixed method with a pressure. Use a value smaller than 0.5, for example 0.49.");
    if (nu == -1.)
      in.fail("Poisson's ratio",
              "-1 makes the shear modulus infinite: such a material changes its volume only. Use a "
              "larger value.");
    if (!(nu > -1. && nu < .5))
      in.fail("Poisson's ratio",
              "no stable material has this value. It must be larger than -1 and smaller than 0.5.");
    return material;
  }
} // namespace signorini
