// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What is measured of a ReducedPair.
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/model/pair_measures.h>
#include <vfife/model/state.h>
#include <vfife/reduced/pair_readings.h>
#include <vfife/reduced/reduced_pair.h>

#include <Eigen/Geometry>

#include <array>
#include <complex>

namespace vfife
{
  using Eigen::VectorXcd;
  using Eigen::VectorXd;

  void ReducedPair::measure_angles(Measurements &measured) const
  {
    const Transmission &t    = *model_.only_transmission();
    const auto          read = [&](const unsigned int b, const char *const reading) {
      return members_[b]->read_turn(reading, members_[b]->part_of(now_.force));
    };
    measured.driver_angle =
      t.driver_bore.empty() ? 0. : t.driver_sense * read(t.driver, reading::bore_turn);
    measured.driven_angle = t.driven_sense * read(t.driven, reading::bore_turn);
    measured.rim_angle    = t.driven_sense * read(t.driven, reading::rim_turn);
    complete_angles(t, drive_.turn, measured);
  }

  void ReducedPair::measure_contact(State &state) const
  {
    Measurements &m = state.measured;
    set_teeth(pair_.teeth(), model_.contacts.size(), m);
    if (state.contact_force.empty())
      return;
    state.contact_force.set_zero();
    for (std::size_t i = 0; i < rows_.nodes().size(); ++i)
      {
        const auto &[b, node] = rows_.nodes()[i];
        state.contact_force.set(model_.bodies[b].first_node + node,
                                pair_.to_fixed_frame(i, now_.force.segment<3>(3 * i)));
      }
  }

  void ReducedPair::add_contact_impulse()
  {
    Measurements measured;
    set_teeth(pair_.teeth(), model_.contacts.size(), measured);
    contact_impulse_.add(time_step(), measured.contact_force, measured.contact_torque);
  }

  double ReducedPair::measure_drive_torque() const
  {
    const PairMember &driver = *members_[model_.only_transmission()->driver];
    double torque = driver.inertia * driver.axial.acceleration - now_.acting.driver_torque;
    if (!driver.in_bearings())
      return torque;
    // What turns the shaft's end.
    torque = 0;
    for (const Coupling &coupling : model_.couplings)
      if (coupling.body == model_.only_transmission()->driver)
        {
          const auto [way, rate] = driver.twist(coupling, driver.part_of(now_.force));
          torque -= coupling.stiffness * way + coupling.damping * rate;
        }
    return torque;
  }

  void ReducedPair::measure(State &state)
  {
    state.time = drive_.time;
    state.step = drive_.n_steps;
    state.dt   = time_step();
    measure_angles(state.measured);
    measure_contact(state);
    energy_.measure();
    state.measured.energy       = energy_.ledger;
    state.measured.bearings     = bearings_.measure(drive_.n_steps > 0);
    state.measured.drive_torque = measure_drive_torque();
    state.measured.rate_factor  = drive_.rate_factor();
    state.measured.body_rates.clear();
    for (const auto &member : members_)
      state.measured.body_rates.push_back(member->rate + member->motion.turn_rate() +
                                          member->modal_rate());
    state.measured.probes = measure_probes(model_.probes);
  }

  ReducedPair::Reader ReducedPair::reader(const unsigned int b) const
  {
    const PairMember &member = *members_[b];
    return
      [&member,
       coordinates = member.coordinates(),
       force = member.part_of(now_.force)](const unsigned int reading, const unsigned int sector) {
        const std::size_t row = 3 * member.body.touch_nodes.size() + reading;
        return member.spin * member.body.spin[row] +
               member.rows.read(reading, sector, coordinates, force, member.axial);
      };
  }

  std::vector<ProbeValue> ReducedPair::measure_probes(const std::vector<Probe> &probes) const
  {
    std::vector<ProbeValue> measured;
    for (const Probe &probe : probes)
      {
        const ReducedBody    &reduced = body(probe.body);
        const Reader          read    = reader(probe.body);
        std::array<double, 9> values{};
        for (unsigned int c = 0; c < values.size(); ++c)
          values[c] = read(reduced.find_reading(reading::of_probe(probe.name, c)),
                           reduced.sector_of(probe.node));
        // Along the body's axes as the probe's copy in sector 0 sees them; r, theta, z turn with
        // the sector.
        const Body   &bulk = model_.bodies[probe.body];
        const Matrix3 axes =
          compute_cylindrical_axes(bulk, bulk.node_positions()[reduced.first_copy(probe.node)]);
        measured.push_back(
          make_probe_value(axes.transpose() * Eigen::Map<const Vector3>(values.data()),
                           Eigen::Map<const Stress>(values.data() + 3),
                           {axes}));
      }
    return measured;
  }

  std::vector<VectorXcd> ReducedPair::measure_modal_forces(const unsigned int body) const
  {
    const PairMember &member = *members_[body];
    return member.rows.project(member.part_of(now_.force));
  }

  double ReducedPair::measure_turn(const unsigned int body) const
  {
    return members_[body]->motion.turn();
  }

  std::vector<double> ReducedPair::measure_rim(const unsigned int largest)
  {
    // A wave is the sum over sectors k of exp(i n k alpha) (a_k + i b_k), a and b its readings
    // [mm]: of all nodes of the rim, share u exp(i n alpha).
    PairMember                  &member      = *members_[model_.only_transmission()->driven];
    const ReducedBody           &body        = member.body;
    const std::vector<VectorXcd> coordinates = member.coordinates();
    const VectorXd               force       = member.part_of(now_.force);
    std::vector<double>          coefficients;
    for (unsigned int c = 0; c < 3; ++c)
      {
        const unsigned int mean = body.find_reading(reading::of_rim(c, 0, false));
        coefficients.push_back(
          1e3 * (body.n_sectors * member.spin * body.spin[3 * body.touch_nodes.size() + mean] +
                 member.rows.read_all(mean, coordinates, force, member.axial)));
        for (unsigned int n = 1; n <= largest; ++n)
          {
            const auto read = [&](const bool imaginary) {
              return member.rows.read_wave(body.find_reading(reading::of_rim(c, n, imaginary)),
                                           n,
                                           coordinates,
                                           force);
            };
            const std::complex<double> sum =
              read(false) + std::complex<double>(0., 1.) * read(true);
            coefficients.push_back(2e3 * sum.real());
            coefficients.push_back(2e3 * sum.imag());
          }
      }
    return coefficients;
  }

  MeanMotion::Motion ReducedPair::measure_ring(const unsigned int b, const std::string &name) const
  {
    const PairMember                 &member = *members_[b];
    const unsigned int                ring   = member.body.rings.find(name);
    const Eigen::Matrix<double, 6, 1> motion = member.rows.read_ring(
      ring, member.spin, member.coordinates(), member.part_of(now_.force), member.axial);
    const Matrix3 &R    = pair_.rotations()[b];
    const Vector3  turn = R * motion.tail<3>();
    const Body    &body = model_.bodies[b];
    // A ring beside the axis goes around it.
    const Vector3 from_axis = body.placement(member.body.rings.centres[ring]) - body.axis.point;
    MeanMotion::Motion placed;
    placed.displacement = R * motion.head<3>() + R * from_axis - from_axis;
    placed.rotation     = R;
    if (turn.norm() > 0)
      placed.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * R;
    return placed;
  }

  std::vector<double> ReducedPair::places_of(const unsigned int               b,
                                             const std::vector<unsigned int> &nodes) const
  {
    std::vector<PairRows::NodeOfBody> of_body;
    for (const unsigned int node : nodes)
      of_body.emplace_back(b, node);
    const VectorXd      u    = rows_.displace_nodes(of_body, now_.force);
    const Body         &body = model_.bodies[b];
    std::vector<double> places(3 * nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      Eigen::Map<Vector3>(places.data() + 3 * i) =
        pair_.place(b, body.placement(body.node_positions()[nodes[i]]) + u.segment<3>(3 * i));
    return places;
  }
} // namespace vfife
