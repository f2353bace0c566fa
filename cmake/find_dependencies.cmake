# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors
#
# deal.II and the libraries that it must have been built with. Each missing one is named together
# with what to install.

find_package(deal.II 9.4 QUIET HINTS ${deal.II_DIR} ${DEAL_II_DIR} $ENV{DEAL_II_DIR})
if(NOT deal.II_FOUND)
  message(FATAL_ERROR "signorini needs deal.II 9.4 or newer. "
                      "On Debian: apt-get install libdeal.ii-dev; "
                      "elsewhere set DEAL_II_DIR to the folder of your installation.")
endif()
deal_ii_initialize_cached_variables()

foreach(feature MPI P4EST TRILINOS SUNDIALS MUPARSER HDF5)
  if(NOT DEAL_II_WITH_${feature})
    message(FATAL_ERROR "This deal.II (${DEAL_II_PATH}) was built without ${feature}, which "
                        "signorini needs. On Debian the package libdeal.ii-dev has it; for your "
                        "own build configure deal.II with -DDEAL_II_WITH_${feature}=ON.")
  endif()
endforeach()

find_package(OpenSSL QUIET COMPONENTS Crypto)
if(NOT OPENSSL_FOUND)
  message(FATAL_ERROR "signorini needs OpenSSL. On Debian: apt-get install libssl-dev.")
endif()

find_package(Eigen3 3.4 QUIET NO_MODULE)
if(NOT Eigen3_FOUND)
  message(FATAL_ERROR "signorini needs Eigen 3.4 or newer. "
                      "On Debian: apt-get install libeigen3-dev.")
endif()
