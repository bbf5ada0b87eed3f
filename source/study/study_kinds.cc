// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/study/study_kinds.h>

#include <deal.II/base/parameter_handler.h>

namespace vfife
{
  namespace
  {
    /** A study that needs no others. */
    template <std::unique_ptr<StudyKind> (*make)()>
    std::unique_ptr<StudyKind> alone(const CaseRunner &)
    {
      return make();
    }
  } // namespace

  std::vector<std::string> StudyKind::cases_taken_over() const
  {
    return {};
  }

  std::size_t
  StudyKind::resume(const std::string &, const DeclaredSection &, const Communicator &, Log &)
  {
    throw InputError(
      "Study/kind",
      "--restart is not available for this kind (available: run, reduced, sweep, compare, waves)");
  }

  const Choices<KnownStudy> &study_kinds()
  {
    // A new kind of study is a row here: the word, how it is made, the file that it writes last.
    static const Choices<KnownStudy> kinds = {
      {"run", {&alone<make_run_study>, "summary.json"}},
      {"reduced", {&alone<make_reduced_study>, "summary.json"}},
      {"waves", {&make_waves_study, "summary.json"}},
      {"static", {&alone<make_static_study>, "summary.json"}},
      {"tooth contact analysis", {&alone<make_tooth_contact_study>, "tca.json"}},
      {"flank fit", {&alone<make_flank_fit_study>, "flank_fit.json"}},
      {"mesh", {&alone<make_mesh_study>, "mesh.json"}},
      {"modal", {&alone<make_modal_study>, "modes.json"}},
      {"linear static", {&alone<make_linear_static_study>, "summary.json"}},
      {"loaded tooth contact analysis", {&alone<make_loaded_contact_study>, "loaded_contact.json"}},
      {"lumped", {&alone<make_lumped_study>, "lumped.json"}},
      // its tables are written anew after every run
      {"sweep", {&make_sweep_study, ""}},
      // each of its cases is looked at
      {"compare", {&make_compare_study, ""}},
    };
    return kinds;
  }

  void StudyOptions::declare(dealii::ParameterHandler &prm)
  {
    Subsection section(prm, "Study");
    declare_choice(prm, "kind", kind, study_kinds(), "Kind of study");
    declare_text(prm,
                 "output folder",
                 output_folder,
                 "Folder of the results; the program creates it");
  }
} // namespace vfife
