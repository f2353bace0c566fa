// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// What signorini calls when a scene names this library.

#include "parts.h"

#include <signorini/base/plugin.h>

SIGNORINI_PLUGIN
{
  add_washboard();
  add_ring();
  add_damped_scheme();
  add_alloy();
}
