// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_study_kind_h
#define vfife_study_study_kind_h

#include <vfife/base/parameter_handler.h>

#include <cstddef>
#include <string>
#include <vector>

namespace vfife
{
  class Communicator;
  struct DeclaredSection;
  class Log;
  class OutputFolder;
  class ParameterFile;

  /** One kind of thing that a user can ask for. Called in the order of the functions, on all ranks.
   */
  class StudyKind
  {
  public:
    virtual ~StudyKind() = default;

    /** Declares all sections that the kind reads. Names that decide what is declared are read from
     * @p file. */
    virtual void declare(dealii::ParameterHandler &prm, const ParameterFile &file) = 0;

    /** Throws InputError when entries contradict each other. */
    virtual void check() const = 0;

    /** --check: builds the model and says what a run would be, without running. */
    virtual void inspect(Communicator &communicator, Log &log) = 0;

    /**
     * --restart: tells it, before run(), to resume what an earlier run of these parameters has
     * left in @p folder. Returns how many bytes of run.log are kept. Throws InputError for kinds
     * that cannot resume, and where there is nothing to resume. Collective.
     */
    virtual std::size_t resume(const std::string     &folder,
                               const DeclaredSection &now,
                               const Communicator    &communicator,
                               Log                   &log);

    /** Folders of cases in the folder of the results that run() takes over where they are finished,
     * without --restart too. */
    virtual std::vector<std::string> cases_taken_over() const;

    /** Does it and writes the results. */
    virtual void run(OutputFolder &folder, Log &log) = 0;
  };
} // namespace vfife

#endif
