// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/output/folder_lock.h>
#include <signorini/output/whole_file.h>

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

namespace signorini
{
  namespace
  {
    constexpr std::chrono::milliseconds patience(5000), pause(50);
  }


  FolderLock::FolderLock(const std::string &directory, const MPI_Comm communicator)
  {
    succeed_together(communicator, [&] {
      if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
        return;
      std::error_code error;
      std::filesystem::create_directories(directory, error);
      if (error)
        throw_write_error(directory, error.value());
      const std::string path = directory + "/log.txt";
      file                   = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
      if (file < 0)
        throw_write_error(path, errno);
      const auto begin = std::chrono::steady_clock::now();
      while (flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        {
          if (std::chrono::steady_clock::now() - begin > patience)
            throw RunError("another run is writing to `" + directory
                           + "`. Wait for its end, or choose another `Output directory`.");
          std::this_thread::sleep_for(pause);
        }
    });
  }


  FolderLock::~FolderLock()
  {
    if (file >= 0)
      close(file);
  }
} // namespace signorini
