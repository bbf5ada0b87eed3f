// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/reduced/pair/pair_reader.h>
#include <vfife/reduced/pair_readings.h>

#include <Eigen/Geometry>

#include <array>
#include <complex>

namespace vfife
{
  using Eigen::VectorXcd;
  using Eigen::VectorXd;

  PairReader::Reading PairReader::reading_of(const unsigned int b) const
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

  std::vector<ProbeValue> PairReader::read_probes(const std::vector<Probe> &probes) const
  {
    std::vector<ProbeValue> measured;
    for (const Probe &probe : probes)
      {
        const ReducedBody    &reduced = members_[probe.body]->body;
        const Reading         read    = reading_of(probe.body);
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

  std::vector<VectorXcd> PairReader::read_modal_forces(const unsigned int body) const
  {
    const PairMember &member = *members_[body];
    return member.rows.project(member.part_of(now_.force));
  }

  double PairReader::read_turn(const unsigned int body) const
  {
    return members_[body]->motion.turn();
  }

  std::vector<double> PairReader::read_rim(const unsigned int largest) const
  {
    // A wave is the sum over sectors k of exp(i n k alpha) (a_k + i b_k), a and b its readings
    // [mm]: of all nodes of the rim, share u exp(i n alpha).
    // Rows keep the waves that they have found.
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

  MeanMotion::Motion PairReader::read_ring(const unsigned int b, const std::string &name) const
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

  std::vector<double> PairReader::read_places(const unsigned int               b,
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
