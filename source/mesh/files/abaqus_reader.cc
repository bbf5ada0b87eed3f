// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/shown_text.h>
#include <vfife/mesh/hexahedron_corners.h>

#include "file_mesh.h"

#include <cctype>
#include <fstream>
#include <map>
#include <sstream>
#include <unordered_map>

namespace vfife
{
  namespace
  {
    std::string upper(std::string text)
    {
      std::transform(text.begin(), text.end(), text.begin(), [](const unsigned char c) {
        return static_cast<char>(std::toupper(c));
      });
      return text;
    }

    /** The words between commas, without blanks around them. */
    std::vector<std::string> split(const std::string &line)
    {
      std::vector<std::string> words;
      std::istringstream       in(line);
      std::string              word;
      while (std::getline(in, word, ','))
        words.push_back(trimmed(word));
      while (!words.empty() && words.back().empty())
        words.pop_back();
      return words;
    }

    /** Reads the keywords of the mesh; all others are skipped with their data. */
    class AbaqusReader
    {
    public:
      explicit AbaqusReader(const std::string &path)
        : path_(path)
      {
      }

      FileMesh read()
      {
        std::ifstream in(path_);
        std::string   line;
        // keywords choose what the data lines that follow mean; ** is a comment
        while (std::getline(in, line))
          {
            ++line_;
            if (line.find_first_not_of(" \t\r") == std::string::npos || line.rfind("**", 0) == 0)
              continue;
            if (line[0] == '*')
              read_keyword(split(line));
            else if (data_ != nullptr)
              (this->*data_)(split(line));
          }
        check_element_is_whole();
        if (mesh_.elements.empty())
          refuse("there are no hexahedra (C3D8 elements)");
        mesh_.finish(node_sets_, surfaces_, element_sets_);
        return std::move(mesh_);
      }

    private:
      using Members = FileMesh::Members;

      [[noreturn]] void refuse(const std::string &message) const
      {
        throw InputError(path_ + ":" + std::to_string(line_) + ": " + message);
      }

      unsigned long label(const std::string &word) const
      {
        if (word.empty() || word.find_first_not_of("0123456789") != std::string::npos ||
            word.size() > 18)
          refuse("\"" + shown(word) + "\" is no number of a node or element");
        return std::stoul(word);
      }

      double number(const std::string &word) const
      {
        std::istringstream in(word);
        double             value;
        if (!(in >> value) || !in.eof())
          refuse("\"" + shown(word) + "\" is no number");
        return value;
      }

      unsigned int node(const std::string &word) const
      {
        const auto found = node_index_.find(label(word));
        if (found == node_index_.end())
          refuse("there is no node " + word);
        return found->second;
      }

      /** *KEYWORD, OPTION=VALUE, ...: says which function takes the data lines that follow. */
      void read_keyword(const std::vector<std::string> &words)
      {
        options_.clear();
        for (std::size_t i = 1; i < words.size(); ++i)
          {
            // OPTION or OPTION = VALUE; the option in any case of letters, the value as it is
            // written.
            const auto equals = words[i].find('=');
            const auto key    = upper(trimmed(words[i].substr(0, equals)));
            options_[key] = equals == std::string::npos ? "" : trimmed(words[i].substr(equals + 1));
          }
        check_element_is_whole();
        const std::string keyword = upper(words[0]);
        data_                     = nullptr;
        if (keyword == "*NODE")
          data_ = &AbaqusReader::read_node;
        else if (keyword == "*ELEMENT")
          start_elements();
        else if (keyword == "*NSET" || keyword == "*ELSET")
          {
            set_ = &(keyword == "*NSET" ? node_sets_[options_["NSET"]]
                                        : element_sets_[options_["ELSET"]]);
            data_ =
              keyword == "*NSET" ? &AbaqusReader::read_node_set : &AbaqusReader::read_element_set;
          }
        else if (keyword == "*SURFACE" &&
                 (options_.count("TYPE") == 0 || upper(options_["TYPE"]) == "ELEMENT"))
          data_ = &AbaqusReader::read_surface;
        else if (keyword == "*INCLUDE")
          refuse("*INCLUDE is not followed: put the mesh into one file");
      }

      /** Hexahedra are elements, 4-node shells surfaces; other volume elements are refused, others
       * passed over. */
      void start_elements()
      {
        const std::string type = upper(options_["TYPE"]);
        if (type == "C3D8" || type == "C3D8R" || type == "C3D8I")
          data_ = &AbaqusReader::read_hexahedron;
        else if (type.rfind("C3D", 0) == 0)
          refuse("elements of type " + shown(type) + " are no 8-node hexahedra (C3D8)");
        else if (type.find('4') != std::string::npos && type[0] != 'T' && type[0] != 'B')
          data_ = &AbaqusReader::read_shell;
      }

      void read_node(const std::vector<std::string> &words)
      {
        if (words.size() < 4)
          refuse("a node needs a number and three coordinates");
        if (!node_index_.emplace(label(words[0]), mesh_.nodes.size()).second)
          refuse("there is a second node " + words[0]);
        if (!options_["NSET"].empty())
          node_sets_[options_["NSET"]].push_back(mesh_.nodes.size());
        mesh_.nodes.emplace_back(number(words[1]), number(words[2]), number(words[3]));
      }

      void read_hexahedron(const std::vector<std::string> &words)
      {
        // Its number and eight nodes, which may be divided over lines.
        pending_.insert(pending_.end(), words.begin(), words.end());
        if (pending_.size() < 9)
          return; // goes on in the next line
        if (pending_.size() > 9)
          refuse("an element needs its number and eight nodes, not more");
        CellNodes nodes;
        for (unsigned int k = 0; k < 8; ++k)
          nodes[corner_of_files[k]] = node(pending_[k + 1]);
        if (!element_index_.emplace(label(pending_[0]), mesh_.elements.size()).second)
          refuse("there is a second element " + pending_[0]);
        element_sets_[options_["ELSET"]].push_back(mesh_.elements.size());
        mesh_.elements.push_back(nodes);
        mesh_.element_lines.push_back(line_);
        pending_.clear();
      }

      /** An element may be cut by the next keyword or the end of the file. */
      void check_element_is_whole() const
      {
        if (!pending_.empty())
          refuse("the element before has fewer than eight nodes");
      }

      void read_shell(const std::vector<std::string> &words)
      {
        if (words.size() != 5)
          refuse("a 4-node element needs its number and four nodes");
        for (unsigned int k = 1; k < 5; ++k)
          surfaces_[options_["ELSET"]].push_back(node(words[k]));
      }

      void read_node_set(const std::vector<std::string> &words)
      {
        read_set(words, node_sets_, node_index_);
      }

      void read_element_set(const std::vector<std::string> &words)
      {
        read_set(words, element_sets_, element_index_);
      }

      /** Members of the present set: a range, or numbers and names of sets read before. */
      void read_set(const std::vector<std::string>                        &words,
                    const Members                                         &sets,
                    const std::unordered_map<unsigned long, unsigned int> &index)
      {
        const auto add = [&](const unsigned long member) {
          const auto found = index.find(member);
          if (found != index.end()) // sets may also hold what is no part of the solid
            set_->push_back(found->second);
        };
        if (options_.count("GENERATE") != 0)
          {
            if (words.size() < 2)
              refuse("GENERATE needs first and last number");
            const unsigned long step = words.size() > 2 ? label(words[2]) : 1;
            if (step == 0)
              refuse("the step of GENERATE must not be 0");
            // Not from the first number to the last: they may be far from each other.
            const unsigned long first = label(words[0]), last = label(words[1]);
            for (const auto &[number, place] : index)
              if (number >= first && number <= last && (number - first) % step == 0)
                set_->push_back(place);
            return;
          }
        for (const std::string &word : words)
          {
            const auto other = sets.find(word);
            if (other != sets.end() && &other->second != set_)
              set_->insert(set_->end(), other->second.begin(), other->second.end());
            else if (!word.empty() && std::isdigit(static_cast<unsigned char>(word[0])) != 0)
              add(label(word));
          }
      }

      void read_surface(const std::vector<std::string> &words)
      {
        // corners of the faces S1 ... S6 in lexicographic numbers
        constexpr unsigned int corners[6][4] = {
          {0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 4, 5}, {1, 3, 5, 7}, {2, 3, 6, 7}, {0, 2, 4, 6}};
        if (words.size() < 2 || words[1].size() != 2 || upper(words[1])[0] != 'S' ||
            words[1][1] < '1' || words[1][1] > '6')
          refuse("a line of *SURFACE must be an element or ELSET, and a face S1 to S6");
        // the elements of a set, or one by its number
        std::vector<unsigned int> elements;
        const auto                set = element_sets_.find(words[0]);
        if (set != element_sets_.end())
          elements = set->second;
        else
          {
            const auto found = element_index_.find(label(words[0]));
            if (found == element_index_.end())
              refuse("there is no element " + shown(words[0]));
            elements = {found->second};
          }
        for (const unsigned int element : elements)
          for (const unsigned int corner : corners[words[1][1] - '1'])
            surfaces_[options_["NAME"]].push_back(mesh_.elements[element][corner]);
      }

      const std::string &path_;
      unsigned int       line_ = 0;
      FileMesh           mesh_;
      void (AbaqusReader::*data_)(const std::vector<std::string> &) = nullptr;
      std::map<std::string, std::string>              options_; ///< of the present keyword
      std::vector<std::string>                        pending_; ///< of an element over two lines
      std::vector<unsigned int>                      *set_ = nullptr;
      std::unordered_map<unsigned long, unsigned int> node_index_, element_index_;
      Members                                         node_sets_, element_sets_, surfaces_;
    };
  } // namespace

  FileMesh read_abaqus(const std::string &path)
  {
    return AbaqusReader(path).read();
  }
} // namespace vfife
