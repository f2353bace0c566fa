// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef extension_parts_h
#define extension_parts_h

// What this example adds. Each part is one file, and one function that enters it into a table.

/** Obstacles with `Shape = washboard`: a floor with round ridges. */
void add_washboard();

/** Bodies with `Shape = ring`: a disc, in 3d a ball, with a hole in its middle. */
void add_ring();

/** `Time/Scheme = contact-implicit-damped`. */
void add_damped_scheme();

/** Bodies with `Material = alloy`: constants by name, in SI units. */
void add_alloy();

#endif
