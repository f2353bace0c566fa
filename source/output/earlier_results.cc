// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/output/earlier_results.h>
#include <signorini/output/whole_file.h>

#include <filesystem>
#include <regex>
#include <vector>

namespace signorini
{
  namespace
  {
    void remove_matching(const std::filesystem::path &directory, const std::regex &name)
    {
      if (!std::filesystem::is_directory(directory))
        return;
      std::vector<std::filesystem::path> found;
      for (const auto &entry : std::filesystem::directory_iterator(directory))
        if (entry.is_regular_file() && std::regex_match(entry.path().filename().string(), name))
          found.push_back(entry.path());
      for (const auto &path : found)
        std::filesystem::remove(path);
    }
  } // namespace


  void remove_earlier_results(const std::string &directory, const MPI_Comm communicator)
  {
    succeed_together(communicator, [&] {
      if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
        return;
      const std::filesystem::path folder(directory);
      remove_matching(
        folder,
        std::regex("(history|supports|pairs|bodies|forces|probe_.*)\\.csv|"
                   "(volume|surface|obstacles|setup)\\.pvd|(setup_)?obstacles\\.vtu"));
      remove_matching(folder / "fields",
                      std::regex("(volume|surface|obstacles|setup)_.*\\.p?vtu(\\.part)?"));
      remove_matching(folder / "fclib", std::regex("step_\\d+\\.hdf5(\\.part)?"));
      remove_matching(folder / "pictures",
                      std::regex("(bodies|contact_force|energy|momentum|probe_.*)\\.png"));
    });
  }
} // namespace signorini
