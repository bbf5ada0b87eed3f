// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/fem/pressure/pair_pressure.h>
#include <vfife/fem/pressure/penalty_calibration.h>
#include <vfife/model/load_torque.h>
#include <vfife/model/model.h>
#include <vfife/study/cases/case.h>
#include <vfife/study/pressure/calibrated_penalty.h>
#include <vfife/study/pressure/pressure_depth.h>

namespace vfife
{
  namespace
  {
    /** Cells over the width of a contact, with which its approach is known to a thousandth. */
    constexpr unsigned int cells_across = 10;
    /** Over one tooth mesh; contacts that lie between two of them have penalties between theirs. */
    constexpr unsigned int n_positions = 8;

    PointPenalties find_penalties(const Case &the_case, Compliance &compliance, const Model &model)
    {
      std::vector<double> first, turns;
      for (const ContactPair &pair : model.contacts)
        first.push_back(pair.options.penalty.value);
      for (unsigned int i = 0; i < n_positions; ++i)
        turns.push_back(2. * pi / model.transmission->driver_teeth * i / n_positions);
      PairEquilibrium    equilibrium(model, compliance, first, turns);
      PairPressure       pressure(compliance,
                            choose_pressure_depth(0., model, the_case.hertz_contact()),
                            cells_across);
      PenaltyCalibration calibration(model.contacts.front(), first.front());
      for (const double turn : turns)
        {
          const PairEquilibriumResult result = equilibrium.solve(turn, 1.);
          pressure.solve(equilibrium, result, &calibration);
        }
      return calibration.find();
    }

    void keep_penalties(const std::string &why, const Model &model, Log &log)
    {
      log.warning("Contact/penalty: the contact's own grid gives none (" + why +
                  "). The contact has " +
                  std::to_string(std::lround(model.contacts.front().options.penalty.value)) +
                  " N/mm^3, and its approach depends on the mesh.");
    }
  } // namespace

  bool needs_calibration(const Case &the_case, const Model &model)
  {
    return model.transmission && !model.contacts.empty() && the_case.leaves_penalty_open() &&
           model.contacts.front().options.discretization == ContactDiscretization::surface_points &&
           load_torque(model) > 0;
  }

  void calibrate_penalty(const Case &the_case, Compliance &compliance, Log &log, Model &model)
  {
    const auto     start = WallClock::now();
    PointPenalties found;
    try
      {
        found = find_penalties(the_case, compliance, model);
      }
    catch (const InputError &error)
      {
        return keep_penalties(error.what(), model, log);
      }
    catch (const NumericalError &error)
      {
        return keep_penalties(error.what(), model, log);
      }
    ContactPair &loaded          = model.contacts.front();
    loaded.options.penalty.value = found.largest;
    loaded.stiffness             = found.stiffness;
    loaded.mean_stiffness        = found.mean / found.largest;
    for (std::size_t i = 1; i < model.contacts.size(); ++i)
      model.contacts[i].options.penalty.value = found.mean;
    log.line("contact penalty by the contact's own grid at ",
             n_positions,
             " positions: mean ",
             found.mean,
             " N/mm^3, ",
             found.least,
             " to ",
             found.largest,
             "; loads of tooth pairs within ",
             100. * found.left,
             " %; found in ",
             seconds_since(start),
             " s");
  }
} // namespace vfife
