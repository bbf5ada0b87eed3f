// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/case_sections.h>
#include <vfife/base/parameters/declared_section.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/study/other_sections.h>
#include <vfife/study/study_kinds.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <sstream>

namespace vfife
{
  namespace
  {
    std::vector<std::string> list_case_sections()
    {
      std::vector<std::string> sections = {model_section};
      sections.insert(sections.end(), pair_sections.begin(), pair_sections.end());
      return sections;
    }

    /** Of which there is one in each case. */
    const std::vector<std::string> case_sections = list_case_sections();

    bool contains(const std::vector<std::string> &names, const std::string &name)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }

    /** Another kind of study with what it declares for the same file. */
    struct OtherKind
    {
      std::unique_ptr<StudyKind>                study;
      std::unique_ptr<dealii::ParameterHandler> prm = std::make_unique<dealii::ParameterHandler>();
      DeclaredSection                           top;
    };

    /** All kinds that take the same case. */
    std::vector<OtherKind>
    find_kinds(const ParameterFile &file, const DeclaredSection &present, const CaseRunner &runner)
    {
      std::vector<OtherKind> kinds;
      for (const auto &kind : study_kinds())
        try
          {
            OtherKind other;
            other.study = kind.second.make(runner);
            other.study->declare(*other.prm, file);
            other.top = find_declared(*other.prm);
            const bool is_of_case =
              std::any_of(case_sections.begin(), case_sections.end(), [&](const auto &name) {
                return present.find_section(name) != nullptr &&
                       other.top.find_section(name) != nullptr;
              });
            if (is_of_case)
              kinds.push_back(std::move(other));
          }
        catch (const InputError &)
          {
            // A kind that has no use for this file, say a sweep that names no file of its cases.
          }
      return kinds;
    }

    /** Refuses a file whose case the kind that has declared @p present does not take, and names
     * those that do. */
    void
    check_case(const ParameterFile &file, const DeclaredSection &present, const CaseRunner &runner)
    {
      const auto is_taken = [&](const std::string &name) {
        return file.contains(name) && present.find_section(name) != nullptr;
      };
      if (std::any_of(case_sections.begin(), case_sections.end(), is_taken))
        return; // a second case beside it is another matter
      for (const std::string &name : case_sections)
        {
          if (!file.contains(name))
            continue;
          std::vector<std::string> takers;
          for (const auto &kind : study_kinds())
            try
              {
                dealii::ParameterHandler prm;
                const auto               study = kind.second.make(runner);
                study->declare(prm, file);
                if (find_declared(prm).find_section(name) != nullptr)
                  takers.push_back(kind.first);
              }
            catch (const InputError &)
              {
                // as in find_kinds()
              }
          if (!takers.empty())
            throw InputError(file.locate(name) + ": this kind of study has no section \"" + name +
                             "\"; kinds with this section (Study/kind): " + list_of(takers));
        }
    }

    /** Whether a section or an entry of this path is declared. */
    bool is_declared(const std::string &path, const DeclaredSection &top)
    {
      const DeclaredSection *section = &top;
      std::istringstream     names(path);
      for (std::string name; std::getline(names, name, '/');)
        {
          const DeclaredSection *const inner = section->find_section(name);
          if (inner == nullptr)
            return names.eof() && section->find_entry(name) != nullptr;
          section = inner;
        }
      return true;
    }

    /** Whether one of the kinds that know what has this path reads all of the section at the top
     * level that it stands in; throws what the first of them says against it. */
    bool
    is_read(const std::string &path, const ParameterFile &file, const std::vector<OtherKind> &kinds)
    {
      std::optional<InputError> complaint;
      for (const OtherKind &kind : kinds)
        if (is_declared(path, kind.top))
          try
            {
              file.read_section(path.substr(0, path.find('/')), *kind.prm);
              return true;
            }
          catch (const InputError &error)
            {
              if (!complaint)
                complaint = error;
            }
      if (complaint)
        throw InputError(*complaint);
      return false;
    }
  } // namespace

  OtherSections find_other_sections(const ParameterFile            &file,
                                    const dealii::ParameterHandler &prm,
                                    const CaseRunner               &runner)
  {
    const DeclaredSection          present    = find_declared(prm);
    const std::vector<std::string> undeclared = file.find_undeclared(prm);
    OtherSections                  others;
    // Nearly always the kind reads all there is.
    if (undeclared.empty())
      return others;

    check_case(file, present, runner);
    const std::vector<OtherKind> kinds = find_kinds(file, present, runner);
    for (const OtherKind &kind : kinds)
      for (const std::string &name : kind.top.section_names())
        if (present.find_section(name) == nullptr && !contains(others.names, name))
          others.names.push_back(name);
    for (const std::string &path : undeclared)
      if (!contains(case_sections, path) && is_read(path, file, kinds))
        others.passed_over.push_back(path);
    return others;
  }
} // namespace vfife
