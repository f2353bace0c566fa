// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/mesh_text.h>

#include <deal.II/base/mpi.h>

#include <fcntl.h>
#include <signorini_convert_mesh.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

extern char **environ;

namespace signorini
{
  namespace
  {
    /** Debian's packages belong to this one; another may come first in the path. */
    const char *python()
    {
      return access("/usr/bin/python3", X_OK) == 0 ? "/usr/bin/python3" : "python3";
    }


    /** A file without content, which is removed in the end. */
    class ScratchFile
    {
    public:
      ScratchFile()
      {
        std::error_code             error;
        const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
        path                               = (folder / "signorini_mesh_XXXXXX").string();
        const int descriptor               = error ? -1 : mkstemp(path.data());
        if (descriptor < 0)
          throw MeshFileError("it has to be converted, but no temporary file can be made. Set "
                              "TMPDIR to a folder that can be written to.");
        close(descriptor);
      }
      ScratchFile(const ScratchFile &) = delete;
      ~ScratchFile() { std::remove(path.c_str()); }

      std::string content() const
      {
        std::ifstream in(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(in), {});
      }

      std::string path;
    };


    /** Run the script, in silence. @return its exit status; -1 if it could not be started or ended
     */
    int run_script(const std::string &source, const std::string &target)
    {
      std::string words[]      = {python(), "-c", convert_mesh_script, source, target};
      char       *arguments[6] = {};
      for (unsigned int k = 0; k < 5; ++k)
        arguments[k] = words[k].data();
      posix_spawn_file_actions_t silence;
      posix_spawn_file_actions_init(&silence);
      for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&silence, stream, "/dev/null", O_RDWR, 0);
      pid_t     child  = 0;
      const int failed = posix_spawnp(&child, arguments[0], &silence, nullptr, arguments, environ);
      posix_spawn_file_actions_destroy(&silence);
      int status = 0;
      if (failed != 0)
        return -1;
      while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
          return -1;
      return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }


    /** Whether it worked, and the mesh; or a sentence why not. */
    std::pair<bool, std::string> convert(const std::string &path)
    {
      try
        {
          read_mesh_content(path); // says what is wrong if the file is not there
          const ScratchFile target;
          const int         status  = run_script(path, target.path);
          std::string       content = target.content();
          if (content.empty())
            content = "Python could not be run, which has to convert it. Install it with meshio "
                      "(Debian: `apt-get install python3-meshio`), or write the mesh as .msh.";
          return {status == 0, content};
        }
      catch (const MeshFileError &error)
        {
          return {false, error.what()};
        }
    }
  } // namespace


  std::string converted_to_gmsh(const std::string &path)
  {
    // A mesh is read several times: to check the scene, and for each body in the file.
    static std::map<std::string, std::pair<std::filesystem::file_time_type, std::string>> known;

    const bool first = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    std::pair<bool, std::string> result;
    if (first)
      {
        std::error_code error;
        const auto      time  = std::filesystem::last_write_time(path, error);
        const auto      found = known.find(path);
        if (found != known.end() && found->second.first == time)
          result = {true, found->second.second};
        else
          result = convert(path);
        if (result.first)
          known[path] = {time, result.second};
      }
    result = dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, result);
    if (!result.first)
      throw MeshFileError(result.second);
    return result.second;
  }
} // namespace signorini
