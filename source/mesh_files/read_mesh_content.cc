// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/mesh_files/mesh_content.h>
#include <signorini/mesh_files/mesh_text.h>

#include <algorithm>
#include <sstream>

namespace signorini
{
  namespace
  {
    /** Abaqus has keywords: lines that begin with a star. UCD has numbers only. */
    bool is_abaqus(const std::string &text)
    {
      return text[0] == '*' || text.find("\n*") != std::string::npos;
    }


    MeshContent content_of_inp(const std::string &text)
    {
      return is_abaqus(text) ? content_of_abaqus(text) : content_of_ucd(text);
    }


    /** A format of mesh files; without a reader it is left to meshio. */
    struct MeshFormat
    {
      std::vector<std::string> extensions;
      const char              *name;
      MeshContent (*read)(const std::string &text);
    };


    const std::vector<MeshFormat> &mesh_formats()
    {
      static const std::vector<MeshFormat> table = {{{".msh"}, "Gmsh", content_of_gmsh},
                                                    {{".inp"}, "Abaqus or UCD", content_of_inp},
                                                    {{".ucd"}, "UCD", content_of_ucd},
                                                    {{".vtk"}, "VTK", content_of_vtk},
                                                    {{".vtu"}, "VTK", nullptr},
                                                    {{".e", ".ex2", ".exo"}, "Exodus", nullptr},
                                                    {{".med"}, "MED", nullptr},
                                                    {{".bdf", ".fem", ".nas"}, "Nastran", nullptr},
                                                    {{".mesh"}, "Medit", nullptr},
                                                    {{".xdmf"}, "XDMF", nullptr}};
      return table;
    }


    const MeshFormat *format_with(const std::string &extension)
    {
      for (const MeshFormat &format : mesh_formats())
        if (std::find(format.extensions.begin(), format.extensions.end(), extension)
            != format.extensions.end())
          return &format;
      return nullptr;
    }


    /** Whether the head of a file of Gmsh or VTK announces numbers that are not text. */
    bool is_announced_as_binary(const std::string &extension, const std::string &content)
    {
      std::istringstream in(content);
      std::string        first, second, third;
      std::getline(in, first);
      std::getline(in, second);
      std::getline(in, third);
      return (extension == ".msh" && trim(first) == "$MeshFormat"
              && trim(second).find(" 1 ") != std::string::npos)
             || (extension == ".vtk" && trim(third) == "BINARY");
    }
  } // namespace


  bool is_mesh_extension(const std::string &extension)
  {
    return format_with(extension) != nullptr;
  }


  std::string list_of_mesh_formats()
  {
    std::vector<std::string> names;
    for (const MeshFormat &format : mesh_formats())
      names.push_back(join(format.extensions, ", ") + " (" + format.name + ")");
    return join(names);
  }


  MeshContent read_mesh_content_of(const std::string &path)
  {
    const std::string extension = extension_of(path);
    const MeshFormat *format    = format_with(extension);
    if (format == nullptr)
      throw MeshFileError("the extension `" + extension
                          + "` is not known. Valid: " + list_of_mesh_formats() + ".");
    if (format->read == nullptr)
      return content_of_gmsh(converted_to_gmsh(path));
    if (extension != ".msh" && extension != ".vtk")
      return format->read(read_mesh_lines(path));
    if (!is_announced_as_binary(extension, read_mesh_content(path)))
      return format->read(read_mesh_lines(path));
    try
      {
        return content_of_gmsh(converted_to_gmsh(path));
      }
    catch (const MeshFileError &error)
      {
        throw MeshFileError(std::string("it is a binary file, and ") + error.what()
                            + " Or write the mesh as text (ASCII); in Gmsh: `Mesh.Binary = 0`.");
      }
  }
} // namespace signorini
