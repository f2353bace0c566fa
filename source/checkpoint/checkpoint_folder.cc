// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/build_information.h>
#include <signorini/base/spelling.h>
#include <signorini/checkpoint/checkpoint_folder.h>
#include <signorini/checkpoint/shared_file.h>
#include <signorini/output/whole_file.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace signorini
{
  namespace
  {
    namespace fs = std::filesystem;

    const char *const latest = "checkpoint", *const previous = "checkpoint.previous",
                      *const unfinished = "checkpoint.part", *const manifest = "manifest";

    /** To be raised whenever another archive() writes something else. */
    constexpr unsigned int format = 11;

    std::string program()
    {
      return trim(version()) + ", checkpoint format " + std::to_string(format);
    }


    void write_manifest(const fs::path &folder)
    {
      std::ostringstream text;
      text << program() << '\n';
      for (const auto &entry : fs::directory_iterator(folder))
        text << entry.path().filename().string() << ' ' << entry.file_size() << ' '
             << checksum(entry.path()) << '\n';
      text << "end\n";
      write_whole_file((folder / manifest).string(), [&](std::ostream &out) { out << text.str(); });
    }


    /** What is wrong with a checkpoint; empty: nothing. */
    std::string fault(const fs::path &folder)
    {
      if (!fs::is_directory(folder))
        return "there is no `" + folder.string() + "`";
      std::ifstream file(folder / manifest);
      std::string   writer, name;
      if (!std::getline(file, writer))
        return "`" + folder.string() + "` has no manifest";
      if (writer != program())
        return "`" + folder.string() + "` was written by " + writer + "; this is " + program();
      while (file >> name && name != "end")
        {
          std::uintmax_t  length = 0;
          std::uint32_t   sum    = 0;
          std::error_code error;
          file >> length >> sum;
          const fs::path path = folder / name;
          if (!file || fs::file_size(path, error) != length || error || checksum(path) != sum)
            return "`" + path.string() + "` is damaged";
        }
      return name == "end" ? "" : "`" + (folder / manifest).string() + "` is damaged";
    }
  } // namespace


  CheckpointFolder::CheckpointFolder(const std::string &output_directory,
                                     const MPI_Comm     communicator)
    : directory(output_directory)
    , communicator(communicator)
    , first_process(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
  {
  }


  void
  CheckpointFolder::write(const std::function<void(const std::string &folder)> &write_files) const
  {
    const fs::path part = fs::path(directory) / unfinished;
    succeed_together(communicator, [&] {
      if (!first_process)
        return;
      fs::remove_all(part);
      fs::create_directories(part);
    });
    write_files(part.string());
    succeed_together(communicator, [&] {
      if (!first_process)
        return;
      write_manifest(part);
      const fs::path now = fs::path(directory) / latest, before = fs::path(directory) / previous;
      if (fs::exists(now))
        {
          fs::remove_all(before);
          fs::rename(now, before);
        }
      fs::rename(part, now);
    });
  }


  CheckpointFolder::Found CheckpointFolder::find() const
  {
    Found found;
    succeed_together(communicator, [&] {
      if (!first_process)
        return;
      for (const char *name : {latest, previous})
        {
          const fs::path    folder = fs::path(directory) / name;
          const std::string wrong  = fault(folder);
          if (wrong.empty())
            {
              found.folder = folder.string();
              return;
            }
          if (name == latest || fs::exists(folder))
            found.rejected.push_back(wrong);
        }
    });
    found.folder   = dealii::Utilities::MPI::broadcast(communicator, found.folder, 0);
    found.rejected = dealii::Utilities::MPI::broadcast(communicator, found.rejected, 0);
    return found;
  }


  void CheckpointFolder::remove() const
  {
    succeed_together(communicator, [&] {
      if (first_process)
        for (const char *name : {latest, previous, unfinished})
          fs::remove_all(fs::path(directory) / name);
    });
  }
} // namespace signorini
