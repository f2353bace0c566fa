// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_materials_material_table_h
#define signorini_materials_material_table_h

#include <signorini/model/body_description.h>
#include <signorini/prm/section_reader.h>

#include <vector>

namespace signorini
{
  /**
   * A way in which a scene gives the constants of a material: `set Material = <name>`. All are
   * linear elastic and isotropic; a table of alloys, or moduli from measured speeds of waves, are
   * further ways.
   */
  struct MaterialModel
  {
    const char *name;
    const char *summary; ///< what it is, for the list of all keys

    /** Declares its keys. Models may share keys. */
    void (*declare)(dealii::ParameterHandler &prm);

    std::vector<std::string> keys; ///< all that it looks at

    /**
     * Modulus, ratio and density; the damping is that of the scene.
     * @throws UserError for values that make no material
     */
    Material (*parse)(const SectionReader &in);
  };

  /** All models; the first one is the default. */
  const std::vector<MaterialModel> &material_models();

  /** One more, from a plug-in. @throws UserError if its name is taken */
  void add_material_model(const MaterialModel &model);

  // `Material = hooke`: Young's modulus, Poisson's ratio, density.
  void     declare_hooke(dealii::ParameterHandler &prm);
  Material parse_hooke(const SectionReader &in);
} // namespace signorini

#endif
