// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_prm_unused_keys_h
#define signorini_prm_unused_keys_h

#include <signorini/prm/section_reader.h>

namespace signorini
{
  /**
   * Refuse a key that is given, with another value than its default, although nothing looks at it.
   * A file that lists all keys with their defaults stays valid, and so does any file whose choice
   * is made on the command line.
   * @param declared a handler with the keys of this section at its top
   * @param owners who looks at the key, in words
   * @param choice key that says that they are not there, such as Shape
   */
  void refuse_without_effect(const SectionReader            &in,
                             const std::string              &key,
                             const dealii::ParameterHandler &declared,
                             const std::string              &owners,
                             const std::string              &choice);
} // namespace signorini

#endif
