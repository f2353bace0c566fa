# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The study work-precision: errors against processor time and products, for all schemes, meshes,
steps, tolerances, uniform and adaptive, and where other programs lie."""
