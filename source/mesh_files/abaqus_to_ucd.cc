// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/mesh_files/mesh_text.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

// deal.II has a reader of its own, but it drops data behind comments and follows references to
// elements and sets that do not exist. Both formats list the vertices of a cell in the same order.

namespace signorini
{
  namespace
  {
    using Words = std::vector<std::string>;


    /**
     * `*SURFACE, NAME=SS1`: the keyword, and the values by their names (empty for names without
     * value).
     */
    struct Keyword
    {
      std::string                        name;
      std::map<std::string, std::string> values;

      bool        has(const std::string &key) const { return values.count(key) > 0; }
      std::string value(const std::string &key) const { return has(key) ? values.at(key) : ""; }
    };

    struct Element
    {
      long  label;
      Words vertices;
    };

    /**
     * Vertices of the faces (2d: edges) of an element, counted from 1 as in Abaqus, around the
     * face.
     */
    const std::vector<std::vector<unsigned int>> faces_of_hexahedron =
      {{1, 2, 3, 4}, {5, 8, 7, 6}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1}};
    const std::vector<std::vector<unsigned int>> faces_of_quadrilateral = {{1, 2},
                                                                           {2, 3},
                                                                           {3, 4},
                                                                           {4, 1}};

    /** Ten times as many elements as a body may have. */
    constexpr long most_generated = 10000000;

    const char *const quadrilaterals = "(CPS|CPE|CAX|S|M3D|R3D|SFM3D)4[A-Z0-9]*";

    class Translator
    {
    public:
      void        read(std::istream &in);
      std::string ucd() const;

    private:
      void start(const std::string &line);
      void check_type(const std::string &type);
      void finish() const;
      void data(const Words &words, const std::string &line);
      void element(const Words &words);
      void surface(const Words &words, const std::string &line);
      void element_set(const Words &words);
      void face(const Element &element, unsigned int face_number, unsigned int id);
      long integer(const std::string &word) const;

      Keyword keyword;              ///< that the data below belong to
      bool    has_data      = true; ///< whether the keyword has data so far
      bool    has_hexahedra = false, has_quadrilaterals = false;
      Words   unfinished_element;
      std::map<std::string, std::set<long>>        sets;
      std::map<long, Words>                        nodes; ///< coordinates as written
      std::vector<Element>                         elements;
      std::map<long, std::size_t>                  element_of_label;
      std::vector<Words>                           faces;        ///< vertices around them
      std::vector<unsigned int>                    boundary_ids; ///< of the faces
      std::map<std::set<std::string>, std::size_t> known_faces;
    };

    Keyword parse_keyword(const std::string &line)
    {
      Keyword keyword;
      for (const std::string &word : split(line, ','))
        if (keyword.name.empty())
          keyword.name = word;
        else
          keyword.values[trim(word.substr(0, word.find('=')))] =
            word.find('=') == std::string::npos ? "" : trim(word.substr(word.find('=') + 1));
      return keyword;
    }

    /**
     * The digits of a name as a number, as deal.II reads boundary ids: 3 for SS3 and SURF-3, 0
     * without digits.
     */
    unsigned int number_in(const std::string &name)
    {
      std::string digits;
      std::copy_if(name.begin(), name.end(), std::back_inserter(digits), [](const unsigned char c) {
        return std::isdigit(c);
      });
      if (digits.size() > 9)
        throw MeshFileError("the number in the name of the surface `" + name
                            + "` is too large for a boundary id. " + MeshFileError::remedy);
      return digits.empty() ? 0 : std::stoul(digits);
    }

    void Translator::read(std::istream &in)
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

    void Translator::finish() const
    {
      if (!unfinished_element.empty())
        throw MeshFileError("the file is broken: element " + unfinished_element[0]
                            + " has too few vertices. " + MeshFileError::remedy);
      if (keyword.name == "*SURFACE" && !has_data)
        throw MeshFileError("the file is broken: the surface `" + keyword.value("NAME")
                            + "` has no faces. " + MeshFileError::remedy);
    }

    void Translator::start(const std::string &line)
    {
      finish();
      has_data = false;
      keyword  = parse_keyword(line);
      if (keyword.name == "*ELEMENT")
        check_type(keyword.value("TYPE"));
    }

    void Translator::check_type(const std::string &type)
    {
      // Labels of Abaqus are not longer, and a search for a pattern takes memory for each letter.
      constexpr std::size_t longest = 80;
      const auto            is      = [&](const char *pattern) {
        return type.size() <= longest && std::regex_match(type, std::regex(pattern));
      };
      const std::string head = "it has elements of type `" + type + "`. ";
      const std::string only = "Only quadrilaterals with 4 vertices (2d, CPE4 or CPS4) and "
                               "hexahedra with 8 (3d, C3D8) can be used. ";
      // What Gmsh writes into .inp files besides cells: faces, whose groups are element sets.
      const std::string save_as_msh =
        "Gmsh's .inp files have no surfaces with numbers; save the mesh as .msh (version 2.2 or "
        "4.1, "
        "text), where the numbers of physical groups are the boundary ids.";
      const bool is_hexahedron = is("C3D8[A-Z]*"), is_quadrilateral = is(quadrilaterals);
      if (is("T[23]D[23].*"))
        throw MeshFileError(head + save_as_msh);
      if (is("C3D(20|27).*|(CPS|CPE|CAX|S|M3D)(8|9).*"))
        throw MeshFileError(head + only + MeshFileError::first_order);
      if (!is_hexahedron && !is_quadrilateral)
        throw MeshFileError(head + only + MeshFileError::subdivide);
      has_hexahedra      = has_hexahedra || is_hexahedron;
      has_quadrilaterals = has_quadrilaterals || is_quadrilateral;
      if (has_hexahedra && has_quadrilaterals)
        throw MeshFileError("it has quadrilaterals besides hexahedra. " + save_as_msh);
    }

    long Translator::integer(const std::string &word) const
    {
      if (word.empty() || word.size() > 15
          || !std::all_of(
            word.begin(), word.end(), [](const unsigned char c) { return std::isdigit(c); }))
        throw MeshFileError("the file is broken: `" + word + "` below `" + keyword.name
                            + "` is not a number. " + MeshFileError::remedy);
      return std::stol(word);
    }

    void Translator::data(const Words &words, const std::string &line)
    {
      has_data = true;
      if (keyword.name == "*NODE")
        {
          Words coordinates(words.begin() + 1, words.end());
          coordinates.resize(3, "0");
          std::replace(coordinates.begin(), coordinates.end(), std::string(), std::string("0"));
          if (!nodes.emplace(integer(words[0]), coordinates).second)
            throw MeshFileError("node " + words[0]
                                + " is given twice. Only files with one part can be used.");
        }
      else if (keyword.name == "*ELEMENT")
        element(words);
      else if (keyword.name == "*ELSET")
        element_set(words);
      else if (keyword.name == "*SURFACE" && keyword.value("TYPE") != "NODE")
        surface(words, line);
    }

    void Translator::element_set(const Words &words)
    {
      std::set<long> &set = sets[keyword.value("ELSET")];
      if (keyword.has("GENERATE") && words.size() >= 2)
        {
          const long first = integer(words[0]), last = integer(words[1]);
          const long step = words.size() > 2 ? std::max(1L, integer(words[2])) : 1;
          if ((last - first) / step >= most_generated)
            throw MeshFileError("the file is broken: the element set `" + keyword.value("ELSET")
                                + "` goes from " + words[0] + " to " + words[1]
                                + ", which are more elements than can be used. "
                                + MeshFileError::remedy);
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

    void Translator::element(const Words &words)
    {
      // A long list goes on in the next line after a comma.
      for (const std::string &word : words)
        if (!word.empty())
          unfinished_element.push_back(std::to_string(integer(word)));
      const std::size_t n_vertices = keyword.value("TYPE").rfind("C3D8", 0) == 0 ? 8 : 4;
      if (unfinished_element.size() > 1 + n_vertices)
        throw MeshFileError("the file is broken: element " + unfinished_element[0]
                            + " has more than " + std::to_string(n_vertices) + " vertices. "
                            + MeshFileError::remedy);
      if (unfinished_element.size() < 1 + n_vertices)
        return;
      const long label = integer(unfinished_element[0]);
      if (!element_of_label.emplace(label, elements.size()).second)
        throw MeshFileError("element " + std::to_string(label)
                            + " is given twice. Only files with one part can be used.");
      elements.push_back({label, Words(unfinished_element.begin() + 1, unfinished_element.end())});
      if (keyword.has("ELSET"))
        sets[keyword.value("ELSET")].insert(label);
      unfinished_element.clear();
    }

    void Translator::surface(const Words &words, const std::string &line)
    {
      const std::string name = keyword.value("NAME");
      if (words.size() < 2 || !std::regex_match(words[1], std::regex("[SE][1-6]")))
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
          face(elements[element_of_label.at(label)], words[1][1] - '0', number_in(name));
        }
    }

    void
    Translator::face(const Element &element, const unsigned int face_number, const unsigned int id)
    {
      const auto &all = element.vertices.size() == 8 ? faces_of_hexahedron : faces_of_quadrilateral;
      if (face_number > all.size())
        throw MeshFileError("the file is broken: element " + std::to_string(element.label)
                            + " has no face " + std::to_string(face_number) + ". "
                            + MeshFileError::remedy);
      Words vertices;
      for (const unsigned int v : all[face_number - 1])
        vertices.push_back(element.vertices[v - 1]);
      const auto [known, is_new] =
        known_faces.emplace(std::set<std::string>(vertices.begin(), vertices.end()), faces.size());
      if (is_new)
        {
          faces.push_back(vertices);
          boundary_ids.push_back(id);
          return;
        }
      unsigned int &id_so_far = boundary_ids[known->second];
      if (id != 0 && id_so_far != 0 && id != id_so_far)
        throw MeshFileError(
          "face " + std::to_string(face_number) + " of element " + std::to_string(element.label)
          + " belongs to surfaces with the different numbers " + std::to_string(id_so_far) + " and "
          + std::to_string(id) + ". A face has one boundary id; keep one of the surfaces.");
      id_so_far = std::max(id, id_so_far);
    }

    std::string Translator::ucd() const
    {
      std::ostringstream out;
      out << nodes.size() << ' ' << elements.size() + faces.size() << " 0 0 0\n";
      for (const auto &[label, coordinates] : nodes)
        out << label << ' ' << join(coordinates, " ") << '\n';
      for (const Element &element : elements)
        out << element.label << (element.vertices.size() == 8 ? " 0 hex " : " 0 quad ")
            << join(element.vertices, " ") << '\n';
      for (std::size_t f = 0; f < faces.size(); ++f)
        out << "0 " << boundary_ids[f] << (faces[f].size() == 4 ? " quad " : " line ")
            << join(faces[f], " ") << '\n';
      return out.str();
    }
  } // namespace

  std::string abaqus_to_ucd(const std::string &text)
  {
    std::istringstream in(text);
    Translator         translator;
    translator.read(in);
    return translator.ucd();
  }
} // namespace signorini
