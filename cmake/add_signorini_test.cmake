# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors
#
# Tests with GoogleTest: an executable for each folder of tests, and as many ctests of it as its
# suites need.
#
# signorini_add_test_executable(<executable> <file>...)
#   The executable test_<executable>. Its sources are compiled as one, like those of the library.
#
# signorini_add_test(<name> [EXECUTABLE <executable>] [SUITES <suite>...] [RANKS <n>...]
#                    [LABELS <label>...] [TIMEOUT <seconds>])
#   Runs an executable (default: of the same name) on each number of ranks (default: 1); with SUITES
#   only the tests of these. The ctest <name> runs on one process, <name>.mpirun=<n> on n processes.
function(signorini_add_test_executable name)
  add_executable(test_${name} ${ARGN})
  signorini_compile(test_${name})
  target_link_libraries(test_${name} signorini_test_main)
  target_compile_definitions(test_${name} PRIVATE
    SIGNORINI_SOURCE_DIR="${CMAKE_SOURCE_DIR}" SIGNORINI_EXECUTABLE="$<TARGET_FILE:signorini>")
  target_precompile_headers(test_${name} REUSE_FROM signorini_test_main)
  set_target_properties(test_${name} PROPERTIES
    UNITY_BUILD ${SIGNORINI_UNITY} UNITY_BUILD_BATCH_SIZE 0)
endfunction()

# signorini_set_test_environment(<test>)
#   One thread per process, OpenMPI as root, and a folder for its session of their own: programs of
#   one process that start at the same time without a daemon would make the same one, and one fails.
function(signorini_set_test_environment test)
  set_tests_properties(${test} PROPERTIES ENVIRONMENT
    "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;OMP_NUM_THREADS=1;\
OMPI_MCA_orte_tmpdir_base=${CMAKE_BINARY_DIR}/Testing/mpi/${test}")
endfunction()

function(signorini_add_test name)
  cmake_parse_arguments(TEST "" "TIMEOUT;EXECUTABLE" "SUITES;RANKS;LABELS" ${ARGN})
  if(NOT TEST_RANKS)
    set(TEST_RANKS 1)
  endif()
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 600) # some ten times what it takes: machines may be slow or busy
  endif()
  if(NOT TEST_EXECUTABLE)
    set(TEST_EXECUTABLE ${name})
  endif()
  set(command $<TARGET_FILE:test_${TEST_EXECUTABLE}>)
  if(TEST_SUITES)
    list(TRANSFORM TEST_SUITES REPLACE "(.+)" "\\1.*:*/\\1.*")
    list(JOIN TEST_SUITES ":" suites)
    list(APPEND command "--gtest_filter=${suites}")
  endif()
  foreach(ranks ${TEST_RANKS})
    if(ranks EQUAL 1)
      set(test ${name})
      add_test(NAME ${test} COMMAND ${command})
    else()
      set(test ${name}.mpirun=${ranks})
      add_test(NAME ${test} COMMAND mpirun --oversubscribe -np ${ranks} ${command})
    endif()
    set_tests_properties(${test} PROPERTIES
      LABELS "${TEST_LABELS}" TIMEOUT ${TEST_TIMEOUT} PROCESSORS ${ranks})
    signorini_set_test_environment(${test})
  endforeach()
endfunction()
