// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_files_abaqus_mesh_h
#define vfife_mesh_files_abaqus_mesh_h

#include "abaqus_text.h"
#include "file_mesh.h"

#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace vfife
{
  /**
   * Nodes, elements and named sets with numbers of their own: a part, an assembly, or a file
   * without parts. Of an assembly nodes and elements are those of its instances and its own.
   */
  class AbaqusMesh
  {
  public:
    enum class ElementKind
    {
      hexahedron,
      face, ///< 4-node shells, membranes, plane elements: they make surfaces
      line  ///< trusses and beams, which programs write for edges
    };
    struct Element
    {
      ElementKind               kind;
      std::vector<unsigned int> nodes; ///< in the order of the file
      unsigned int              line;
      unsigned long             label;
    };
    struct Set
    {
      std::string               name;
      std::vector<unsigned int> members;
      bool                      is_internal = false;
    };
    struct Surface
    {
      std::string                 name;
      std::vector<FileMesh::Face> faces;
      /** Elements of which it has all faces that no other element has, and the line. */
      std::vector<std::pair<unsigned int, unsigned int>> free_elements;
      bool                                               is_internal = false;
    };

    /** @p text: refuses what contradicts itself, with the line that is read. It must outlive this
     * object. */
    explicit AbaqusMesh(AbaqusText &text);

    /** Adds the nodes and elements of @p part, moved, under the name of an instance. @p part must
     * outlive this object. */
    void
    add_instance(const std::string &name, const AbaqusMesh &part, const RigidMotion &placement);

    std::vector<Vector3>           nodes;
    std::vector<Element>           elements;
    std::map<std::string, Set>     node_sets, element_sets; ///< by abaqus_key() of the name
    std::map<std::string, Surface> surfaces;

    struct Instance
    {
      std::string       name;
      const AbaqusMesh *part;
      unsigned int      first_node, first_element;
    };
    std::map<std::string, Instance> instances; ///< by abaqus_key() of the name

  protected:
    using Index = std::unordered_map<unsigned long, unsigned int>;

    /** Numbers and sets in which words of data lines are looked up. */
    struct Scope
    {
      const AbaqusMesh *part;
      unsigned int      first_node, first_element;
    };

    void         add_node(unsigned long label, const Vector3 &place, const std::string &set);
    void         add_element(unsigned long                    label,
                             ElementKind                      kind,
                             const std::vector<unsigned int> &of_nodes,
                             const std::string               &set);
    unsigned int node(const std::string &word) const;
    unsigned int node(unsigned long label) const;

    Scope scope_of(const std::string &instance) const;
    /** Appends what a word of a set's data line means: a number, a set, or either of an instance.
     */
    void add_members(const std::string         &word,
                     const Scope               &scope,
                     bool                       of_nodes,
                     std::vector<unsigned int> &members) const;
    void add_range(const std::vector<std::string> &words,
                   const Scope                    &scope,
                   bool                            of_nodes,
                   std::vector<unsigned int>      &members) const;

    static Set &set_of(std::map<std::string, Set> &sets, const std::string &name);

    AbaqusText                                     &text_;
    Index                                           node_index_, element_index_;
    std::unordered_map<unsigned int, unsigned long> node_labels_; ///< of own nodes
  };
} // namespace vfife

#endif
