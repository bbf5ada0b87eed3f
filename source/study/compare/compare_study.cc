// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/case_sections.h>
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/command_line.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/output/files/figures.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/pictures.h>
#include <vfife/study/case_runner.h>
#include <vfife/study/compare/compared_case.h>
#include <vfife/study/compare/comparison.h>
#include <vfife/study/compare/model_comparison.h>
#include <vfife/study/compare/pair/pair_comparison.h>
#include <vfife/study/study_kinds.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace vfife
{
  namespace
  {
    namespace fs = std::filesystem;

    /** Only --check looks at the cases before there are folders. */
    constexpr const char *no_folder = "";

    /** All rows that the kinds of the cases allow. Reads files: for one rank. */
    ComparisonRows compare(const ComparedCases &cases, const ComparisonTolerances &tolerances)
    {
      ComparisonRows rows = compare_pair(cases, tolerances);
      for (const ComparisonRow &row : compare_models(cases, tolerances))
        rows.push_back(row);
      return rows;
    }

    class CompareStudy : public StudyKind
    {
    public:
      explicit CompareStudy(const CaseRunner &runner)
        : runner_(runner)
      {
      }

      void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
      {
        // First pass: each name has a section, which the strict pass has to know.
        file.read_known([this](dealii::ParameterHandler &first) {
          Subsection section(first, "Compare");
          declare_own(first);
        });
        cases_.resize(names_.size());
        Subsection section(prm, "Compare");
        declare_own(prm);
        for (std::size_t i = 0; i < names_.size(); ++i)
          {
            Case &one = cases_[i];
            one.name  = names_[i];
            Subsection part(prm, "Case " + names_[i]);
            declare_file_name(prm,
                              "base",
                              one.base,
                              "Parameter file of the case, relative to this file");
            declare_text(
              prm,
              "entries",
              one.entries,
              "Entries that differ from the case's file, as Compare/entries; {NAME} is the "
              "results folder of case NAME");
            declare_file_name(prm,
                              "results",
                              one.results,
                              "Folder with existing results, read instead of computing the case");
          }
      }

      /** Reads every case that is to be done. */
      void check() const override
      {
        if (cases_.size() < 2)
          throw InputError("Compare/cases", "expected at least two cases");
        for (const Case &one : cases_)
          check_case(one);
      }

      void inspect(Communicator &, Log &log) override
      {
        for (const Case &one : cases_)
          log.line(one.name, ": ", one.results.empty() ? one.base : "results of " + one.results);
      }

      std::size_t
      resume(const std::string &, const DeclaredSection &, const Communicator &, Log &) override
      {
        return std::numeric_limits<std::size_t>::max(); // each case is looked at by itself, always
      }

      std::vector<std::string> cases_taken_over() const override
      {
        std::vector<std::string> names;
        for (const Case &one : cases_)
          if (one.results.empty())
            names.push_back(one.name);
        return names;
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      struct Case
      {
        std::string name, base, entries, results;
      };

      void        declare_own(dealii::ParameterHandler &prm);
      void        check_case(const Case &one) const;
      CommandLine command_line(const Case &one, const std::string &folder) const;
      /** Entries "A/B/name = value; ...", {NAME} replaced by the folder of that case. */
      std::vector<std::string> list_entries(const std::string &text,
                                            const std::string &folder) const;
      std::string              folder_of(const Case &one, const std::string &folder) const;
      ComparedCase             do_one(const Case &one, OutputFolder &folder, Log &log) const;

      const CaseRunner        &runner_;
      std::string              title_, entries_;
      std::vector<std::string> names_;
      std::vector<Case>        cases_;
      ComparisonTolerances     tolerances_;
      bool                     pictures_ = true;
    };
  } // namespace

  void CompareStudy::declare_own(dealii::ParameterHandler &prm)
  {
    declare_text(prm, "title", title_, "Title of the comparison");
    declare_names(prm, "cases", names_, "Names of cases; each has a section Case NAME");
    declare_text(prm,
                 "entries",
                 entries_,
                 "Entries in which all cases differ from their files: \"Section/name = value\", "
                 "separated by semicolons");
    declare_switch(prm, "report", pictures_, "Writes the report at the end");
    tolerances_.declare(prm);
  }

  std::string CompareStudy::folder_of(const Case &one, const std::string &folder) const
  {
    return one.results.empty() ? (fs::path(folder) / one.name).string() : one.results;
  }

  std::vector<std::string> CompareStudy::list_entries(const std::string &text,
                                                      const std::string &folder) const
  {
    // {NAME} may stand anywhere in an entry, for any of the cases. Without a folder of results it
    // becomes NAME: enough for reading and checking the file.
    std::vector<std::string> list = split_entries(text, "Compare/entries");
    for (std::string &entry : list)
      for (const Case &other : cases_)
        for (std::size_t at; (at = entry.find("{" + other.name + "}")) != std::string::npos;)
          entry.replace(at, other.name.size() + 2, folder_of(other, folder));
    return list;
  }

  CommandLine CompareStudy::command_line(const Case &one, const std::string &folder) const
  {
    CommandLine line;
    line.parameter_file = one.base;
    line.output_folder  = folder_of(one, folder);
    // The case's own entries come last and win.
    for (const std::string &text : {entries_, one.entries})
      for (const std::string &entry : list_entries(text, folder))
        line.overrides.push_back(entry);
    return line;
  }

  void CompareStudy::check_case(const Case &one) const
  {
    const std::string section = "Compare/Case " + one.name;
    if (!one.results.empty())
      {
        if (!is_there(one.results + "/parameters.prm"))
          throw InputError(section + "/results",
                           "the folder \"" + one.results + "\" has no results of a case");
        return;
      }
    if (one.base.empty())
      throw InputError(section + "/base", "the parameter file of the case is missing");
    for_place("case " + one.name, [&] { runner_.read(command_line(one, no_folder)); });
  }

  ComparedCase CompareStudy::do_one(const Case &one, OutputFolder &folder, Log &log) const
  {
    // All ranks do the cases, one after the other; a case takes a communicator that it may change.
    Communicator ranks(folder.communicator().mpi());
    ComparedCase compared;
    CommandLine  results;
    compared.name   = one.name;
    compared.folder = folder_of(one, folder.path());
    if (one.results.empty())
      {
        log.line(one.name, " begins: ", one.base);
        folder.list_file(one.name + "/");
        // A case that is finished with the same entries and files is not done again.
        const CaseReport report = runner_.do_case(command_line(one, folder.path()), true, ranks);
        log.line(one.name, " ", report.describe());
        if (report.outcome == Outcome::interrupted)
          throw Interrupted("the comparison is stopped. Run the same command to continue");
        if (report.outcome == Outcome::failed)
          throw NumericalError("case " + one.name + " has failed: " + report.message);
      }
    // Kind and sections are those that the results state, also where they have been found as they
    // are.
    results.parameter_file = compared.folder + "/parameters.prm";
    const CaseFile file    = runner_.read(results);
    compared.kind          = file.value("Study/kind");
    compared.is_pair       = has_pair_section([&file](const std::string &section) {
      return std::any_of(file.entries.begin(), file.entries.end(), [&section](const auto &e) {
        return e.first.rfind(section + "/", 0) == 0;
      });
    });
    return compared;
  }

  void CompareStudy::run(OutputFolder &folder, Log &log)
  {
    ComparedCases cases;
    for (const Case &one : cases_)
      cases.push_back(do_one(one, folder, log));

    // One rank reads: files may appear on the others later.
    // Failures of the one that reads are told to all, so that all end alike.
    ComparisonRows             rows;
    std::optional<std::string> failure;
    std::vector<std::string>   remarks;
    if (folder.communicator().is_root())
      try
        {
          rows    = compare(cases, tolerances_);
          remarks = list_other_pairs(cases);
          for (const ComparedCase &one : cases)
            if (!one.is_read)
              remarks.push_back(
                "the case \"" + one.name +
                "\" is not compared: no other case has comparable results for the kind " +
                one.kind + ", or an earlier case of this kind is used");
            else if (!one.lack.empty())
              remarks.push_back(one.lack);
          if (rows.empty())
            {
              failure = "the cases have no results in common that can be compared";
              // There is no file for them.
              for (const std::string &remark : remarks)
                *failure += "\n  " + remark;
            }
        }
      catch (const InputError &error)
        {
          failure = error.what();
        }
      catch (const std::logic_error &error)
        {
          // Columns that the tables of these kinds of studies have, but not these files.
          failure = std::string("the results of a case are damaged: ") + error.what();
        }
    const std::string message = folder.communicator().broadcast(failure.value_or(""));
    if (!message.empty())
      throw InputError("Compare/cases", message);

    for (const std::string &remark : remarks)
      log.warning(remark);
    for (const ComparisonRow &row : rows)
      log.line(row.quantity,
               ": ",
               row.value,
               " against ",
               row.reference,
               " ",
               row.unit,
               " (",
               row.reference_kind,
               "): ",
               row.verdict());
    write_csv(folder, "comparison.csv", comparison_table(rows));
    write_json(folder, "comparison.json", comparison_json(title_, cases, remarks, rows));
    if (pictures_)
      draw_pictures(folder, log);
  }

  std::unique_ptr<StudyKind> make_compare_study(const CaseRunner &runner)
  {
    return std::make_unique<CompareStudy>(runner);
  }
} // namespace vfife
