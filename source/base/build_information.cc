// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/build_information.h>

#include <deal.II/base/config.h>

#include <Eigen/Core>

#include <boost/version.hpp>
#include <mpi.h>
#include <signorini_build.h>

#include <algorithm>

namespace signorini
{
  namespace
  {
    template <typename... Number>
    std::string dotted(const int first, const Number... further)
    {
      return (std::to_string(first) + ... + ("." + std::to_string(further)));
    }

    /** Its first words: what follows are dates and names of builders. */
    std::string mpi_library()
    {
      char text[MPI_MAX_LIBRARY_VERSION_STRING] = "";
      int  length                               = 0;
      MPI_Get_library_version(text, &length);
      const std::string all(text, length);
      return all.substr(0, std::min(all.find_first_of(",\n"), all.size()));
    }
  } // namespace


  std::string libraries()
  {
    return "deal.II " DEAL_II_PACKAGE_VERSION ", p4est "
           + dotted(DEAL_II_P4EST_VERSION_MAJOR,
                    DEAL_II_P4EST_VERSION_MINOR,
                    DEAL_II_P4EST_VERSION_SUBMINOR)
           + ", Trilinos "
           + dotted(DEAL_II_TRILINOS_VERSION_MAJOR,
                    DEAL_II_TRILINOS_VERSION_MINOR,
                    DEAL_II_TRILINOS_VERSION_SUBMINOR)
           + ", SUNDIALS "
           + dotted(DEAL_II_SUNDIALS_VERSION_MAJOR,
                    DEAL_II_SUNDIALS_VERSION_MINOR,
                    DEAL_II_SUNDIALS_VERSION_PATCH)
           + ", Eigen " + dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)
           + ", Boost "
           + dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100) + ", "
           + mpi_library();
  }


  std::string compiler()
  {
#ifdef __clang__
    const std::string name = "Clang " __clang_version__;
#else
    const std::string name = "GCC " __VERSION__;
#endif
    return name + ", " SIGNORINI_COMPILATION;
  }
} // namespace signorini
