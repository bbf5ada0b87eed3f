// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/stress/fillet_options.h>

#include <deal.II/base/parameter_handler.h>

namespace vfife
{
  void FilletOptions::declare_names_of_gauges(dealii::ParameterHandler &prm)
  {
    const Subsection subsection(prm, section);
    declare_names(prm, "gauges", names_, "Strain gauges: a subsection \"Gauge NAME\" for each");
  }

  void FilletOptions::declare(dealii::ParameterHandler &prm, const ParameterFile &file)
  {
    // A pass for the names alone; entries are bound by address, so no gauge moves afterwards.
    file.read_known([this](dealii::ParameterHandler &first) { declare_names_of_gauges(first); });
    gauges.clear();
    for (const std::string &name : names_)
      gauges.emplace_back(name, GaugeOptions());
    declare_names_of_gauges(prm);
    const Subsection             subsection(prm, section);
    const Choices<RecordedTeeth> words = {{"none", RecordedTeeth::none},
                                          {"in mesh", RecordedTeeth::in_mesh},
                                          {"all", RecordedTeeth::all}};
    declare_choice(prm,
                   "teeth",
                   teeth,
                   words,
                   "Of which teeth root stresses are recorded; in mesh: those in contact and one "
                   "beside them on either side");
    for (auto &[name, gauge] : gauges)
      {
        const Subsection own(prm, "Gauge " + name);
        gauge.declare(prm);
      }
  }
} // namespace vfife
