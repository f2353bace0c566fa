# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors
#
# Formulas of the pages, $...$, as Doxygen writes them; blocks of code (four spaces) are left alone.
/^    /b
s/\$\([^$]*\)\$/@f$\1@f$/g
# Doxygen takes every README.md for its main page, and has one only.
s/\[\(python\/README.md\)\](python\/README.md)/\1/g
# The manual is not part of the reference, and headings are no anchors for it.
s/\[\([^]]*\)\](manual\/[^)]*)/\1/g
s/\[\([^]]*\)\](#[^)]*)/\1/g
