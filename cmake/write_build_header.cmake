# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors
#
# cmake -D SOURCE=<folder> -D HEADER=<file> -D COMPILATION=<words> -P write_build_header.cmake
# Writes a header that says what is built and how: the commit of the sources, with "-modified"
# behind it where tracked files differ from it, and the kind of build with its options. Runs in
# every build; a header that would say the same keeps its time.

cmake_minimum_required(VERSION 3.25)

# Without locks, as others may be using the repository.
function(ask_git answer)
  execute_process(COMMAND ${git} --no-optional-locks -C ${SOURCE} ${ARGN} OUTPUT_VARIABLE said
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    set(said "unknown")
  endif()
  set(${answer} "${said}" PARENT_SCOPE)
endfunction()

set(commit "unknown")
find_program(git git)
if(git)
  ask_git(path_in_repository rev-parse --show-prefix)
  if(path_in_repository STREQUAL "") # else another repository holds a folder without one
    ask_git(commit describe --always --exclude * --abbrev=12 --dirty=-modified)
  endif()
endif()
string(REPLACE ";" " " compilation "${COMPILATION}")
file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT "#define SIGNORINI_COMMIT \"@commit@\"
#define SIGNORINI_COMPILATION \"@compilation@\"
")
