// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/study/benchmark/benchmark_study.h>
#include <vfife/study/compare/compare_study.h>
#include <vfife/study/conventional/linear_static_study.h>
#include <vfife/study/conventional/loaded_contact_study.h>
#include <vfife/study/conventional/modal_study.h>
#include <vfife/study/gear/lumped_study.h>
#include <vfife/study/gear/mesh_study.h>
#include <vfife/study/gear/tooth_contact_study.h>
#include <vfife/study/run/dynamic_run.h>
#include <vfife/study/run/model_run.h>
#include <vfife/study/study_kinds.h>
#include <vfife/study/sweep/sweep_study.h>

#include <deal.II/base/parameter_handler.h>

namespace vfife
{
  namespace
  {
    template <typename Kind>
    std::unique_ptr<StudyKind> make(const ParameterFile &)
    {
      return std::make_unique<Kind>();
    }

    /** A file with a section Model and no Gear pair is a general model. */
    std::unique_ptr<StudyKind> make_run(const ParameterFile &file)
    {
      if (file.contains("Model") && !file.contains("Gear pair"))
        return std::make_unique<ModelRun>();
      return std::make_unique<DynamicRun>();
    }

  } // namespace

  const Choices<MakeStudy> &study_kinds()
  {
    static const Choices<MakeStudy> kinds = {
      {"run", &make_run},
      {"static", &make<StaticRun>},
      {"tooth contact analysis", &make<ToothContactStudy>},
      {"mesh", &make<MeshStudy>},
      {"modal", &make<ModalStudy>},
      {"linear static", &make<LinearStaticStudy>},
      {"loaded tooth contact analysis", &make<LoadedContactStudy>},
      {"lumped", &make<LumpedStudy>},
      {"benchmark", &make<BenchmarkStudy>},
      {"sweep", &make<SweepStudy>},
      {"compare", &make<CompareStudy>},
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
