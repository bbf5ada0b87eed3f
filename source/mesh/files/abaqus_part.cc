// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "abaqus_part.h"

#include <vfife/base/text/shown_text.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    constexpr std::size_t corners_of(const AbaqusPart::ElementKind kind)
    {
      return kind == AbaqusPart::ElementKind::hexahedron ? 8 : 4;
    }

    /** Places of the corners of the faces S1 to S6 in the file's order. */
    constexpr unsigned int corners_of_face[6][4] = {
      {0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};

    bool begins(const std::string &text, const char *beginning)
    {
      return text.rfind(beginning, 0) == 0;
    }

    bool is_capital(const char letter)
    {
      return letter >= 'A' && letter <= 'Z';
    }

    /** Far more than any file generates: a slip would else reserve all memory. */
    constexpr unsigned long most_generated = 100000000;
  } // namespace

  AbaqusPart::AbaqusPart(AbaqusText &text)
    : AbaqusMesh(text)
  {
  }

  bool AbaqusPart::read(const AbaqusKeyword &keyword)
  {
    const std::string &name = keyword.name;
    if (name == "NODE")
      read_nodes(keyword);
    else if (name == "SYSTEM")
      read_system();
    else if (name == "ELEMENT")
      read_elements(keyword);
    else if (name == "NSET" || name == "ELSET")
      read_set(keyword, name == "NSET");
    else if (name == "SURFACE")
      read_surface(keyword);
    else if (name == "NGEN")
      generate_nodes(keyword);
    else if (name == "ELGEN")
      generate_elements(keyword);
    else if (name == "ELCOPY")
      copy_elements(keyword);
    else
      return false;
    return true;
  }

  void AbaqusPart::read_nodes(const AbaqusKeyword &keyword)
  {
    text_.check_options(keyword, {"NSET", "SYSTEM"});
    const std::string system = abaqus_key(keyword.value("SYSTEM"));
    if (!system.empty() && system != "R" && system != "C")
      text_.refuse("expected SYSTEM=R or SYSTEM=C, got SYSTEM=" + shown(system));
    for (std::vector<std::string> words; text_.next_row(words);)
      {
        // Behind the coordinates three numbers may say the normal of a shell.
        if (words.empty() || words.size() > 7)
          text_.refuse("expected a node with its number and three coordinates");
        words.resize(7);
        Vector3 x;
        for (unsigned int c = 0; c < 3; ++c)
          x[c] = text_.number(words[c + 1]);
        if (system == "C")
          {
            const double angle = x[1] * degree;
            x                  = Vector3(x[0] * std::cos(angle), x[0] * std::sin(angle), x[2]);
          }
        add_node(text_.label(words[0]), system_(x), keyword.value("NSET"));
      }
  }

  /** Origin a, a point b of the axis x, in the second line a point c of the plane x, y. Nothing:
   * the file's own system. */
  void AbaqusPart::read_system()
  {
    std::vector<double> numbers;
    for (std::vector<std::string> words; text_.next_row(words);)
      for (const std::string &word : words)
        numbers.push_back(text_.number(word));
    if (numbers.empty())
      system_ = {};
    else if (numbers.size() == 3 || numbers.size() == 9)
      {
        const Vector3 a(numbers[0], numbers[1], numbers[2]);
        system_             = {};
        system_.translation = a;
        if (numbers.size() == 3)
          return;
        const Vector3 x = Vector3(numbers[3], numbers[4], numbers[5]) - a,
                      z = x.cross(Vector3(numbers[6], numbers[7], numbers[8]) - a);
        if (!(z.norm() > 0))
          text_.refuse("the three points of *SYSTEM lie on a line");
        system_.rotation.col(0) = x.normalized();
        system_.rotation.col(2) = z.normalized();
        system_.rotation.col(1) = system_.rotation.col(2).cross(system_.rotation.col(0));
      }
    else
      text_.refuse("expected *SYSTEM with one point, or with three points in two lines");
  }

  /** Hexahedra of all kinds, whose own formulation is left out, faces and lines. */
  AbaqusPart::ElementKind AbaqusPart::kind_of(const std::string &type, const unsigned int line)
  {
    const auto has_only_letters = [&type](const std::size_t from) {
      return std::all_of(type.begin() + static_cast<std::ptrdiff_t>(from), type.end(), is_capital);
    };
    const bool solid = begins(type, "C3D8") && has_only_letters(4);
    if (solid || type == "SC8R" || type == "SC8RT" || type == "CSS8")
      {
        // Kinds of integration are this program's own business.
        const std::string extra = solid ? type.substr(4) : type;
        if (!extra.empty() && extra != "R" && extra != "I")
          {
            const std::string warning =
              "elements of type " + type +
              " are read as hexahedra C3D8; their special properties are ignored";
            if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
              warnings.push_back(warning);
          }
        return ElementKind::hexahedron;
      }
    for (const char *face : {"S4", "M3D4", "SFM3D4", "CPS4", "CPE4", "R3D4"})
      if (begins(type, face) && has_only_letters(std::string(face).size()))
        return ElementKind::face;
    for (const char *line_type : {"T2D2", "T3D2", "B21", "B31"})
      if (type == line_type)
        return ElementKind::line;
    text_.refuse("expected 8-node hexahedra (C3D8), got elements of type " + shown(type), line);
  }

  void AbaqusPart::read_elements(const AbaqusKeyword &keyword)
  {
    text_.check_options(keyword, {"TYPE", "ELSET"});
    if (!keyword.has("TYPE"))
      text_.refuse("the TYPE of the elements is missing", keyword.line);
    const ElementKind kind = kind_of(abaqus_key(keyword.value("TYPE")), keyword.line);
    // An element may be divided over lines.
    std::vector<std::string> whole;
    for (std::vector<std::string> words; text_.next_row(words);)
      {
        whole.insert(whole.end(), words.begin(), words.end());
        const std::size_t wanted = 1 + corners_of(kind);
        if (kind == ElementKind::hexahedron && whole.size() < wanted)
          continue; // goes on in the next line
        if (kind == ElementKind::hexahedron && whole.size() > wanted)
          text_.refuse("expected an element with its number and eight nodes, got more");
        if (kind == ElementKind::face && whole.size() != wanted)
          text_.refuse("expected a 4-node element with its number and four nodes");
        std::vector<unsigned int> of_nodes;
        for (std::size_t i = 1; i < whole.size(); ++i)
          of_nodes.push_back(node(whole[i]));
        add_element(text_.label(whole[0]), kind, of_nodes, keyword.value("ELSET"));
        whole.clear();
      }
    if (!whole.empty())
      text_.refuse("the element before has fewer than eight nodes");
  }

  void AbaqusPart::read_set(const AbaqusKeyword &keyword, const bool of_nodes)
  {
    text_.check_options(keyword, {"NSET", "ELSET", "GENERATE", "INSTANCE", "INTERNAL", "UNSORTED"});
    const std::string name = keyword.value(of_nodes ? "NSET" : "ELSET");
    if (name.empty())
      text_.refuse("the name of the set is missing");
    const Scope               scope = scope_of(keyword.value("INSTANCE"));
    std::vector<unsigned int> members;
    if (of_nodes && keyword.has("ELSET"))
      {
        std::vector<unsigned int> of_set;
        add_members(keyword.value("ELSET"), scope, false, of_set);
        for (const unsigned int element : of_set)
          members.insert(members.end(),
                         elements[element].nodes.begin(),
                         elements[element].nodes.end());
      }
    for (std::vector<std::string> words; text_.next_row(words);)
      if (keyword.has("GENERATE"))
        add_range(words, scope, of_nodes, members);
      else
        for (const std::string &word : words)
          add_members(word, scope, of_nodes, members);
    Set &set = set_of(of_nodes ? node_sets : element_sets, name);
    set.members.insert(set.members.end(), members.begin(), members.end());
    set.is_internal = keyword.has("INTERNAL");
  }

  void AbaqusPart::read_surface(const AbaqusKeyword &keyword)
  {
    // Offsets and thicknesses are of shells.
    text_.check_options(
      keyword, {"NAME", "TYPE", "INTERNAL", "MAXRATIO", "NOTHICK", "NOOFFSET", "SCALETHICK"});
    const std::string name = keyword.value("NAME"), type = abaqus_key(keyword.value("TYPE"));
    if (name.empty())
      text_.refuse("the name of the surface is missing");
    const Scope here = scope_of("");
    if (type == "NODE")
      {
        // Nodes or their sets; a second word is the area of each.
        Set &set = set_of(node_sets, name);
        for (std::vector<std::string> words; text_.next_row(words);)
          if (!words.empty())
            add_members(words[0], here, true, set.members);
        return;
      }
    if (!type.empty() && type != "ELEMENT")
      text_.refuse("expected TYPE=ELEMENT or TYPE=NODE, got TYPE=" + shown(type));
    Surface &surface = surfaces[abaqus_key(name)];
    if (surface.name.empty())
      surface.name = name;
    surface.is_internal = keyword.has("INTERNAL");
    for (std::vector<std::string> words; text_.next_row(words);)
      {
        words.resize(std::max<std::size_t>(words.size(), 2));
        const std::string         side = abaqus_key(words[1]);
        std::vector<unsigned int> of_elements;
        add_members(words[0], here, false, of_elements);
        for (const unsigned int element : of_elements)
          {
            const auto &corners       = elements[element].nodes;
            const bool  is_hexahedron = elements[element].kind == ElementKind::hexahedron;
            if (is_hexahedron && side.empty())
              surface.free_elements.emplace_back(element, text_.line());
            else if (is_hexahedron && side.size() == 2 && side[0] == 'S' && side[1] >= '1' &&
                     side[1] <= '6')
              {
                FileMesh::Face face{{}, text_.line()};
                for (unsigned int i = 0; i < 4; ++i)
                  face.nodes[i] = corners[corners_of_face[side[1] - '1'][i]];
                surface.faces.push_back(face);
              }
            else if (elements[element].kind == ElementKind::face &&
                     (side.empty() || side == "SPOS" || side == "SNEG"))
              surface.faces.push_back(
                {{{corners[0], corners[1], corners[2], corners[3]}}, text_.line()});
            else
              text_.refuse("a line of *SURFACE must be an element or ELSET, and a face S1 to S6");
          }
      }
  }

  /** First and last node and the increment of numbers: nodes at equal distances on the line. */
  void AbaqusPart::generate_nodes(const AbaqusKeyword &keyword)
  {
    text_.check_options(keyword, {"NSET"});
    for (std::vector<std::string> words; text_.next_row(words);)
      {
        if (words.size() < 2 || words.size() > 3)
          text_.refuse(
            "expected *NGEN with the first node, the last node and the increment of their numbers");
        const unsigned long first = text_.label(words[0]), last = text_.label(words[1]),
                            step = words.size() > 2 ? text_.label(words[2]) : 1;
        if (last <= first || step == 0 || (last - first) % step != 0 ||
            (last - first) / step > most_generated)
          text_.refuse("numbers of *NGEN must rise from the first to the last by the increment");
        const Vector3       begin = nodes[node(first)], end = nodes[node(last)];
        const unsigned long n = (last - first) / step;
        for (unsigned long i = 1; i < n; ++i)
          {
            const double part = static_cast<double>(i) / static_cast<double>(n);
            add_node(first + i * step, (1 - part) * begin + part * end, keyword.value("NSET"));
          }
        if (keyword.has("NSET"))
          for (const unsigned long end_label : {first, last})
            set_of(node_sets, keyword.value("NSET")).members.push_back(node(end_label));
      }
  }

  /** An element, then up to three times: how many in a row, layer or block, and the increments of
   * the numbers of nodes and elements. */
  void AbaqusPart::generate_elements(const AbaqusKeyword &keyword)
  {
    text_.check_options(keyword, {"ELSET"});
    std::vector<std::string> whole;
    for (std::vector<std::string> words; text_.next_row(words);)
      {
        whole.insert(whole.end(), words.begin(), words.end());
        if (text_.goes_on())
          continue;
        if (whole.size() < 2 || whole.size() > 10)
          text_.refuse("expected *ELGEN with an element, and up to three times a number of "
                       "elements and the increments of node and element numbers");
        whole.resize(10);
        unsigned long numbers[10];
        for (unsigned int i = 0; i < 10; ++i)
          numbers[i] = whole[i].empty() ? 1 : text_.label(whole[i]);
        const auto found = element_index_.find(numbers[0]);
        if (found == element_index_.end())
          text_.refuse("element " + shown(whole[0]) + " does not exist");
        if (numbers[1] == 0 || numbers[4] == 0 || numbers[7] == 0 ||
            numbers[1] > most_generated / numbers[4] / numbers[7])
          text_.refuse("the numbers of elements of *ELGEN must be at least 1");
        const Element     master = elements[found->second];
        const std::string set    = keyword.value("ELSET");
        if (!set.empty())
          set_of(element_sets, set).members.push_back(found->second);
        for (unsigned long k = 0; k < numbers[7]; ++k)
          for (unsigned long j = 0; j < numbers[4]; ++j)
            for (unsigned long i = 0; i < numbers[1]; ++i)
              {
                if (i + j + k == 0)
                  continue;
                std::vector<unsigned int> of_nodes;
                for (const unsigned int corner : master.nodes)
                  of_nodes.push_back(node(node_labels_.at(corner) + i * numbers[2] +
                                          j * numbers[5] + k * numbers[8]));
                add_element(master.label + i * numbers[3] + j * numbers[6] + k * numbers[9],
                            master.kind,
                            of_nodes,
                            set);
              }
        whole.clear();
      }
  }

  void AbaqusPart::copy_elements(const AbaqusKeyword &keyword)
  {
    text_.check_options(keyword, {"CHANGENUMBER", "OLDSET", "SHIFTNODES", "NEWSET"});
    const auto found = element_sets.find(abaqus_key(keyword.value("OLDSET")));
    if (found == element_sets.end())
      text_.refuse("element set \"" + shown(keyword.value("OLDSET")) + "\" does not exist");
    const unsigned long change = text_.label(keyword.value("CHANGENUMBER")),
                        shift =
                          keyword.has("SHIFTNODES") ? text_.label(keyword.value("SHIFTNODES")) : 0;
    const std::vector<unsigned int> members = found->second.members;
    for (const unsigned int member : members)
      {
        const Element             original = elements[member];
        std::vector<unsigned int> of_nodes;
        for (const unsigned int corner : original.nodes)
          of_nodes.push_back(node(node_labels_.at(corner) + shift));
        add_element(original.label + change, original.kind, of_nodes, keyword.value("NEWSET"));
      }
  }
} // namespace vfife
