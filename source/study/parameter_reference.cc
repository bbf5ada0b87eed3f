// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/study/case_runner.h>
#include <vfife/study/parameter_reference.h>
#include <vfife/study/study.h>
#include <vfife/study/study_kinds.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <ostream>
#include <sstream>

namespace vfife
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    /** A row of the page. */
    struct Entry
    {
      std::string              name, standard, meaning;
      std::vector<std::string> words; ///< of the choice of its section with which it exists
      std::map<std::string, std::vector<std::string>> others; ///< other defaults, kinds with them

      bool operator==(const Entry &other) const
      {
        return name == other.name && meaning == other.meaning;
      }
    };

    /** Sections of the same path and entries appear once, with all that read them. */
    struct Section
    {
      std::string              path;
      std::vector<Entry>       entries;
      std::vector<std::string> kinds;
    };

    /** The entries of a section itself: in deal.II's JSON what has a default is an entry, the
     * rest are subsections. */
    std::vector<Entry> entries_of(const Json &section)
    {
      std::vector<Entry> entries;
      for (const auto &[name, value] : section.items())
        if (value.contains("default_value"))
          entries.push_back({name,
                             value.at("default_value").get<std::string>(),
                             value.at("documentation").get<std::string>(),
                             {},
                             {}});
      return entries;
    }

    /** A bare bar would end the cell of a table in Markdown. */
    std::string escape_bars(std::string text)
    {
      for (std::size_t i = text.find('|'); i != std::string::npos; i = text.find('|', i + 2))
        text.insert(i, "\\");
      return text;
    }

    /** Adds a section of one kind, or that kind to the same section of others; defaults that
     * differ between kinds are kept with the kinds that have them. */
    void add(const Section &section, std::vector<Section> &sections)
    {
      const auto same = std::find_if(sections.begin(), sections.end(), [&](const Section &known) {
        return known.path == section.path && known.entries == section.entries;
      });
      if (same == sections.end())
        sections.push_back(section);
      else if (same->kinds.back() != section.kinds.front())
        {
          same->kinds.push_back(section.kinds.front());
          for (std::size_t i = 0; i < same->entries.size(); ++i)
            if (same->entries[i].standard != section.entries[i].standard &&
                section.entries[i].standard != section.kinds.front()) // Study/kind itself
              same->entries[i].others[section.entries[i].standard].push_back(section.kinds.front());
        }
    }

    /** Adds a section and all below it. */
    void collect(const Json           &node,
                 const std::string    &path,
                 const std::string    &kind,
                 std::vector<Section> &sections)
    {
      const Section section{path, entries_of(node), {kind}};
      if (!section.entries.empty())
        add(section, sections);
      for (const auto &[name, value] : node.items())
        if (!value.contains("default_value"))
          collect(value, path + (path.empty() ? "" : "/") + name, kind, sections);
    }

    /** All that a study declares when these statements stand in its file. */
    Json declare(const std::vector<std::string> &statements)
    {
      // The two passes of every study (study.cc), on a file that says nothing but the statements.
      const ParameterFile      file("/dev/null", statements);
      dealii::ParameterHandler prm;
      StudyOptions             options;
      file.read_known([&](dealii::ParameterHandler &first) { options.declare(first); });
      const auto runner = make_case_runner();
      const auto study  = options.kind.make(*runner);
      options.declare(prm);
      study->declare(prm, file);
      std::ostringstream text;
      prm.print_parameters(text,
                           dealii::ParameterHandler::JSON |
                             dealii::ParameterHandler::KeepDeclarationOrder);
      return Json::parse(text.str());
    }

    /** The words of an entry that is a choice: those in quotes in what is allowed. */
    std::vector<std::string> words_of(const Json &entry)
    {
      //   one of "word", "another word"
      std::istringstream       text(entry.at("pattern_description").get<std::string>());
      std::vector<std::string> words;
      for (std::string before, word;
           std::getline(text, before, '"') && std::getline(text, word, '"');)
        words.push_back(word);
      return words;
    }

    /** Lists of names that open a section each, beside those of a model. */
    struct NamedSections
    {
      const char *kind, *section, *list;
    };
    const NamedSections named_sections[] = {{"compare", "Compare", "cases"},
                                            {"lumped", "Lumped", "supports"},
                                            {"sweep", "Sweep", "parameters"},
                                            {"sweep", "Sweep", "figures"},
                                            {"loaded tooth contact analysis", "Fillets", "gauges"},
                                            {"run", "Fillets", "gauges"},
                                            {"reduced", "Fillets", "gauges"}};

    /** All that a kind declares, as of a gear pair, each list of names holding one NAME. */
    Json declare_kind(const std::string &kind)
    {
      // An entry of a pair makes those kinds declare it that can do without.
      std::vector<std::string> statements = {"Study/kind=" + kind, "Gear pair/Mounting/backlash=0"};
      for (const NamedSections &named : named_sections)
        if (kind == named.kind)
          statements.push_back(std::string(named.section) + "/" + named.list + "=NAME");
      Json declared = declare(statements);
      for (const NamedSections &named : named_sections)
        if (kind == named.kind)
          declared.at(named.section).at(named.list).at("default_value") = ""; // not that name
      return declared;
    }

    /** Parts of a model or of a shaft, in the section of their list of names, and the entries that
     * decide what else they declare. */
    struct Part
    {
      const char *parent, *list, *section, *choice;

      std::string path() const
      {
        return std::string(parent) + "/" + section + " NAME";
      }
      /** A statement that gives the list one NAME. */
      std::string named() const
      {
        return std::string(parent) + "/" + list + "=NAME";
      }
      Json &find(Json &declared) const
      {
        return declared.at(Json::json_pointer("/" + path()));
      }
    };
    const Part parts[]       = {{"Model", "bodies", "Body", "mesh"},
                                {"Model", "constraints", "Constraint", "kind"},
                                {"Model", "loads", "Load", "kind"},
                                {"Model", "contacts", "Contact", "kind"},
                                {"Model", "probes", "Probe", nullptr}};
    const Part shaft_parts[] = {{"Gear pair/Gear/Shaft", "bearings", "Bearing", "kind"},
                                {"Gear pair/Pinion/Shaft", "bearings", "Bearing", "kind"}};

    const char model_kinds[] = "run and static of a model",
               pair_kinds[]  = "all kinds of a gear pair with bodies";

    /** A part whose choice decides what else it declares: the entries of all words. */
    Section collect_part(const Part &part, const char *kinds)
    {
      Json       declared = declare({"Study/kind=run", part.named()});
      const auto words    = words_of(part.find(declared).at(part.choice));
      // Declared once with each word: an entry that appears with all words needs no remark, another
      // one says with which.
      Section section{part.path(), {}, {kinds}};
      for (const std::string &word : words)
        {
          Json of_word =
            declare({"Study/kind=run", part.named(), part.path() + "/" + part.choice + "=" + word});
          for (const Entry &entry : entries_of(part.find(of_word)))
            {
              auto known = std::find(section.entries.begin(), section.entries.end(), entry);
              if (known == section.entries.end())
                known = section.entries.insert(known, entry);
              known->words.push_back(word);
            }
        }
      for (Entry &entry : section.entries)
        if (entry.words.size() == words.size())
          entry.words.clear();
        else
          entry.words.front() = std::string(part.choice) + " " + entry.words.front();
      return section;
    }

    /** The sections of a general model with one NAME of each part. Parts with a choice are
     * collected word by word and taken out of the rest. */
    void collect_model(std::vector<Section> &sections)
    {
      std::vector<std::string> all = {"Study/kind=run"};
      for (const Part &part : parts)
        all.push_back(part.named());
      Json declared = declare(all);
      for (const Part &part : parts)
        declared.at(part.parent).at(part.list).at("default_value") = ""; // not the name set above
      for (const Part &part : parts)
        if (part.choice != nullptr)
          {
            sections.push_back(collect_part(part, model_kinds));
            declared.at(part.parent).erase(std::string(part.section) + " NAME");
          }
      collect(declared, "", model_kinds, sections);
    }

    /** Whether two sections have the same rows and readers. */
    bool is_alike(const Section &a, const Section &b)
    {
      return a.kinds == b.kinds && std::equal(a.entries.begin(),
                                              a.entries.end(),
                                              b.entries.begin(),
                                              b.entries.end(),
                                              [](const Entry &x, const Entry &y) {
                                                return x == y && x.standard == y.standard &&
                                                       x.words == y.words && x.others == y.others;
                                              });
    }

    /** Equal sections, as of both members or both flanks, become one section with all paths. */
    void merge_alike(std::vector<Section> &sections)
    {
      for (auto section = sections.begin(); section != sections.end(); ++section)
        for (auto other = section + 1; other != sections.end();)
          if (is_alike(*section, *other))
            {
              section->path += ", " + other->path;
              other = sections.erase(other);
            }
          else
            ++other;
    }

    /** A list between @p before and @p after; nothing where it is empty. */
    void write_list(std::ostream                   &out,
                    const std::string              &before,
                    const std::vector<std::string> &list,
                    const std::string              &after)
    {
      for (std::size_t i = 0; i < list.size(); ++i)
        out << (i == 0 ? before : ", ") << list[i];
      if (!list.empty())
        out << after;
    }
  } // namespace

  void write_parameter_reference(std::ostream &out)
  {
    std::vector<Section> sections;
    // All kinds as of a gear pair, then the general model, whose parts have names.
    for (const auto &kind : study_kinds())
      collect(declare_kind(kind.first), "", kind.first, sections);
    collect_model(sections);
    for (const Part &part : shaft_parts)
      sections.push_back(collect_part(part, pair_kinds));
    std::stable_sort(sections.begin(), sections.end(), [](const Section &a, const Section &b) {
      return a.path < b.path;
    });
    merge_alike(sections);
    out << "# Parameters\n\nAll sections of parameter files, by `vfife --parameter-reference`. How "
           "files are written: [parameter file](reference/parameter-file.md).\n";
    for (const Section &section : sections)
      {
        out << "\n## " << section.path << "\n\n";
        write_list(out, "Read by ", section.kinds, ".\n\n");
        out << "| entry | default | meaning |\n|---|---|---|\n";
        for (const Entry &entry : section.entries)
          {
            out << "| " << entry.name << " | " << escape_bars(entry.standard);
            for (const auto &[standard, kinds] : entry.others)
              write_list(out, "; " + escape_bars(standard) + " for ", kinds, "");
            out << " | " << escape_bars(entry.meaning);
            write_list(out, " - with ", entry.words, "");
            out << " |\n";
          }
      }
  }
} // namespace vfife
