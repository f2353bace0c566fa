# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors
#
# Shipped scenes that need no other file, as text in a header, for `signorini --new`.

file(GLOB scenes CONFIGURE_DEPENDS
  ${CMAKE_SOURCE_DIR}/parameters/*.prm ${CMAKE_SOURCE_DIR}/parameters/moving_contact/*.prm)
set(entries "")
foreach(scene IN LISTS scenes)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${scene})
  file(READ ${scene} text)
  if(NOT text MATCHES "\n *set File ")
    get_filename_component(name ${scene} NAME_WE)
    string(APPEND entries "{\"${name}\", R\"scene(${text})scene\"},\n")
  endif()
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/signorini_scenes.h @ONLY CONTENT "@entries@")
