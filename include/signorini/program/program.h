// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_program_program_h
#define signorini_program_program_h

/**
 * All that the program does, MPI included; source/main.cc loads the library for it.
 * @return the exit status
 */
extern "C" int signorini_program(int argc, char **argv);

#endif
