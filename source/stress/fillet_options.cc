// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/stress/fillet_options.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace vfife
{
  void FilletOptions::declare_names_of_gauges(dealii::ParameterHandler &prm)
  {
    const Subsection subsection(prm, section);
    declare_names(prm,
                  "gauges",
                  names_,
                  "Names of strain gauges; each has a subsection \"Gauge NAME\"");
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
                                          {"in contact", RecordedTeeth::in_contact},
                                          {"named", RecordedTeeth::named},
                                          {"all", RecordedTeeth::all}};
    declare_choice(prm,
                   "teeth",
                   teeth,
                   words,
                   "Teeth whose root stresses are recorded. in contact: teeth in contact and one "
                   "more on each side; named: those of named teeth");
    const Choices<FilletSource> sources = {{"submodel", FilletSource::submodel},
                                           {"elements", FilletSource::elements}};
    declare_choice(
      prm,
      "source",
      source,
      sources,
      "Where root stresses and strains of gauges come from. submodel: curved quadratic "
      "elements of a tooth and the halves beside it, which follow the displacements of the mesh "
      "and have "
      "its contact forces; elements: the elements of the mesh, whose root stresses are "
      "too low on coarse meshes");
    declare_integer(prm,
                    "submodel elements along face width",
                    submodel_elements,
                    "Elements of submodels along the face width, of both members",
                    2,
                    100);
    declare_names(prm,
                  "named teeth",
                  named_teeth,
                  "Teeth for teeth = named: member and number from 0, as \"pinion 0, gear 3\"");
    for (auto &[name, gauge] : gauges)
      {
        const Subsection own(prm, "Gauge " + name);
        gauge.declare(prm);
      }
  }

  void FilletOptions::check() const
  {
    const std::string entry = std::string(section) + "/named teeth";
    if (teeth == RecordedTeeth::named && named_teeth.empty())
      throw InputError(entry, "expected the names of teeth, such as \"pinion 0\", got none");
    if (teeth != RecordedTeeth::named && !named_teeth.empty())
      throw InputError(entry, "requires teeth = named");
    const std::vector<std::string> members = {"pinion", "gear"};
    for (const std::string &name : named_teeth)
      {
        const std::string member = name.substr(0, name.find(' '));
        if (std::count(members.begin(), members.end(), member) == 0 || name == member)
          throw InputError(
            entry,
            "expected a tooth of the pinion or the gear, such as \"gear 3\", got \"" + name + "\"" +
              did_you_mean(member, members));
      }
  }

  std::set<unsigned int> FilletOptions::read_named_teeth(const std::string &body,
                                                         const unsigned int n_teeth) const
  {
    std::set<unsigned int> numbers;
    for (const std::string &name : named_teeth)
      if (name.rfind(body + " ", 0) == 0)
        try
          {
            numbers.insert(read_tooth_number(name.substr(body.size() + 1), n_teeth));
          }
        catch (const InputError &error)
          {
            throw InputError(std::string(section) + "/named teeth", body + ": " + error.what());
          }
    return numbers;
  }
} // namespace vfife
