// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/table_of_kinds.h>
#include <signorini/materials/material_table.h>

namespace signorini
{
  namespace
  {
    std::vector<MaterialModel> &table()
    {
      static std::vector<MaterialModel> models{{"hooke",
                                                "hooke (linear elastic, isotropic)",
                                                declare_hooke,
                                                {"Young's modulus", "Poisson's ratio", "Density"},
                                                parse_hooke}};
      return models;
    }
  } // namespace


  const std::vector<MaterialModel> &material_models()
  {
    return table();
  }


  void add_material_model(const MaterialModel &model)
  {
    add_kind(table(), model, "material");
  }
} // namespace signorini
