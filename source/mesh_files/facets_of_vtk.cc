// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/mesh_files/facet_mesh.h>
#include <signorini/mesh_files/mesh_numbers.h>
#include <signorini/mesh_files/mesh_text.h>

#include <sstream>

namespace signorini
{
  namespace
  {
    /** Of VTK: what is a facet, or made of facets. */
    enum VtkType : long
    {
      line      = 3,
      poly_line = 4,
      triangle  = 5,
      polygon   = 7,
      quad      = 9
    };

    class VtkReader
    {
    public:
      VtkReader(const std::string &text)
        : in(text)
      {
      }

      template <int dim>
      FacetMesh<dim> read();

    private:
      std::istringstream             in;
      std::vector<std::vector<long>> cells;
      std::vector<long>              types; ///< of the cells

      void read_cells(const std::string &section, long type);
    };


    void VtkReader::read_cells(const std::string &section, const long type)
    {
      const long n = next<long>(in, section), n_numbers = next<long>(in, section);
      if (n < 0 || n_numbers < n)
        throw MeshFileError("the file is broken: section " + section + " has an impossible length. "
                            + MeshFileError::remedy);
      refuse_offsets(in);
      for (long cell = 0; cell < n; ++cell)
        {
          const long n_vertices = next<long>(in, section);
          if (n_vertices < 1 || n_vertices > n_numbers)
            throw MeshFileError("the file is broken: a cell in section " + section
                                + " has an impossible number of vertices. "
                                + MeshFileError::remedy);
          cells.emplace_back();
          for (long v = 0; v < n_vertices; ++v)
            cells.back().push_back(next<long>(in, section));
          if (type > 0)
            types.push_back(type);
        }
    }


    template <int dim>
    FacetMesh<dim> VtkReader::read()
    {
      FacetMesh<dim> mesh;
      std::string    line_of_text, word;
      for (unsigned int header = 0; header < 3; ++header)
        std::getline(in, line_of_text);
      if (line_of_text.rfind("ASCII", 0) != 0)
        throw MeshFileError("it is no legacy VTK file in text: its third line is not `ASCII`. "
                            "Write it so.");
      while (in >> word)
        if (word == "POINTS")
          {
            const long n = next<long>(in, word);
            in >> word; // the type of the numbers
            for (long point = 0; point < n; ++point)
              {
                std::array<double, 3> place;
                for (double &coordinate : place)
                  coordinate = next<double>(in, "POINTS");
                mesh.vertices.push_back(point_of_file<dim>(place));
              }
          }
        else if (word == "CELLS")
          read_cells(word, 0);
        else if (word == "POLYGONS")
          read_cells(word, polygon);
        else if (word == "LINES")
          read_cells(word, poly_line);
        else if (word == "CELL_TYPES")
          {
            for (long n = next<long>(in, word); n > 0; --n)
              types.push_back(next<long>(in, "CELL_TYPES"));
          }
        else if (word == "POINT_DATA" || word == "CELL_DATA")
          break;
      if (types.size() != cells.size())
        throw MeshFileError("the file is broken: it has " + std::to_string(cells.size())
                            + " cells and " + std::to_string(types.size()) + " types. "
                            + MeshFileError::remedy);
      for (std::size_t cell = 0; cell < cells.size(); ++cell)
        {
          const long type   = types[cell];
          const bool across = type == triangle || type == polygon || type == quad;
          if (dim == 3 && across)
            add_polygon(mesh, cells[cell]);
          else if (dim == 2 && (type == line || type == poly_line))
            add_polygon(mesh, cells[cell]);
          else if (dim == 2 ? across : type > poly_line) // cells, whose boundary counts
            return {};
        }
      return mesh;
    }
  } // namespace


  template <int dim>
  FacetMesh<dim> facets_of_vtk(const std::string &text)
  {
    return VtkReader(text).read<dim>();
  }

  template FacetMesh<2> facets_of_vtk<2>(const std::string &);
  template FacetMesh<3> facets_of_vtk<3>(const std::string &);
} // namespace signorini
