// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "file_mesh.h"

#include <array>
#include <fstream>
#include <map>

namespace vfife
{
  namespace
  {
    using Coordinates = std::array<double, 3>;

    /** Reads the parts of a Gmsh file that concern points; sections that it does not know are
     * passed over. deal.II has read the file before: it is well-formed. */
    class PointReader
    {
    public:
      explicit PointReader(const std::string &path)
        : in_(path)
      {
        std::string section;
        while (in_ >> section)
          if (section == "$MeshFormat")
            in_ >> version_;
          else if (section == "$Entities")
            read_entities();
          else if (section == "$Nodes")
            version_ < 4. ? read_nodes_2() : read_nodes_4();
          else if (section == "$Elements")
            version_ < 4. ? read_elements_2() : read_elements_4();
      }

      std::map<unsigned int, std::vector<Coordinates>> take_groups()
      {
        return std::move(groups_);
      }

    private:
      static constexpr int point_type = 15;

      /** Format 4: points of the geometry with their physical groups. */
      void read_entities()
      {
        // Curves, surfaces and volumes, which follow, are of no interest here: the search for the
        // next section passes over them.
        std::size_t points, others;
        in_ >> points >> others >> others >> others;
        for (std::size_t i = 0; i < points; ++i)
          {
            int         tag, n_groups;
            Coordinates x;
            in_ >> tag >> x[0] >> x[1] >> x[2] >> n_groups;
            for (int g = 0; g < n_groups; ++g)
              {
                int group;
                in_ >> group;
                groups_of_entity_[tag].push_back(group);
              }
          }
      }

      /** Number and coordinates a line. */
      void read_nodes_2()
      {
        std::size_t n, id;
        in_ >> n;
        for (std::size_t i = 0; i < n; ++i)
          {
            in_ >> id;
            Coordinates &x = nodes_[id];
            in_ >> x[0] >> x[1] >> x[2];
          }
      }

      /** Blocks of one entity each: numbers first, then coordinates. */
      void read_nodes_4()
      {
        std::size_t blocks, n, unused;
        in_ >> blocks >> n >> unused >> unused;
        for (std::size_t b = 0; b < blocks; ++b)
          {
            int dimension, tag, parametric;
            in_ >> dimension >> tag >> parametric >> n;
            std::vector<std::size_t> ids(n);
            for (std::size_t &id : ids)
              in_ >> id;
            for (const std::size_t id : ids)
              {
                Coordinates &x = nodes_[id];
                in_ >> x[0] >> x[1] >> x[2];
                double parameter;
                for (int p = 0; parametric != 0 && p < dimension; ++p)
                  in_ >> parameter;
              }
          }
      }

      /** Number, type, tags (the first is the physical group), nodes. */
      void read_elements_2()
      {
        std::size_t n, id, node;
        in_ >> n;
        std::string rest;
        for (std::size_t i = 0; i < n; ++i)
          {
            int type, n_tags, group = 0, tag;
            in_ >> id >> type >> n_tags;
            for (int t = 0; t < n_tags; ++t)
              in_ >> (t == 0 ? group : tag);
            if (type == point_type)
              {
                in_ >> node;
                groups_[group].push_back(nodes_.at(node));
              }
            else
              std::getline(in_, rest);
          }
      }

      /** Blocks of one entity and one type each. */
      void read_elements_4()
      {
        std::size_t blocks, n, id, node;
        in_ >> blocks >> n >> id >> id;
        std::string rest;
        for (std::size_t b = 0; b < blocks; ++b)
          {
            int dimension, tag, type;
            in_ >> dimension >> tag >> type >> n;
            std::getline(in_, rest);
            for (std::size_t i = 0; i < n; ++i)
              {
                if (type == point_type)
                  {
                    in_ >> id >> node;
                    for (const int group : groups_of_entity_[tag])
                      groups_[group].push_back(nodes_.at(node));
                  }
                std::getline(in_, rest);
              }
          }
      }

      std::ifstream                                    in_;
      double                                           version_ = 0;
      std::map<int, std::vector<int>>                  groups_of_entity_;
      std::map<std::size_t, Coordinates>               nodes_;
      std::map<unsigned int, std::vector<Coordinates>> groups_;
    };
  } // namespace

  void add_gmsh_points(const std::string                         &path,
                       const std::map<unsigned int, std::string> &names,
                       FileMesh                                  &mesh)
  {
    // deal.II numbers vertices anew, but keeps their coordinates bit by bit
    std::map<Coordinates, unsigned int> index;
    for (unsigned int i = 0; i < mesh.nodes.size(); ++i)
      index[{{mesh.nodes[i][0], mesh.nodes[i][1], mesh.nodes[i][2]}}] = i;
    for (const auto &group : PointReader(path).take_groups())
      {
        const auto name = names.find(group.first);
        if (name == names.end())
          continue; // Gmsh writes the number of the geometry's point where there is no group
        FileMesh::Group set{name->second, {}};
        for (const Coordinates &x : group.second)
          {
            const auto found = index.find(x);
            if (found != index.end()) // not those that belong to no hexahedron
              set.members.push_back(found->second);
          }
        mesh.node_sets.push_back(set);
      }
  }
} // namespace vfife
