# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The study benchmark: impacts with known answers on several meshes, judged against them, beside
what other programs have done with the same problems."""
