// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "abaqus_mesh.h"

#include <vfife/base/text/shown_text.h>

namespace vfife
{
  namespace
  {
    bool is_label(const std::string &word)
    {
      return !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
    }
  } // namespace

  AbaqusMesh::AbaqusMesh(AbaqusText &text)
    : text_(text)
  {
  }

  AbaqusMesh::Set &AbaqusMesh::set_of(std::map<std::string, Set> &sets, const std::string &name)
  {
    Set &set = sets[abaqus_key(name)];
    if (set.name.empty())
      set.name = name;
    return set;
  }

  void AbaqusMesh::add_node(const unsigned long label, const Vector3 &place, const std::string &set)
  {
    if (!node_index_.emplace(label, nodes.size()).second)
      text_.refuse("duplicate node " + std::to_string(label));
    node_labels_.emplace(nodes.size(), label);
    if (!set.empty())
      set_of(node_sets, set).members.push_back(nodes.size());
    nodes.push_back(place);
  }

  void AbaqusMesh::add_element(const unsigned long              label,
                               const ElementKind                kind,
                               const std::vector<unsigned int> &of_nodes,
                               const std::string               &set)
  {
    if (!element_index_.emplace(label, elements.size()).second)
      text_.refuse("duplicate element " + std::to_string(label));
    if (!set.empty())
      set_of(element_sets, set).members.push_back(elements.size());
    elements.push_back({kind, of_nodes, text_.line(), label});
  }

  unsigned int AbaqusMesh::node(const unsigned long label) const
  {
    const auto found = node_index_.find(label);
    if (found == node_index_.end())
      text_.refuse("node " + std::to_string(label) + " does not exist");
    return found->second;
  }

  unsigned int AbaqusMesh::node(const std::string &word) const
  {
    return node(text_.label(word));
  }

  void AbaqusMesh::add_instance(const std::string &name,
                                const AbaqusMesh  &part,
                                const RigidMotion &placement)
  {
    const unsigned int first_node = nodes.size(), first_element = elements.size();
    if (!instances.emplace(abaqus_key(name), Instance{name, &part, first_node, first_element})
           .second)
      text_.refuse("duplicate instance " + shown(name));
    for (const Vector3 &x : part.nodes)
      nodes.push_back(placement(x));
    for (Element element : part.elements)
      {
        for (unsigned int &node : element.nodes)
          node += first_node;
        elements.push_back(std::move(element));
      }
  }

  AbaqusMesh::Scope AbaqusMesh::scope_of(const std::string &instance) const
  {
    if (instance.empty())
      return {this, 0, 0};
    const auto found = instances.find(abaqus_key(instance));
    if (found == instances.end())
      text_.refuse("instance \"" + shown(instance) + "\" does not exist");
    return {found->second.part, found->second.first_node, found->second.first_element};
  }

  void AbaqusMesh::add_members(const std::string         &word,
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

  void AbaqusMesh::add_range(const std::vector<std::string> &words,
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
} // namespace vfife
