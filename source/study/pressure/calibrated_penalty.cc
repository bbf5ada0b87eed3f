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
#include <vfife/study/pressure/facets_passed.h>
#include <vfife/study/pressure/pressure_depth.h>

#include <numeric>

namespace vfife
{
  namespace
  {
    /** Cells over the width of a contact, with which its approach is known to a thousandth. */
    constexpr unsigned int cells_across = 10;
    /** Over one gear mesh; contacts that lie between two of them have penalties between theirs. */
    constexpr unsigned int n_positions = 8;
    /** Of the static transmission error; a multiple of n_positions. */
    constexpr unsigned int n_turns = 16;

    double error_of(const Compliance &compliance, const PairEquilibriumResult &result)
    {
      return lead_of_driven(compliance.space(), result.turn, result.displacements);
    }

    /** Static transmission errors of the contact's own grid [rad] at @p positions, a divisor of
     * n_turns; @p passed and @p calibration, if any, get the contacts of each. */
    std::vector<double> find_grid_errors(const Case         &the_case,
                                         Compliance         &compliance,
                                         const Model        &model,
                                         const unsigned int  positions,
                                         FacetsPassed       *passed,
                                         PenaltyCalibration *calibration)
    {
      const std::vector<double> turns = turns_over_mesh(*model.transmission);
      PairEquilibrium           equilibrium(model, compliance, turns);
      PairPressure              pressure(compliance,
                            choose_pressure_depth(0., model, the_case.hertz_contact()),
                            cells_across);
      std::vector<double>       errors;
      for (unsigned int i = 0; i < n_turns; i += n_turns / positions)
        {
          const PairEquilibriumResult result = equilibrium.solve(turns[i], 1.);
          const PairPressures         found  = pressure.solve(equilibrium, result, calibration);
          errors.push_back(error_of(compliance, result) + found.lead);
          if (passed != nullptr)
            passed->add(found.teeth);
        }
      return errors;
    }

    double mean_of(const std::vector<double> &values)
    {
      return std::accumulate(values.begin(), values.end(), 0.) / values.size();
    }

    void keep_penalties(const std::string &why, const Model &model, Log &log)
    {
      log.warning("Contact/penalty: the contact's own grid gives no penalty (" + why +
                  "). The contact uses " +
                  std::to_string(std::lround(model.contacts.front().options.penalty.value)) +
                  " N/mm^3, and its approach depends on the mesh.");
    }
  } // namespace

  std::vector<double> turns_over_mesh(const Transmission &transmission)
  {
    std::vector<double> turns;
    for (unsigned int i = 0; i < n_turns; ++i)
      turns.push_back(2. * pi / transmission.driver_teeth * i / n_turns);
    return turns;
  }

  std::vector<double>
  find_static_errors(Compliance &compliance, const Model &model, const unsigned int every)
  {
    const std::vector<double> turns = turns_over_mesh(*model.transmission);
    PairEquilibrium           equilibrium(model, compliance, turns);
    std::vector<double>       errors;
    for (std::size_t i = 0; i < turns.size(); i += every)
      errors.push_back(error_of(compliance, equilibrium.solve(turns[i], 1.)));
    return errors;
  }

  bool needs_calibration(const Case &the_case, const Model &model)
  {
    return model.transmission && !model.contacts.empty() && the_case.leaves_penalty_open() &&
           model.contacts.front().options.discretization == ContactDiscretization::surface_points &&
           load_torque(model) > 0;
  }

  std::vector<double>
  find_spring_errors(Compliance &compliance, const Model &model, const std::vector<double> &errors)
  {
    std::vector<double> found = find_static_errors(compliance, model, n_turns / errors.size());
    for (std::size_t i = 0; i < errors.size(); ++i)
      found[i] -= errors[i];
    return found;
  }

  double find_mean_error(const Case &the_case, Compliance &compliance, const Model &model)
  {
    return mean_of(
      find_grid_errors(the_case, compliance, model, n_positions / 2, nullptr, nullptr));
  }

  std::vector<double> calibrate_penalty(const Case                 &the_case,
                                        Compliance                 &compliance,
                                        Log                        &log,
                                        Model                      &model,
                                        const std::optional<double> mean_error)
  {
    const auto          start = WallClock::now();
    PointPenalties      found;
    std::vector<double> grid_errors;
    FacetsPassed        passed(model, 1. / n_positions);
    try
      {
        PenaltyCalibration calibration(model.contacts.front());
        grid_errors =
          find_grid_errors(the_case, compliance, model, n_positions, &passed, &calibration);
        const double lag = mean_error ? mean_of(grid_errors) - *mean_error : 0.;
        for (double &error : grid_errors)
          error -= lag;
        found = calibration.find(lag);
      }
    catch (const InputError &error)
      {
        keep_penalties(error.what(), model, log);
        return {};
      }
    catch (const NumericalError &error)
      {
        keep_penalties(error.what(), model, log);
        return {};
      }
    ContactPair &loaded          = model.contacts.front();
    loaded.options.penalty.value = found.largest;
    loaded.stiffness             = found.stiffness;
    loaded.mean_stiffness        = found.mean / found.largest;
    for (std::size_t i = 1; i < model.contacts.size(); ++i)
      model.contacts[i].options.penalty.value = found.mean;
    for (unsigned int side = 0; side < 2; ++side)
      {
        const Vector2 facets       = passed.find(side);
        loaded.facets_passed[side] = {{facets[0], facets[1]}};
        log.line("facets of the ",
                 model.bodies[side == 0 ? loaded.slave_body : loaded.master_body].name(),
                 " passed per mesh cycle: ",
                 facets[0],
                 " along the face, ",
                 facets[1],
                 " along the profile; the finite element mesh excites vibrations near these mesh "
                 "orders");
      }
    log.line("contact penalty by the contact's own grid at ",
             n_positions,
             " positions: mean ",
             found.mean,
             " N/mm^3, ",
             found.least,
             " to ",
             found.largest,
             "; loads of tooth pairs agree within ",
             100. * found.left,
             " %; found in ",
             seconds_since(start),
             " s");
    return grid_errors;
  }
} // namespace vfife
