// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/materials/material_table.h>
#include <signorini/prm/kinds_of_section.h>
#include <signorini/scene/sections.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <cmath>

namespace signorini
{
  namespace
  {
    /** What every model has to keep. */
    void check_constants(const SectionReader &in, const Material &material)
    {
      if (!(material.youngs_modulus > 0. && material.density > 0. && material.poissons_ratio > -1.
            && material.poissons_ratio < 0.5
            && std::isfinite(material.youngs_modulus * material.density)))
        in.fail("Material",
                "gives Young's modulus " + std::to_string(material.youngs_modulus)
                  + ", Poisson's ratio " + std::to_string(material.poissons_ratio) + " and density "
                  + std::to_string(material.density)
                  + ". Modulus and density must be positive, and the ratio between -1 and 0.5: "
                    "correct its other keys.");
    }
  } // namespace


  void declare_material(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    declare_kinds(prm, "Material", material_models());
    for (const MaterialModel &model : material_models())
      model.declare(prm);
    prm.declare_entry(
      "Damping",
      "0, 0",
      List(Double(), 2, 2),
      "a, b of the viscous damping a M + b A (a per time, b a time; both >= 0). A "
      "vibration of angular frequency omega loses per cycle pi (a/omega + b omega) "
      "of its amplitude. Known to the schemes "
        + join(schemes_where([](const SchemeInfo &info) { return info.damping; }), ", ") + ".");
  }


  Material parse_material(const SectionReader &in)
  {
    dealii::ParameterHandler declared;
    declare_material(declared);
    const auto &model =
      kind_of(in, "Material", material_models(), declared, [](const auto &owners) {
        return "the material " + names_of_kinds(owners);
      });
    Material material = model.parse(in);
    check_constants(in, material);
    const std::vector<double> damping =
      dealii::Utilities::string_to_double(dealii::Utilities::split_string_list(in.text("Damping")));
    material.damping = {damping[0], damping[1]};
    if (!(damping[0] >= 0. && damping[1] >= 0. && std::isfinite(damping[0] + damping[1])))
      in.fail("Damping", "needs two finite numbers that are not negative: damping takes energy.");
    return material;
  }
} // namespace signorini
