// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/mesh_files/abaqus_type.h>
#include <signorini/mesh_files/mesh_content.h>
#include <signorini/mesh_files/mesh_text.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>

// deal.II has a reader of its own, but it drops data behind comments and follows references to
// elements and sets that do not exist.

namespace signorini
{
  namespace
  {
    using Words = std::vector<std::string>;

    struct AbaqusElement
    {
      AbaqusType        type;
      long              label = 0;
      std::vector<long> nodes;
      std::string       set; ///< in the line of its keyword
    };

    /** A face of an element. */
    struct AbaqusFace
    {
      std::size_t  element;
      unsigned int number; ///< from 1
      std::string  surface;
    };

    /** Ten times as many elements as a body may have. */
    constexpr long most_generated = 10000000;


    class AbaqusReader
    {
    public:
      void        read(std::istream &in);
      MeshContent content() const;

    private:
      void   start(const std::string &line);
      void   finish() const;
      void   data(const Words &words, const std::string &line);
      void   node(const Words &words);
      void   element(const Words &words);
      void   surface(const Words &words, const std::string &line);
      void   element_set(const Words &words);
      void   face(std::size_t element, unsigned int number);
      long   integer(const std::string &word) const;
      double real(const std::string &word) const;

      void add_elements(MeshContent &content) const;
      void add_faces(MeshContent &content) const;
      void add_sets(MeshContent &content) const;

      AbaqusKeyword                           keyword;         ///< that the data below belong to
      AbaqusType                              type;            ///< of the elements below
      bool                                    has_data = true; ///< below the keyword, so far
      std::vector<long>                       unfinished_element;
      std::map<std::string, std::set<long>>   sets;       ///< all of them
      std::set<std::string>                   named_sets; ///< those with a keyword of their own
      std::map<long, dealii::Point<3>>        nodes;
      std::vector<AbaqusElement>              elements;
      std::map<long, std::size_t>             element_of_label;
      std::vector<AbaqusFace>                 faces;
      std::map<std::set<long>, unsigned long> known_faces; ///< by their nodes
    };


    void AbaqusReader::read(std::istream &in)
    {
      std::string line;
      while (std::getline(in, line))
        {
          std::transform(line.begin(), line.end(), line.begin(), [](const unsigned char c) {
            return std::toupper(c);
          });
          line = trim(line);
          if (line.empty() || line.rfind("**", 0) == 0)
            continue;
          if (line.rfind("*STEP", 0) == 0)
            break; // the mesh stands before the first step of the history
          if (line[0] == '*')
            start(line);
          else
            data(split(line, ','), line);
        }
      finish();
      if (nodes.empty() || elements.empty())
        throw MeshFileError("it has no mesh: there is no `*NODE` or no `*ELEMENT` with data. "
                            + MeshFileError::remedy);
    }


    void AbaqusReader::finish() const
    {
      if (!unfinished_element.empty())
        throw MeshFileError("the file is broken: element " + std::to_string(unfinished_element[0])
                            + " has too few vertices. " + MeshFileError::remedy);
      if (keyword.name == "*SURFACE" && !has_data)
        throw MeshFileError("the file is broken: the surface `" + keyword.value("NAME")
                            + "` has no faces. " + MeshFileError::remedy);
    }


    void AbaqusReader::start(const std::string &line)
    {
      finish();
      has_data = false;
      keyword  = parse_abaqus_keyword(line);
      if (keyword.name == "*ELEMENT")
        type = abaqus_type(keyword.value("TYPE"));
    }


    long AbaqusReader::integer(const std::string &word) const
    {
      if (word.size() > 15 || !consists_of(word, "0123456789"))
        throw MeshFileError("the file is broken: `" + word + "` below `" + keyword.name
                            + "` is not a number. " + MeshFileError::remedy);
      return std::stol(word);
    }


    double AbaqusReader::real(const std::string &word) const
    {
      if (word.empty())
        return 0.;
      std::string with_e = word; // 1.5D0 is what Fortran writes
      std::replace(with_e.begin(), with_e.end(), 'D', 'E');
      char        *end    = nullptr;
      const double number = std::strtod(with_e.c_str(), &end);
      if (*end != '\0' || !std::isfinite(number))
        throw MeshFileError("the file is broken: `" + word + "` below `" + keyword.name
                            + "` is not a number. " + MeshFileError::remedy);
      return number;
    }


    void AbaqusReader::data(const Words &words, const std::string &line)
    {
      has_data = true;
      if (keyword.name == "*NODE")
        node(words);
      else if (keyword.name == "*ELEMENT")
        element(words);
      else if (keyword.name == "*ELSET")
        element_set(words);
      else if (keyword.name == "*SURFACE" && keyword.value("TYPE") != "NODE")
        surface(words, line);
    }


    void AbaqusReader::node(const Words &words)
    {
      dealii::Point<3> point;
      for (std::size_t c = 0; c < 3 && c + 1 < words.size(); ++c)
        point[c] = real(words[c + 1]);
      if (!nodes.emplace(integer(words[0]), point).second)
        throw MeshFileError("node " + words[0]
                            + " is given twice. Only files with one part can be used.");
    }


    void AbaqusReader::element_set(const Words &words)
    {
      const std::string name = keyword.value("ELSET");
      std::set<long>   &set  = sets[name];
      named_sets.insert(name);
      if (keyword.has("GENERATE") && words.size() >= 2)
        {
          const long first = integer(words[0]), last = integer(words[1]);
          const long step = words.size() > 2 ? std::max(1L, integer(words[2])) : 1;
          if ((last - first) / step >= most_generated)
            throw MeshFileError(
              "the file is broken: the element set `" + name + "` goes from " + words[0] + " to "
              + words[1] + ", which are more elements than can be used. " + MeshFileError::remedy);
          for (long label = first; label <= last; label += step)
            set.insert(label);
        }
      else
        for (const std::string &word : words)
          if (sets.count(word) > 0)
            set.merge(std::set<long>(sets[word]));
          else if (!word.empty())
            set.insert(integer(word));
    }


    void AbaqusReader::element(const Words &words)
    {
      // A long list goes on in the next line after a comma.
      for (const std::string &word : words)
        if (!word.empty())
          unfinished_element.push_back(integer(word));
      if (unfinished_element.size() > 1 + type.n_nodes)
        throw MeshFileError("the file is broken: element " + std::to_string(unfinished_element[0])
                            + " has more than " + std::to_string(type.n_nodes) + " vertices. "
                            + MeshFileError::remedy);
      if (unfinished_element.size() < 1 + type.n_nodes)
        return;
      const long label = unfinished_element[0];
      if (!element_of_label.emplace(label, elements.size()).second)
        throw MeshFileError("element " + std::to_string(label)
                            + " is given twice. Only files with one part can be used.");
      elements.push_back({type,
                          label,
                          {unfinished_element.begin() + 1, unfinished_element.end()},
                          keyword.value("ELSET")});
      if (keyword.has("ELSET"))
        sets[keyword.value("ELSET")].insert(label);
      unfinished_element.clear();
    }


    void AbaqusReader::surface(const Words &words, const std::string &line)
    {
      const std::string name    = keyword.value("NAME");
      const bool        is_face = words.size() >= 2 && words[1].size() == 2
                           && (words[1][0] == 'S' || words[1][0] == 'E') && words[1][1] >= '1'
                           && words[1][1] <= '6';
      if (!is_face)
        throw MeshFileError(
          "the surface `" + name + "` has the line `" + line
          + "`. Surfaces must consist of faces of elements: `element or element set, S1` to `S6`.");
      const bool is_number = words[0].find_first_not_of("0123456789") == std::string::npos;
      if (sets.count(words[0]) == 0 && !is_number)
        throw MeshFileError("the file is broken: the surface `" + name + "` has the line `" + line
                            + "`, but there is no element set `" + words[0] + "`. "
                            + MeshFileError::remedy);
      const std::set<long> labels =
        sets.count(words[0]) > 0 ? sets.at(words[0]) : std::set<long>{integer(words[0])};
      for (const long label : labels)
        {
          if (element_of_label.count(label) == 0)
            throw MeshFileError("the file is broken: the surface `" + name + "` has the element "
                                + std::to_string(label) + ", which does not exist. "
                                + MeshFileError::remedy);
          face(element_of_label.at(label), words[1][1] - '0');
        }
    }


    void AbaqusReader::face(const std::size_t index, const unsigned int number)
    {
      const AbaqusElement &element = elements[index];
      const auto          &all     = shape_of(element.type.kind).faces;
      if (number > all.size())
        throw MeshFileError("the file is broken: element " + std::to_string(element.label)
                            + " has no face " + std::to_string(number) + ". "
                            + MeshFileError::remedy);
      std::set<long> corners;
      for (const unsigned int v : all[number - 1])
        corners.insert(element.nodes[v]);
      const unsigned int id        = number_in_abaqus_name(keyword.value("NAME"));
      unsigned long     &id_so_far = known_faces[corners];
      if (id != 0 && id_so_far != 0 && id != id_so_far)
        throw MeshFileError(
          "face " + std::to_string(number) + " of element " + std::to_string(element.label)
          + " belongs to surfaces with the different numbers " + std::to_string(id_so_far) + " and "
          + std::to_string(id) + ". A face has one boundary id; keep one of the surfaces.");
      if (id != 0)
        id_so_far = id;
      faces.push_back({index, number, keyword.value("NAME")});
    }


    void AbaqusReader::add_elements(MeshContent &content) const
    {
      std::map<long, unsigned int> point_of_label;
      for (const auto &[label, point] : nodes)
        {
          point_of_label[label] = content.points.size();
          content.points.push_back(point);
        }
      for (const AbaqusElement &element : elements)
        {
          std::vector<unsigned int> points;
          for (const long node : element.nodes)
            {
              if (point_of_label.count(node) == 0)
                throw MeshFileError("the file is broken: cell " + std::to_string(element.label)
                                    + " has the vertex " + std::to_string(node)
                                    + ", which does not exist. " + MeshFileError::remedy);
              points.push_back(point_of_label.at(node));
            }
          MeshElement added;
          added.kind  = element.type.kind;
          added.label = element.label;
          content.add(added, points, shape_of(added.kind).edges);
        }
    }


    void AbaqusReader::add_faces(MeshContent &content) const
    {
      constexpr CellKind kinds[] = {CellKind::line, CellKind::triangle, CellKind::quadrilateral};
      std::map<std::string, unsigned int> group_of_surface;
      for (const AbaqusFace &face : faces)
        {
          const MeshElement &cell    = content.elements[face.element];
          const CellShape   &shape   = shape_of(cell.kind);
          const auto        &corners = shape.faces[face.number - 1];
          const auto [group, is_new] =
            group_of_surface.emplace(face.surface, content.groups.size());
          if (is_new)
            content.groups.push_back(
              {shape.dim - 1, number_in_abaqus_name(face.surface), face.surface});
          MeshElement added;
          added.kind   = kinds[corners.size() - 2];
          added.label  = cell.label;
          added.groups = {group->second};
          std::transform(corners.begin(),
                         corners.end(),
                         added.corners.begin(),
                         [&](const unsigned int v) { return cell.corners[v]; });
          content.elements.push_back(added);
        }
    }


    /** A set is one group of cells and one of faces, if it has both. */
    void AbaqusReader::add_sets(MeshContent &content) const
    {
      unsigned int dim_of_cells = 0;
      for (const MeshElement &element : content.elements)
        dim_of_cells = std::max(dim_of_cells, shape_of(element.kind).dim);
      std::set<long> in_named_sets;
      for (const std::string &name : named_sets)
        in_named_sets.insert(sets.at(name).begin(), sets.at(name).end());
      for (const auto &[name, labels] : sets)
        {
          std::map<unsigned int, unsigned int> group_of_dim;
          for (const long label : labels)
            if (const auto found = element_of_label.find(label); found != element_of_label.end())
              {
                // Gmsh puts all elements into sets by the parts of the geometry; what the user
                // named comes behind.
                const unsigned int dim = shape_of(content.elements[found->second].kind).dim;
                if (dim < dim_of_cells && named_sets.count(name) == 0
                    && in_named_sets.count(label) > 0)
                  continue;
                const auto [group, is_new] = group_of_dim.emplace(dim, content.groups.size());
                if (is_new)
                  content.groups.push_back({dim, 0, name});
                content.elements[found->second].groups.push_back(group->second);
              }
        }
    }


    MeshContent AbaqusReader::content() const
    {
      MeshContent result;
      add_elements(result);
      add_faces(result);
      add_sets(result);
      result.number_groups();
      return result;
    }
  } // namespace


  MeshContent content_of_abaqus(const std::string &text)
  {
    std::istringstream in(text);
    AbaqusReader       reader;
    reader.read(in);
    return reader.content();
  }
} // namespace signorini
