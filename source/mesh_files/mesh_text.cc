// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/mesh_text.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace signorini
{
  std::string extension_of(const std::string &path)
  {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(),
                   extension.end(),
                   extension.begin(),
                   [](const unsigned char c) { return std::tolower(c); });
    return extension;
  }

  std::string read_mesh_content(const std::string &path)
  {
    std::error_code error;
    if (!std::filesystem::exists(path, error))
      throw MeshFileError("there is no such file. Check the name; a relative path starts in the "
                          "folder of the scene.");
    if (std::filesystem::is_directory(path, error))
      throw MeshFileError("it is a directory. Name a mesh file in it.");
    std::ifstream in(path, std::ios::binary);
    if (!in)
      throw MeshFileError(std::strerror(errno) + std::string(". Check its permissions."));
    std::string content(std::istreambuf_iterator<char>(in), {});
    if (content.empty())
      throw MeshFileError("the file is empty. Write the mesh again.");
    return content;
  }

  std::string read_mesh_lines(const std::string &path)
  {
    std::string content = read_mesh_content(path);
    if (content.find('\0') != std::string::npos)
      throw MeshFileError(
        "it is a binary file. Write the mesh as text (ASCII); in Gmsh: `Mesh.Binary = 0`.");
    content.erase(std::remove(content.begin(), content.end(), '\r'), content.end());
    return content;
  }
} // namespace signorini
