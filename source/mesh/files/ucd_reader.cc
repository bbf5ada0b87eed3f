// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/shown_text.h>

#include "grid_collector.h"

// AVS' unstructured cell data (UCD).
namespace vfife
{
  namespace
  {
    /** Corners of a hexahedron in the order of UCD, which begins with the side y = 0. */
    constexpr unsigned int corner_of_ucd[8] = {0, 1, 5, 4, 2, 3, 7, 6};

    class UcdReader
    {
    public:
      explicit UcdReader(const std::string &path)
        : text_(path, '#')
        , collector_(path, text_)
      {
      }

      /** Numbers of nodes, cells and data; nodes; cells; data, which are passed over. */
      FileMesh read()
      {
        const long n_nodes = text_.integer("the number of nodes", 1);
        const long n_cells = text_.integer("the number of cells", 1);
        long       n_data  = 0;
        for (unsigned int i = 0; i < 3; ++i)
          n_data += text_.integer("a number of data");
        for (long i = 0; i < n_nodes; ++i)
          {
            const long number = text_.integer("the number of a node");
            if (!index_.emplace(number, collector_.n_nodes()).second)
              text_.refuse("duplicate node " + std::to_string(number));
            collector_.add_node(text_.point());
          }
        for (long i = 0; i < n_cells; ++i)
          read_cell();
        check_end(n_data);
        return collector_.finish();
      }

    private:
      /** Number, id, kind, nodes. */
      void read_cell()
      {
        static const std::map<std::string, unsigned int> kinds = {{"pt", 1},
                                                                  {"line", 2},
                                                                  {"quad", 4},
                                                                  {"hex", 8}};
        text_.integer("the number of a cell");
        const long        id   = text_.integer("the id of a cell", -1);
        const std::string word = text_.next();
        const auto        kind = kinds.find(word);
        if (kind == kinds.end())
          text_.refuse("expected hex or quad, got \"" + shown(word) +
                       "\"; other cells are not read");
        const unsigned int        line = text_.line();
        std::vector<unsigned int> nodes;
        for (unsigned int k = 0; k < kind->second; ++k)
          {
            const long number = text_.integer("the number of a node");
            const auto found  = index_.find(number);
            if (found == index_.end())
              text_.refuse("node " + std::to_string(number) + " does not exist");
            nodes.push_back(found->second);
          }
        if (word == "hex")
          collector_.add_hexahedron(nodes, corner_of_ucd, id, line);
        else if (word == "quad")
          collector_.add_face(nodes, id, line);
      }

      /** Behind the cells stand data or nothing: a cell there would be one too much. */
      void check_end(const long n_data)
      {
        std::string words[3];
        for (std::string &word : words)
          word = text_.next();
        if (!words[0].empty() && (n_data == 0 || words[2] == "hex" || words[2] == "quad"))
          text_.refuse("the file has more cells than its first line states");
        if (n_data > 0)
          collector_.add_note("data of nodes and cells are left out");
      }

      MeshText                     text_;
      GridCollector                collector_;
      std::map<long, unsigned int> index_;
    };
  } // namespace

  FileMesh read_ucd(const std::string &path)
  {
    return UcdReader(path).read();
  }
} // namespace vfife
