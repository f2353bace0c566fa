# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors
#
# signorini_sources(<group> <file>...)
#
# Sources of a module for the library. All sources of a group are compiled as one (unity build),
# because most of the time goes into the headers of deal.II: one by one they take four times as
# long. Names in unnamed namespaces have to be different within a group; -DSIGNORINI_UNITY=OFF
# compiles each file on its own, and shows what a file forgets to include.
function(signorini_sources group)
  list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE sources)
  target_sources(signorini_core PRIVATE ${sources})
  set_source_files_properties(${sources} TARGET_DIRECTORY signorini_core
    PROPERTIES UNITY_GROUP ${group})
endfunction()
