// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/scene/output_directory.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

namespace signorini
{
  namespace fs = std::filesystem;

  namespace
  {
    [[noreturn]] void refuse_directory(const std::string &directory, const std::string &reason)
    {
      throw UserError("Output directory = " + directory + ": cannot write there: " + reason
                      + ". Choose another folder, or correct its permissions.");
    }

    /** Folders made for the check only; removed in reverse order, if they are still empty. */
    struct TemporaryFolders
    {
      ~TemporaryFolders()
      {
        std::error_code ignored;
        for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder)
          fs::remove(*folder, ignored);
      }
      std::vector<fs::path> folders;
    };
  } // namespace

  void check_output_directory(const std::string &directory)
  {
    TemporaryFolders made;
    fs::path         folder;
    for (const fs::path &name : fs::path(directory))
      {
        folder /= name;
        std::error_code error;
        if (fs::exists(folder, error) && !fs::is_directory(folder, error))
          refuse_directory(directory, "`" + folder.string() + "` is a file, not a folder");
        if (!fs::exists(folder, error) && fs::create_directory(folder, error))
          made.folders.push_back(folder);
        if (error)
          refuse_directory(directory, error.message());
      }

    const fs::path scratch = folder / ".signorini_write_test";
    std::ofstream  out(scratch);
    out << "test" << std::flush;
    const bool        written = out.good();
    const std::string reason  = std::strerror(errno);
    out.close();
    std::error_code ignored;
    fs::remove(scratch, ignored);
    if (!written)
      refuse_directory(directory, reason);
  }
} // namespace signorini
