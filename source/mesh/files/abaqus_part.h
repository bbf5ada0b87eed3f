// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_files_abaqus_part_h
#define vfife_mesh_files_abaqus_part_h

#include "abaqus_text.h"
#include "file_mesh.h"

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace vfife
{
  /**
   * Nodes, elements and named sets with numbers of their own: a part, an assembly, or a file
   * without parts. Of an assembly nodes and elements are those of its instances and its own.
   */
  class AbaqusPart
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

    explicit AbaqusPart(AbaqusText &text);

    /** Reads the data of a keyword; false where it is none of a mesh. */
    bool read(const AbaqusKeyword &keyword);

    /** Adds the nodes and elements of @p part, moved, under the name of an instance. @p part must
     * outlive this object. */
    void
    add_instance(const std::string &name, const AbaqusPart &part, const RigidMotion &placement);

    std::vector<Vector3>           nodes;
    std::vector<Element>           elements;
    std::map<std::string, Set>     node_sets, element_sets; ///< by abaqus_key() of the name
    std::map<std::string, Surface> surfaces;
    /** What element types say that is not read, for the log. */
    std::vector<std::string> warnings;

    struct Instance
    {
      std::string       name;
      const AbaqusPart *part;
      unsigned int      first_node, first_element;
    };
    std::map<std::string, Instance> instances; ///< by abaqus_key() of the name

  private:
    using Index = std::unordered_map<unsigned long, unsigned int>;

    /** Numbers and sets in which words of data lines are looked up. */
    struct Scope
    {
      const AbaqusPart *part;
      unsigned int      first_node, first_element;
    };

    void read_nodes(const AbaqusKeyword &keyword);
    void read_system();
    void read_elements(const AbaqusKeyword &keyword);
    void read_set(const AbaqusKeyword &keyword, bool of_nodes);
    void read_surface(const AbaqusKeyword &keyword);
    void generate_nodes(const AbaqusKeyword &keyword);
    void generate_elements(const AbaqusKeyword &keyword);
    void copy_elements(const AbaqusKeyword &keyword);

    ElementKind  kind_of(const std::string &type, unsigned int line);
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
    RigidMotion                                     system_;      ///< of coordinates
  };
} // namespace vfife

#endif
