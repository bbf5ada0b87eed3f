// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/declared_section.h>
#include <vfife/study/other_sections.h>
#include <vfife/study/study_kinds.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace vfife
{
  namespace
  {
    /** Of which there is one in each case. */
    const std::vector<std::string> case_sections = {"Model", "Gear pair"};

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

    /** Whether one of the kinds reads a section; throws what the first of them says against it. */
    bool is_read(const std::string            &section,
                 const ParameterFile          &file,
                 const std::vector<OtherKind> &kinds)
    {
      std::optional<InputError> complaint;
      for (const OtherKind &kind : kinds)
        if (kind.top.find_section(section) != nullptr)
          try
            {
              file.read_section(section, *kind.prm);
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
    const DeclaredSection          present = find_declared(prm);
    const std::vector<std::string> all     = file.sections();
    OtherSections                  others;
    // Nearly always the kind reads all there is.
    if (std::all_of(all.begin(), all.end(), [&](const std::string &name) {
          return present.find_section(name) != nullptr;
        }))
      return others;

    const std::vector<OtherKind> kinds = find_kinds(file, present, runner);
    for (const OtherKind &kind : kinds)
      for (const std::string &name : kind.top.section_names())
        if (present.find_section(name) == nullptr && !contains(others.names, name))
          others.names.push_back(name);
    for (const std::string &name : all)
      if (present.find_section(name) == nullptr && !contains(case_sections, name) &&
          is_read(name, file, kinds))
        others.passed_over.push_back(name);
    return others;
  }
} // namespace vfife
