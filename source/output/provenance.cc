// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/build_information.h>
#include <signorini/base/spelling.h>
#include <signorini/output/provenance.h>
#include <signorini/output/sha256.h>
#include <signorini/output/whole_file.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace signorini
{
  namespace
  {
    /** Name and kind of the processor; nothing of it where Linux does not say. */
    std::string machine()
    {
      char name[MPI_MAX_PROCESSOR_NAME] = "";
      int  length                       = 0;
      MPI_Get_processor_name(name, &length);
      std::ifstream information("/proc/cpuinfo");
      for (std::string line; std::getline(information, line);)
        if (line.rfind("model name", 0) == 0 && line.find(':') != std::string::npos)
          return std::string(name, length) + ", " + trim(line.substr(line.find(':') + 1));
      return {name, static_cast<std::size_t>(length)};
    }


    /** Each machine once, with its number of processes. Collective. */
    std::map<std::string, unsigned int> machines(const MPI_Comm communicator)
    {
      std::map<std::string, unsigned int> processes;
      for (const std::string &name : dealii::Utilities::MPI::gather(communicator, machine()))
        ++processes[name];
      return processes;
    }
  } // namespace


  std::string provenance(const std::string                                      &scene_file,
                         const std::vector<std::pair<std::string, std::string>> &overrides,
                         const std::map<std::string, std::string>               &input_files,
                         const MPI_Comm                                          communicator)
  {
    std::ostringstream text;
    text << "  scene             "
         << std::filesystem::absolute(scene_file).lexically_normal().string();
    for (const auto &[key, value] : overrides)
      text << "\n  command line      --set \"" << key << "=" << value << "\"";
    succeed_together(communicator, [&] {
      if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
        for (const auto &[key, file] : input_files)
          text << "\n  file              " << file << "\n  its SHA-256       "
               << sha256_of_file(file);
    });
    text << "\n  libraries         " << libraries() << "\n  compiler          " << compiler();
    for (const auto &[machine, n_processes] : machines(communicator))
      text << "\n  machine           " << machine << ", " << n_processes
           << (n_processes == 1 ? " process" : " processes");
    return text.str();
  }
} // namespace signorini
