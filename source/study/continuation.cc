// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/declared_section.h>
#include <vfife/base/parameters/former_names.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/output/files/checkpoint.h>
#include <vfife/output/folder/input_files.h>
#include <vfife/study/continuation.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace vfife
{
  namespace
  {
    /** An entry as the run was begun with it, and as it is now. */
    struct BothTexts
    {
      std::optional<std::string> before, now; ///< none: there is no such entry
      bool                       was_set = true;
      std::string                default_now;
      std::optional<std::string> digest_before; ///< of the file that it names
    };

    std::map<std::string, BothTexts> put_together(const Checkpoint      &checkpoint,
                                                  const DeclaredSection &now)
    {
      const std::set<std::string>        set(checkpoint.set_parameters.begin(),
                                      checkpoint.set_parameters.end());
      std::map<std::string, BothTexts>   entries;
      std::vector<ParameterStatement>    statements;
      std::map<std::string, BothTexts *> by_former_path;
      for (const auto &[path, text] : checkpoint.parameters)
        statements.push_back(read_override(path + "=" + text));
      replace_former_names(statements);
      for (std::size_t i = 0; i < statements.size(); ++i)
        {
          const std::string &former = checkpoint.parameters[i].first;
          BothTexts         &entry  = entries[statements[i].path()];
          entry.before              = statements[i].value;
          entry.was_set             = set.count(former) > 0;
          by_former_path[former]    = &entry;
        }
      for (const auto &[path, digest] : checkpoint.input_digests)
        if (const auto entry = by_former_path.find(path); entry != by_former_path.end())
          entry->second->digest_before = digest;
      for (const auto &[path, pattern] : now.list_texts(&DeclaredSection::Entry::pattern))
        if (std::optional<std::string> &before = entries[path].before)
          before = text_in_force(pattern, *before);
      for (const auto &[path, text] : now.list_texts(&DeclaredSection::Entry::value))
        entries[path].now = text;
      for (const auto &[path, text] : now.list_texts(&DeclaredSection::Entry::default_value))
        entries[path].default_now = text;
      return entries;
    }

    /** What is wrong with an entry for a run that goes on; empty: nothing. */
    std::string find_change(const BothTexts &entry, const std::vector<std::string> &changeable)
    {
      const auto quoted = [](const std::string &text) { return "\"" + text + "\""; };
      if (!entry.before)
        return *entry.now == entry.default_now
                 ? ""
                 : "is " + quoted(*entry.now) +
                     ", but the run started without this entry and continues only with " +
                     quoted(entry.default_now);
      if (!entry.now)
        return !entry.was_set ? ""
                              : "the run started with " + quoted(*entry.before) +
                                  ", but this version does not have the entry";
      if (entry.digest_before)
        {
          const std::string other =
            find_other_content(*entry.before, *entry.digest_before, *entry.now);
          return other.empty() ? "" : other + ". Restore that content, or start without --restart";
        }
      return *entry.before == *entry.now
               ? ""
               : "is " + quoted(*entry.now) + ", but the run started with " +
                   quoted(*entry.before) + "; a continued run may change only " +
                   list_of(changeable, true);
    }

    void refuse_changes(const DeclaredSection          &now,
                        const std::vector<std::string> &changeable,
                        Checkpoint                     &checkpoint)
    {
      // All are named at once, as a user would mend them at once.
      std::vector<InputError>  errors;
      std::vector<std::string> younger, gone;
      for (const auto &[path, entry] : put_together(checkpoint, now))
        {
          if (std::find(changeable.begin(), changeable.end(), path) != changeable.end())
            continue;
          const std::string change = find_change(entry, changeable);
          if (!change.empty())
            errors.emplace_back(path, change);
          else if (!entry.before)
            younger.push_back(path);
          else if (!entry.now)
            gone.push_back(path);
        }
      if (errors.size() == 1)
        throw InputError(errors.front());
      if (!errors.empty())
        throw InputErrors(errors);
      if (!younger.empty())
        checkpoint.remarks.push_back(
          "entries that the version of the start did not have, at the default: " +
          list_of(younger));
      if (!gone.empty())
        checkpoint.remarks.push_back(
          "entries at the default at the start that this version does not have: " + list_of(gone));
    }
  } // namespace

  std::string find_other_content(const std::string &name_before,
                                 const std::string &digest_before,
                                 const std::string &name_now)
  {
    namespace fs             = std::filesystem;
    const std::string digest = digest_of_file(name_now);
    // The ending of the name says how the content is read.
    if (digest == digest_before &&
        fs::path(name_before).extension() == fs::path(name_now).extension())
      return "";
    return "expected the content of \"" + name_before + "\" with which the results were started (" +
           digest_before + "), got " +
           (digest.empty() ? "\"" + name_now + "\", which cannot be read"
                           : "the content of \"" + name_now + "\" (" + digest + ")");
  }

  std::vector<std::string> list_changeable(const bool longer)
  {
    std::vector<std::string> entries = {"Study/output folder",
                                        "Dynamics/end time",
                                        "Dynamics/maximum number of steps",
                                        "Dynamics/energy limit",
                                        "Output/field output interval",
                                        "Output/checkpoint interval",
                                        "Output/report",
                                        "Output/verbosity"};
    if (longer)
      entries.insert(entries.begin() + 1,
                     {"Operation/mesh cycles",
                      "Operation/maximum mesh cycles",
                      "Operation/end time"});
    return entries;
  }

  Checkpoint find_checkpoint(const std::string              &folder,
                             const DeclaredSection          &now,
                             const std::vector<std::string> &changeable,
                             const Communicator             &communicator,
                             Log                            &log)
  {
    // The entries that the checkpoint holds are those the run was begun with, whatever file stands
    // in the folder now.
    Checkpoint checkpoint = read_checkpoint(folder, communicator, log);
    refuse_changes(now, changeable, checkpoint);
    return checkpoint;
  }
} // namespace vfife
