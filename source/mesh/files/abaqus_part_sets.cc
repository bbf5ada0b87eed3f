// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// *NSET, *ELSET, *SURFACE.
#include "abaqus_part.h"

#include <vfife/base/text/shown_text.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    /** Places of the corners of the faces S1 to S6 in the file's order. */
    constexpr unsigned int corners_of_face[6][4] = {
      {0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};

    bool is_label(const std::string &word)
    {
      return !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
    }
  } // namespace

  AbaqusPart::Scope AbaqusPart::scope_of(const std::string &instance) const
  {
    if (instance.empty())
      return {this, 0, 0};
    const auto found = instances.find(abaqus_key(instance));
    if (found == instances.end())
      text_.refuse("instance \"" + shown(instance) + "\" does not exist");
    return {found->second.part, found->second.first_node, found->second.first_element};
  }

  void AbaqusPart::add_members(const std::string         &word,
                               const Scope               &scope,
                               const bool                 of_nodes,
                               std::vector<unsigned int> &members) const
  {
    if (word.empty())
      return;
    const unsigned int first = of_nodes ? scope.first_node : scope.first_element;
    if (is_label(word))
      {
        const Index &index = of_nodes ? scope.part->node_index_ : scope.part->element_index_;
        const auto   found = index.find(text_.label(word));
        if (found == index.end())
          text_.refuse((of_nodes ? "node " : "element ") + word + " does not exist");
        members.push_back(first + found->second);
        return;
      }
    const auto &sets = of_nodes ? scope.part->node_sets : scope.part->element_sets;
    const auto  set  = sets.find(abaqus_key(word));
    if (set != sets.end())
      {
        // A copy: a set may be added to itself.
        const std::vector<unsigned int> added = set->second.members;
        for (const unsigned int member : added)
          members.push_back(first + member);
        return;
      }
    // INSTANCE.NUMBER or INSTANCE.SET
    const std::size_t point = word.find('.');
    if (point != std::string::npos &&
        scope.part->instances.count(abaqus_key(word.substr(0, point))) != 0)
      add_members(word.substr(point + 1),
                  scope.part->scope_of(word.substr(0, point)),
                  of_nodes,
                  members);
    else
      text_.refuse(std::string(of_nodes ? "node set" : "element set") + " \"" + shown(word) +
                   "\" does not exist before this line");
  }

  void AbaqusPart::add_range(const std::vector<std::string> &words,
                             const Scope                    &scope,
                             const bool                      of_nodes,
                             std::vector<unsigned int>      &members) const
  {
    if (words.size() < 2 || words.size() > 3)
      text_.refuse("expected GENERATE with first number, last number and step");
    const unsigned long step = words.size() > 2 ? text_.label(words[2]) : 1;
    if (step == 0)
      text_.refuse("the step of GENERATE must not be 0");
    // Not from the first number to the last: they may be far from each other.
    const unsigned long first = text_.label(words[0]), last = text_.label(words[1]);
    const Index        &index = of_nodes ? scope.part->node_index_ : scope.part->element_index_;
    for (const auto &[number, place] : index)
      if (number >= first && number <= last && (number - first) % step == 0)
        members.push_back((of_nodes ? scope.first_node : scope.first_element) + place);
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
} // namespace vfife
