// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_stress_fillet_options_h
#define vfife_stress_fillet_options_h

#include <vfife/stress/gauge.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  class ParameterFile;

  /** Of which teeth root stresses are recorded. */
  enum class RecordedTeeth
  {
    none,
    in_contact, ///< those in contact and one beside them on either side
    named,      ///< FilletOptions::read_named_teeth()
    all
  };

  /** Where the stresses at fillets of generated gears come from. */
  enum class FilletSource
  {
    submodel, ///< a fine mesh of a tooth and the halves beside it that follows the body
    elements  ///< the elements of the body's own mesh
  };

  /** Section Fillets. */
  struct FilletOptions
  {
    FilletSource                                      source            = FilletSource::submodel;
    unsigned int                                      submodel_elements = 10; ///< along the face
    RecordedTeeth                                     teeth             = RecordedTeeth::none;
    std::vector<std::string>                          named_teeth; ///< "pinion 0"
    std::vector<std::pair<std::string, GaugeOptions>> gauges;      ///< with their names

    static constexpr char section[] = "Fillets";

    /** Declares the section, with a subsection for each gauge that @p file names. */
    void declare(dealii::ParameterHandler &prm, const ParameterFile &file);

    /** Throws InputError for teeth that are named and not asked for, or the other way round. */
    void check() const;

    /** Those of the @p body, which has so many @p teeth. Throws InputError for others. */
    std::set<unsigned int> read_named_teeth(const std::string &body, unsigned int teeth) const;

    bool records() const
    {
      return teeth != RecordedTeeth::none || !gauges.empty();
    }
    /** Whether these are taken from submodels of the teeth. */
    bool follows_submodels() const
    {
      return records() && source == FilletSource::submodel;
    }

  private:
    void declare_names_of_gauges(dealii::ParameterHandler &prm);

    std::vector<std::string> names_;
  };
} // namespace vfife

#endif
