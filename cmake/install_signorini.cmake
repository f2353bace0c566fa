# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors
#
# cmake --install: program, library, headers, the package for find_package(signorini), scenes, and
# what draws pictures and makes reports of runs.
# ./dev package makes a Debian package of the same.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/signorini)
set(data_folder ${CMAKE_INSTALL_DATADIR}/signorini)

install(TARGETS signorini_core EXPORT signoriniTargets COMPONENT library
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} NAMELINK_COMPONENT development)
install(TARGETS signorini EXPORT signoriniTargets)
install(DIRECTORY include/signorini DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY parameters examples DESTINATION ${data_folder})
install(DIRECTORY tools/plotting tools/reporting DESTINATION ${data_folder}/tools
  PATTERN __pycache__ EXCLUDE)
install(PROGRAMS tools/plot.py tools/report.py DESTINATION ${data_folder}/tools)
install(FILES LICENSES/MIT-dygraphs.txt DESTINATION ${data_folder}/LICENSES)
install(FILES doc/references.bib DESTINATION ${data_folder}/doc)
foreach(tool plot report) # as commands
  file(CREATE_LINK ../share/signorini/tools/${tool}.py
    ${CMAKE_BINARY_DIR}/generated/signorini-${tool} SYMBOLIC)
  install(FILES ${CMAKE_BINARY_DIR}/generated/signorini-${tool}
    DESTINATION ${CMAKE_INSTALL_BINDIR})
endforeach()
install(FILES tools/completion/signorini
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(EXPORT signoriniTargets NAMESPACE signorini:: DESTINATION ${package_folder})
string(TOUPPER ${CMAKE_BUILD_TYPE} flavour) # of deal.II
configure_package_config_file(cmake/signoriniConfig.cmake.in
  ${CMAKE_BINARY_DIR}/generated/signoriniConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/generated/signoriniConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/generated/signoriniConfig.cmake
  ${CMAKE_BINARY_DIR}/generated/signoriniConfigVersion.cmake DESTINATION ${package_folder})

# Where the loader finds a library for processors of this kind, too, it takes that one.
set(SIGNORINI_FAST_LIBRARY "" CACHE PATH
  "Build folder of the library for newer processors, to be packed beside the one for any")
set(CPACK_INSTALL_CMAKE_PROJECTS "${CMAKE_BINARY_DIR};signorini;ALL;/")
if(SIGNORINI_FAST_LIBRARY)
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${SIGNORINI_FAST_LIBRARY};signorini;library;/")
endif()

set(CPACK_PACKAGE_NAME signorini)
set(CPACK_PACKAGE_CONTACT "the signorini authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Elastic bodies in dynamic contact")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR})
set(CPACK_DEBIAN_PACKAGE_DEPENDS "openmpi-bin, python3")
# To draw pictures and make reports; to convert meshes; to compile plug-ins.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-matplotlib, python3-meshio, libjs-dygraphs")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
  "libdeal.ii-dev, libeigen3-dev, libssl-dev, cmake, python3-h5py, python3-netcdf4")
set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
include(CPack)
