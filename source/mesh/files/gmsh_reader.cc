// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/shown_text.h>
#include <vfife/mesh/hexahedron_corners.h>

#include "file_mesh.h"
#include "mesh_text.h"

#include <algorithm>
#include <unordered_map>

// Formats 2.2 and 4.1 of Gmsh (reference manual, "MSH file format"): sections $NAME ... $EndNAME.
namespace vfife
{
  namespace
  {
    /** A type of elements; those of higher order are not known here. */
    struct ElementType
    {
      long         number;
      unsigned int dimension, n_nodes;
    };

    constexpr ElementType element_types[] = {
      {1, 1, 2}, {2, 2, 3}, {3, 2, 4}, {4, 3, 4}, {5, 3, 8}, {6, 3, 6}, {7, 3, 5}, {15, 0, 1}};
    constexpr long hexahedron = 5, triangle = 2;

    class GmshReader
    {
    public:
      explicit GmshReader(const std::string &path)
        : path_(path)
        , text_(path)
      {
      }

      FileMesh read()
      {
        for (std::string section = text_.next(); !section.empty(); section = text_.next())
          read_section(section);
        if (mesh_.elements.empty())
          text_.refuse("expected hexahedra (elements of type 5), got none");
        mesh_.finish(path_, node_sets_, surfaces_, regions_);
        return std::move(mesh_);
      }

    private:
      using Groups = std::vector<long>;

      void read_section(const std::string &section)
      {
        if (section[0] != '$')
          text_.refuse("cannot be read as a Gmsh file: expected a section such as $Nodes, got \"" +
                       shown(section) + "\"");
        if (section == "$MeshFormat")
          read_format();
        else if (version_ == 0.)
          text_.refuse("cannot be read as a Gmsh file: $MeshFormat must come first");
        else if (section == "$PhysicalNames")
          read_names();
        else if (section == "$Entities" && version_ > 4.)
          read_entities();
        else if (section == "$Nodes")
          version_ < 4. ? read_nodes_2() : read_nodes_4();
        else if (section == "$Elements")
          version_ < 4. ? read_elements_2() : read_elements_4();
        else
          {
            pass_over(section);
            return;
          }
        text_.expect("$End" + section.substr(1));
      }

      /** Sections that change nothing of the mesh; others, such as parts of a mesh that has been
       * divided for several processes, are refused. */
      void pass_over(const std::string &section)
      {
        static const std::vector<std::string> harmless = {"$Comments",
                                                          "$Entities",
                                                          "$Periodic",
                                                          "$NodeData",
                                                          "$ElementData",
                                                          "$ElementNodeData",
                                                          "$InterpolationScheme",
                                                          "$Parametrizations",
                                                          "$PostFormat",
                                                          "$View"};
        if (std::find(harmless.begin(), harmless.end(), section) == harmless.end())
          text_.refuse(
            "the section " + shown(section) + " is not read" +
            did_you_mean(section,
                         {"$MeshFormat", "$PhysicalNames", "$Nodes", "$Elements", "$Entities"}));
        const std::string end = "$End" + section.substr(1);
        for (std::string word = text_.next(); word != end; word = text_.next())
          if (word.empty())
            text_.refuse("section " + shown(section) + " does not end with " + shown(end));
      }

      void read_format()
      {
        version_ = text_.number("the format's version");
        if (!(version_ >= 2. && version_ < 3.) && version_ != 4.1)
          text_.refuse("only the formats 2.2 and 4.1 are read (gmsh -format msh41)");
        if (text_.integer("0 for text") != 0)
          text_.refuse("the file is binary; text is needed (gmsh without -bin)");
        text_.integer("the size of a number");
      }

      /** Dimension, number and name in quotes. */
      void read_names()
      {
        const long n = text_.integer("the number of names");
        for (long i = 0; i < n; ++i)
          {
            const long        dimension = text_.integer("a dimension");
            const long        number    = text_.integer("the number of a physical group");
            const std::string line      = text_.rest_of_line();
            if (line.size() < 2 || line.front() != '"' || line.back() != '"')
              text_.refuse("the name of a physical group must be in quotes");
            names_[{dimension, number}] = line.substr(1, line.size() - 2);
          }
      }

      /** Format 4.1: points, curves, surfaces and volumes of the geometry with their physical
       * groups: tag, place or box, groups, and what bounds them. */
      void read_entities()
      {
        long n[4];
        for (long &count : n)
          count = text_.integer("a number of entities");
        for (unsigned int dimension = 0; dimension < 4; ++dimension)
          for (long i = 0; i < n[dimension]; ++i)
            {
              const long tag = text_.integer("the tag of an entity", -max_tag);
              for (unsigned int c = 0; c < (dimension == 0 ? 3 : 6); ++c)
                text_.number("a coordinate");
              Groups    &groups   = groups_of_[{dimension, tag}];
              const long n_groups = text_.integer("the number of physical groups");
              for (long g = 0; g < n_groups; ++g)
                groups.push_back(std::labs(text_.integer("a physical group", -max_tag)));
              const long n_bounds = dimension == 0 ? 0 : text_.integer("the number of bounds");
              for (long b = 0; b < n_bounds; ++b)
                text_.integer("the tag of an entity", -max_tag);
            }
      }

      void add_node(const long tag, const Vector3 &x)
      {
        if (!node_index_.emplace(tag, mesh_.nodes.size()).second)
          text_.refuse("duplicate node " + std::to_string(tag));
        mesh_.nodes.push_back(x);
      }

      void read_nodes_2()
      {
        const long n = text_.integer("the number of nodes");
        for (long i = 0; i < n; ++i)
          {
            const long tag = text_.integer("the number of a node");
            add_node(tag, text_.point());
          }
      }

      /** Blocks of one entity each: numbers first, then coordinates. */
      void read_nodes_4()
      {
        const long blocks = text_.integer("the number of blocks");
        const long n      = text_.integer("the number of nodes");
        text_.integer("the least number of a node");
        text_.integer("the largest number of a node");
        for (long b = 0; b < blocks; ++b)
          {
            const long dimension  = text_.integer("a dimension");
            const long tag        = text_.integer("the tag of an entity", -max_tag);
            const long parametric = text_.integer("0 or 1 for parametric nodes");
            const long n_here     = text_.integer("the number of nodes");
            if (dimension > 3 || tag > max_tag || parametric > 1)
              text_.refuse("a block of nodes begins with dimension (0 to 3), tag, 0 or 1, and the "
                           "number of its nodes");
            std::vector<long> tags;
            for (long i = 0; i < n_here; ++i)
              tags.push_back(text_.integer("the number of a node"));
            for (const long of_node : tags)
              {
                add_node(of_node, text_.point());
                for (long p = 0; parametric != 0 && p < dimension; ++p)
                  text_.number("a parameter");
              }
          }
        compare("nodes", n, mesh_.nodes.size());
      }

      /** Number, type, tags (the first is the physical group), nodes. */
      void read_elements_2()
      {
        const long n = text_.integer("the number of elements");
        for (long i = 0; i < n; ++i)
          {
            text_.integer("the number of an element");
            const ElementType type   = read_type();
            const long        n_tags = text_.integer("the number of tags");
            Groups            groups;
            for (long t = 0; t < n_tags; ++t)
              {
                const long tag = text_.integer("a tag", -max_tag);
                if (t == 0)
                  groups.push_back(std::labs(tag));
              }
            read_element(type, groups);
          }
      }

      /** Blocks of one entity and one type each. */
      void read_elements_4()
      {
        const long blocks = text_.integer("the number of blocks");
        const long n      = text_.integer("the number of elements");
        text_.integer("the least number of an element");
        text_.integer("the largest number of an element");
        long n_read = 0;
        for (long b = 0; b < blocks; ++b)
          {
            const long        dimension = text_.integer("a dimension");
            const long        tag       = text_.integer("the tag of an entity", -max_tag);
            const ElementType type      = read_type();
            if (dimension != static_cast<long>(type.dimension))
              text_.refuse("elements of type " + std::to_string(type.number) + " have dimension " +
                           std::to_string(type.dimension) + ", not " + std::to_string(dimension));
            const Groups groups = groups_of_[{dimension, tag}];
            const long   n_here = text_.integer("the number of elements");
            for (long i = 0; i < n_here; ++i, ++n_read)
              {
                text_.integer("the number of an element");
                read_element(type, groups);
              }
          }
        compare("elements", n, n_read);
      }

      ElementType read_type()
      {
        const long number = text_.integer("the type of an element");
        for (const ElementType &type : element_types)
          if (type.number == number)
            {
              if (type.dimension == 3 && number != hexahedron)
                break;
              if (number == triangle)
                text_.refuse("a triangle (type 2) is not a face of a hexahedron");
              return type;
            }
        text_.refuse("elements of type " + std::to_string(number) +
                     " are not read: only 8-node hexahedra (type 5) and 4-node quadrilaterals (3), "
                     "lines (1) and points (15) of groups");
      }

      void read_element(const ElementType &type, const Groups &groups)
      {
        std::vector<unsigned int> nodes;
        for (unsigned int v = 0; v < type.n_nodes; ++v)
          {
            const long tag   = text_.integer("the number of a node");
            const auto found = node_index_.find(tag);
            if (found == node_index_.end())
              text_.refuse("node " + std::to_string(tag) + " does not exist");
            nodes.push_back(found->second);
          }
        if (type.dimension == 3)
          {
            if (version_ < 4. && add_to_other_group(nodes, groups))
              return;
            add_hexahedron(nodes, groups);
          }
        for (const long group : groups)
          {
            const auto name = names_.find({type.dimension, group});
            // Gmsh writes the number of the geometry's point where there is no group.
            if (type.dimension < 2 && name != names_.end())
              add(node_sets_[name->second], nodes);
            if (type.dimension == 2 && group != 0)
              surfaces_[name != names_.end() ? name->second : "boundary " + std::to_string(group)]
                .push_back({{{nodes[0], nodes[1], nodes[2], nodes[3]}}, text_.line()});
          }
      }

      /** Format 2.2 has an element once for each of its groups: whether this one is known, and in
       * which group it is too. One that is twice in a group is left to be found wrong. */
      bool add_to_other_group(const std::vector<unsigned int> &nodes, const Groups &groups)
      {
        const auto [known, is_new] = elements_of_2_.emplace(nodes, mesh_.elements.size());
        if (is_new || groups.size() != 1)
          return false;
        const auto        found = names_.find({3, groups[0]});
        const std::string name =
          found != names_.end() ? found->second : "region " + std::to_string(groups[0]);
        std::vector<unsigned int> &members = regions_[name];
        // Elements of a group stand in the order of the file: a binary search finds them.
        if (std::binary_search(members.begin(), members.end(), known->second))
          return false;
        mesh_.region_numbers[groups[0]] = name;
        members.insert(std::upper_bound(members.begin(), members.end(), known->second),
                       known->second);
        return true;
      }

      void add_hexahedron(const std::vector<unsigned int> &nodes, Groups groups)
      {
        CellNodes corners;
        for (unsigned int k = 0; k < 8; ++k)
          corners[corner_of_files[k]] = nodes[k];
        if (groups.empty())
          groups.push_back(0);
        for (const long group : groups)
          {
            const auto        found = names_.find({3, group});
            const std::string name =
              found != names_.end() ? found->second : "region " + std::to_string(group);
            mesh_.region_numbers[group] = name;
            regions_[name].push_back(mesh_.elements.size());
          }
        mesh_.elements.push_back(corners);
        mesh_.element_lines.push_back(text_.line());
      }

      static void add(std::vector<unsigned int> &members, const std::vector<unsigned int> &nodes)
      {
        members.insert(members.end(), nodes.begin(), nodes.end());
      }

      void compare(const std::string &what, const long stated, const long found) const
      {
        if (stated != found)
          text_.refuse("the section has " + std::to_string(found) + " " + what +
                       ", but its first line states " + std::to_string(stated));
      }

      static constexpr long max_tag = 2147483647;

      const std::string                           &path_;
      MeshText                                     text_;
      double                                       version_ = 0;
      FileMesh                                     mesh_;
      std::unordered_map<long, unsigned int>       node_index_;
      std::map<std::pair<long, long>, std::string> names_;     ///< dimension, group
      std::map<std::pair<long, long>, Groups>      groups_of_; ///< dimension, tag
      FileMesh::Members                            node_sets_, regions_;
      FileMesh::Surfaces                           surfaces_;
      /** By nodes, of format 2.2. */
      std::map<std::vector<unsigned int>, unsigned int> elements_of_2_;
    };
  } // namespace

  FileMesh read_gmsh(const std::string &path)
  {
    return GmshReader(path).read();
  }
} // namespace vfife
