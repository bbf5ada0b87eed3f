// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/study/benchmark/benchmark_study.h>
#include <vfife/study/compare/compare_study.h>
#include <vfife/study/conventional/linear_static_study.h>
#include <vfife/study/conventional/loaded_contact_study.h>
#include <vfife/study/conventional/modal_study.h>
#include <vfife/study/gear/lumped_study.h>
#include <vfife/study/gear/mesh_study.h>
#include <vfife/study/gear/tooth_contact_study.h>
#include <vfife/study/run/run_study.h>
#include <vfife/study/run/static_study.h>
#include <vfife/study/study_kinds.h>
#include <vfife/study/sweep/sweep_study.h>

#include <deal.II/base/parameter_handler.h>

namespace vfife
{
  namespace
  {
    /** A study that needs no others. */
    template <typename Kind>
    std::unique_ptr<StudyKind> make(const CaseRunner &)
    {
      return std::make_unique<Kind>();
    }

    /** A study that is made of cases. */
    template <typename Kind>
    std::unique_ptr<StudyKind> make_of_cases(const CaseRunner &runner)
    {
      return std::make_unique<Kind>(runner);
    }
  } // namespace

  const Choices<MakeStudy> &study_kinds()
  {
    // A new kind of study is a row here.
    static const Choices<MakeStudy> kinds = {
      {"run", &make<RunStudy>},
      {"static", &make<StaticStudy>},
      {"tooth contact analysis", &make<ToothContactStudy>},
      {"mesh", &make<MeshStudy>},
      {"modal", &make<ModalStudy>},
      {"linear static", &make<LinearStaticStudy>},
      {"loaded tooth contact analysis", &make<LoadedContactStudy>},
      {"lumped", &make<LumpedStudy>},
      {"benchmark", &make<BenchmarkStudy>},
      {"sweep", &make_of_cases<SweepStudy>},
      {"compare", &make_of_cases<CompareStudy>},
    };
    return kinds;
  }

  void StudyOptions::declare(dealii::ParameterHandler &prm)
  {
    Subsection section(prm, "Study");
    declare_choice(prm, "kind", kind, study_kinds(), "What is done");
    declare_text(prm,
                 "output folder",
                 output_folder,
                 "Folder of the results, made where it is missing");
  }
} // namespace vfife
