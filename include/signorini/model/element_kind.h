// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_model_element_kind_h
#define signorini_model_element_kind_h

#include <signorini/base/enum_names.h>

namespace signorini
{
  /** What strain the cells of a body have besides that of their Q1 displacement. */
  enum class ElementKind
  {
    standard,       ///< none
    enhanced,       ///< incompatible modes, eliminated cell by cell
    mean_dilatation ///< one change of volume per cell
  };

  template <>
  struct EnumNames<ElementKind>
  {
    static constexpr EnumName<ElementKind> table[] = {
      {ElementKind::standard, "standard"},
      {ElementKind::enhanced, "enhanced"},
      {ElementKind::mean_dilatation, "mean dilatation"}};
  };
} // namespace signorini

#endif
