# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors
#
# signorini_compile(<target>): how all code of the project is compiled;
# signorini_compile_alone(<target>): the same without deal.II.

include(CheckCXXCompilerFlag)
include(CheckCXXSourceCompiles)

# The first of the given sets of flags that the compiler takes without a word; nothing if none is.
function(signorini_first_quiet_flags result)
  set(CMAKE_REQUIRED_QUIET ON)
  foreach(flags IN LISTS ARGN)
    string(MAKE_C_IDENTIFIER "quiet ${flags}" quiet)
    set(CMAKE_REQUIRED_FLAGS "-Werror ${flags}")
    check_cxx_source_compiles("int main() { return 0; }" ${quiet})
    if(${quiet})
      separate_arguments(flags)
      set(${result} ${flags} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  set(${result} "" PARENT_SCOPE)
endfunction()

# The flags of the options below that this compiler knows.
set(SIGNORINI_FLAGS "")
# Nobody replaces functions of the library, so that they may be inlined in it.
set(candidates -fno-semantic-interposition)
if(SIGNORINI_NATIVE)
  # Floating-point contraction changes round-off only; every result is defined by a tolerance. Small
  # blocks fill registers of four numbers, so AVX-512 has nothing to add. GCC 14 gives a warning
  # where the processor has AVX10, which brings AVX-512 back, unless that is switched off, too.
  signorini_first_quiet_flags(SIGNORINI_FLAGS
    "-march=native -mno-avx512f" "-march=native -mno-avx10.1-512 -mno-avx512f"
    "-march=native -mno-avx10.1 -mno-avx512f" "-march=native")
endif()
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  # Debian's deal.II passes on its own flags. Debug information and unrolling of all loops cost a
  # third of the time of the compiler; the loops that matter are unrolled by hand.
  list(APPEND candidates -g0 -fno-unroll-loops -fno-unroll-all-loops)
endif()
if(CMAKE_BUILD_TYPE STREQUAL "Debug")
  # Assertions are wanted, not a debugger: its information costs the compiler a seventh of its time,
  # optimisation for faster tests a tenth (of the group "contact").
  list(APPEND candidates -O1 -g0)
endif()
if(SIGNORINI_SANITIZE)
  # The check of virtual tables wants type information that Debian's libraries keep to themselves.
  set(SIGNORINI_SANITIZERS -fsanitize=address,undefined -fno-sanitize=vptr
                           -fno-sanitize-recover=all)
  list(APPEND SIGNORINI_FLAGS ${SIGNORINI_SANITIZERS})
  # Reports name lines of sources: this takes back the -g0 above.
  list(APPEND candidates -O1 -g1 -fno-omit-frame-pointer)
  add_library(signorini_keep_libraries OBJECT tools/sanitizers/keep_libraries.cc)
endif()
if(SIGNORINI_UNITY)
  # GCC takes the sources of a unity build for headers, where unnamed namespaces would be a mistake.
  list(APPEND candidates -Wno-subobject-linkage)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  # Debian's deal.II was compiled by GCC and passes on options that only GCC knows. GoogleTest's
  # macros leave their last argument empty.
  list(APPEND candidates -Wno-unknown-warning-option -Wno-ignored-optimization-argument
                         -Wno-gnu-zero-variadic-macro-arguments)
endif()
foreach(flag IN LISTS candidates)
  string(MAKE_C_IDENTIFIER "has${flag}" has_flag)
  check_cxx_compiler_flag(${flag} ${has_flag})
  if(${has_flag})
    list(APPEND SIGNORINI_FLAGS ${flag})
  endif()
endforeach()

function(signorini_compile_alone target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra $<$<BOOL:${SIGNORINI_WARNINGS_AS_ERRORS}>:-Werror> ${SIGNORINI_FLAGS})
  target_link_options(${target} PRIVATE ${SIGNORINI_SANITIZERS})
  get_target_property(type ${target} TYPE)
  if(SIGNORINI_SANITIZE AND type STREQUAL EXECUTABLE)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:signorini_keep_libraries>)
  endif()
endfunction()

function(signorini_compile target)
  deal_ii_setup_target(${target})
  signorini_compile_alone(${target})
endfunction()
