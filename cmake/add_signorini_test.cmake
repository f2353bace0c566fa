# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors
#
# signorini_add_test(<name> SOURCES <file>... [RANKS <n>...] [LABELS <label>...] [TIMEOUT <seconds>])
#
# One GoogleTest executable, run as a ctest on each number of ranks (default: 1). The test <name> runs on one process,
# <name>.mpirun=<n> on n processes.
function(signorini_add_test name)
  cmake_parse_arguments(TEST "" "TIMEOUT" "SOURCES;RANKS;LABELS" ${ARGN})
  if(NOT TEST_RANKS)
    set(TEST_RANKS 1)
  endif()
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 300)
  endif()
  add_executable(${name} ${TEST_SOURCES})
  signorini_compile(${name})
  target_link_libraries(${name} signorini_test_main)
  target_compile_definitions(${name} PRIVATE
    SIGNORINI_SOURCE_DIR="${CMAKE_SOURCE_DIR}" SIGNORINI_EXECUTABLE="$<TARGET_FILE:signorini>")
  target_precompile_headers(${name} REUSE_FROM signorini_test_main)
  foreach(ranks ${TEST_RANKS})
    if(ranks EQUAL 1)
      set(test ${name})
      add_test(NAME ${test} COMMAND ${name})
    else()
      set(test ${name}.mpirun=${ranks})
      add_test(NAME ${test} COMMAND mpirun --oversubscribe -np ${ranks} $<TARGET_FILE:${name}>)
    endif()
    set_tests_properties(${test} PROPERTIES
      LABELS "${TEST_LABELS}" TIMEOUT ${TEST_TIMEOUT} PROCESSORS ${ranks}
      ENVIRONMENT "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;OMP_NUM_THREADS=1")
  endforeach()
endfunction()
