// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/prm/unused_keys.h>

#include <deal.II/base/parameter_handler.h>

namespace signorini
{
  void refuse_without_effect(const SectionReader            &in,
                             const std::string              &key,
                             const dealii::ParameterHandler &declared,
                             const std::string              &owners,
                             const std::string              &choice)
  {
    if (in.overridden(choice))
      return; // studies give keys to all of their runs
    if (in.given(key) && in.text(key) != declared.get(key))
      in.fail(key,
              "is only for " + owners + ", and has no effect with `" + choice + " = "
                + in.text(choice) + "`. Remove this key, or change `" + choice + "`.");
  }
} // namespace signorini
