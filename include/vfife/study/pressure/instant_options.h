// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_pressure_instant_options_h
#define vfife_study_pressure_instant_options_h

#include <vfife/base/parameter_handler.h>

#include <string>
#include <vector>

namespace vfife
{
  struct Transmission;

  /** Section Pressure: instants of a run at which pressures are found on grids of their own. */
  struct InstantOptions
  {
    std::vector<std::string> instants;   ///< mesh cycles since the start, or times
    double                   every = 0;  ///< mesh cycles between more of them; 0: no more
    double                   last  = 1;  ///< mesh cycles before the end with these; 0: the run
    unsigned int             cells = 16; ///< across a contact
    double                   depth = 0;  ///< of the layers [mm]; 0: by Hertz's width

    static constexpr char section[] = "Pressure";

    /** Declares the section. */
    void declare(dealii::ParameterHandler &prm);

    /** Throws InputError for instants that are none. */
    void check() const;

    bool asked_for() const
    {
      return !instants.empty() || every > 0;
    }

    /** The path of the entry that asks for instants. */
    std::string asking_entry() const;

    /** The instants of a run that ends at @p end_time, ascending, each once [s]. Throws InputError
     * for those that lie outside of it, and for too many. */
    std::vector<double> find_times(const Transmission &pair, double end_time) const;
  };
} // namespace vfife

#endif
