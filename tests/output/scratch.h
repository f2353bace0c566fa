// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_tests_output_scratch_h
#define signorini_tests_output_scratch_h

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>

/** A folder for one test, the same on all processes; it goes away with the object. Collective. */
class ScratchFolder
{
public:
  ScratchFolder()
  {
    static unsigned int n_folders = 0;
    const auto          parent    = std::filesystem::temp_directory_path().string();
    name                          = dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD,
                                             parent + "/signorini_output_test_"
                                               + std::to_string(getpid()) + "_"
                                               + std::to_string(n_folders++),
                                             0);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::filesystem::create_directory(name);
    MPI_Barrier(MPI_COMM_WORLD);
  }

  ~ScratchFolder()
  {
    MPI_Barrier(MPI_COMM_WORLD);
    std::error_code ignored;
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::filesystem::remove_all(name, ignored);
    MPI_Barrier(MPI_COMM_WORLD);
  }

  std::string name;
};

inline std::string contents(const std::string &path)
{
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

#endif
