// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/sample_measures.h>
#include <vfife/fem/pressure/flank_pair.h>
#include <vfife/fem/pressure/pair_pressure.h>
#include <vfife/fem/pressure/penalty_calibration.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>
#include <vfife/model/pair_measures.h>
#include <vfife/study/cases/pair_case.h>
#include <vfife/study/pressure/calibrated_penalty.h>
#include <vfife/study/pressure/pressure_depth.h>

#include <Eigen/QR>

#include <map>
#include <utility>

namespace vfife
{
  namespace
  {
    /**
     * How many facets of a flank the contact passes per gear mesh: the mesh excites the pair with
     * orders of the gear mesh near these numbers, and contact points with so many times these as a
     * facet has points in that direction.
     */
    class FacetsPassed
    {
    public:
      /** Contacts at the next one of positions that are @p spacing gear meshes apart. */
      FacetsPassed(const Model &model, double spacing);

      void add(const std::vector<ToothPressure> &teeth);

      /** Of a @p side, 0 slave and 1 master: along the face and along the profile. Means over the
       * ways of all contacts; zero where no contact was seen twice. */
      Vector2 find(unsigned int side) const;

    private:
      /** Middle of a contact on a flank, and the sides of the facet there, along the face first. */
      struct Place
      {
        Vector3                     middle = Vector3::Zero();
        Eigen::Matrix<double, 3, 2> sides;
      };

      const Model                                                          &model_;
      double                                                                spacing_;
      std::map<std::pair<unsigned int, unsigned int>, std::array<Place, 2>> last_; ///< by groups
      std::array<Vector2, 2>                                                sums_;
      unsigned int                                                          n_ = 0;
    };

    /** Sides of the facet with these corners, through its middle; that along the face leads away
     * from the apex, the origin. */
    Eigen::Matrix<double, 3, 2> find_sides(const FacetSurface                &surface,
                                           const std::array<unsigned int, 4> &corners)
    {
      const auto x = [&](const unsigned int k) -> const Vector3 & {
        return surface.positions[corners[k]];
      };
      Eigen::Matrix<double, 3, 2> sides;
      sides.col(0)         = .5 * (x(1) - x(0) + x(2) - x(3));
      sides.col(1)         = .5 * (x(3) - x(0) + x(2) - x(1));
      const Vector3 apex   = x(0) + x(1) + x(2) + x(3);
      const auto    cosine = [&](const unsigned int c) {
        return std::abs(sides.col(c).normalized().dot(apex));
      };
      if (cosine(1) > cosine(0))
        sides.col(0).swap(sides.col(1));
      return sides;
    }

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
    std::vector<double> find_grid_errors(const PairCase     &the_case,
                                         Compliance         &compliance,
                                         const Model        &model,
                                         const unsigned int  positions,
                                         FacetsPassed       *passed,
                                         PenaltyCalibration *calibration)
    {
      const std::vector<double> turns = turns_over_mesh(*model.only_transmission());
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

    void keep_penalties(const std::string &why, const Model &model, Log &log)
    {
      log.warning("Contact/penalty: the contact's own grid gives no penalty (" + why +
                  "). The contact uses " +
                  std::to_string(std::lround(model.contacts.front().options.penalty.value)) +
                  " N/mm^3, and its approach depends on the mesh.");
    }
  } // namespace

  FacetsPassed::FacetsPassed(const Model &model, const double spacing)
    : model_(model)
    , spacing_(spacing)
    , sums_{{Vector2::Zero(), Vector2::Zero()}}
  {
  }

  void FacetsPassed::add(const std::vector<ToothPressure> &teeth)
  {
    const ContactPair &pair = model_.contacts.front();
    std::map<std::pair<unsigned int, unsigned int>, std::array<Place, 2>> now;
    for (const ToothPressure &tooth : teeth)
      {
        const auto            groups = std::make_pair(tooth.slave_group, tooth.master_group);
        std::array<Place, 2> &places = now[groups];
        for (unsigned int side = 0; side < 2; ++side)
          {
            const Body &body = model_.bodies[side == 0 ? pair.slave_body : pair.master_body];
            const FacetSurface &surface =
              body.mesh().surfaces.at(side == 0 ? pair.slave_surface : pair.master_surface);
            double sum = 0;
            for (std::size_t k = 0; k < tooth.grid.cells.size(); ++k)
              {
                places[side].middle += tooth.grid.force_of(k) * tooth.places[side][k];
                sum += tooth.grid.force_of(k);
              }
            places[side].middle /= sum;
            std::size_t nearest = 0;
            for (std::size_t k = 0; k < tooth.grid.cells.size(); ++k)
              if ((tooth.places[side][k] - places[side].middle).norm() <
                  (tooth.places[side][nearest] - places[side].middle).norm())
                nearest = k;
            places[side].sides = find_sides(surface, tooth.grid.cells[nearest].feet[side].nodes);
          }
        const auto before = last_.find(groups);
        if (before == last_.end())
          continue;
        for (unsigned int side = 0; side < 2; ++side)
          {
            const Eigen::Matrix<double, 3, 2> sides =
              .5 * (places[side].sides + before->second[side].sides);
            const Vector3 way = places[side].middle - before->second[side].middle;
            sums_[side] += Vector2(sides.colPivHouseholderQr().solve(way)).cwiseAbs();
          }
        ++n_;
      }
    last_ = std::move(now);
  }

  Vector2 FacetsPassed::find(const unsigned int side) const
  {
    return n_ == 0 ? Vector2(Vector2::Zero()) : Vector2(sums_[side] / (n_ * spacing_));
  }

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
    const std::vector<double> turns = turns_over_mesh(*model.only_transmission());
    PairEquilibrium           equilibrium(model, compliance, turns);
    std::vector<double>       errors;
    for (std::size_t i = 0; i < turns.size(); i += every)
      errors.push_back(error_of(compliance, equilibrium.solve(turns[i], 1.)));
    return errors;
  }

  bool needs_calibration(const PairCase &the_case, const Model &model)
  {
    return !model.transmissions.empty() && !model.contacts.empty() &&
           the_case.leaves_penalty_open() &&
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

  double find_mean_error(const PairCase &the_case, Compliance &compliance, const Model &model)
  {
    return mean_of(
      find_grid_errors(the_case, compliance, model, n_positions / 2, nullptr, nullptr));
  }

  std::vector<double> calibrate_penalty(const PairCase             &the_case,
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
