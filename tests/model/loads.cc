// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What nodes take of a load, moments shared over a face; the numbers of a pair: ratio, angles'
// rates, torque of a tooth; the ledger of energies.
#include "../model_parts.h"
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/bearing/mean_motion.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/load_shares.h>
#include <vfife/model/node_selection.h>
#include <vfife/model/state.h>
#include <vfife/model/tooth_contact.h>

using namespace vfife;

void refuse(const Load &load, const Body &body)
{
  print_refusal([&] { compute_load_shares(load, body); });
}

constexpr double width = 6, height = 9;

Body bar()
{
  return {"bar", make_beam(Vector3(20., width, height), {{5, 3, 6}}), Material()};
}

void shares()
{
  const Body body = bar();
  Load       load;
  load.name  = "pull";
  load.nodes = body.node_set("x+");
  for (const LoadKind kind : {LoadKind::force, LoadKind::spring})
    {
      load.kind         = kind;
      const auto shares = compute_load_shares(load, body);
      const auto ends   = std::minmax_element(shares.begin(), shares.end());
      check_ratio("end face: sum of the shares", sum_of(shares), 1e-14);
      check_close("end face: corner", *ends.first, 1. / (4 * 3 * 6), 1e-15);
      check_close("end face: inner node", *ends.second, 1. / (3 * 6), 1e-15);
    }
  // An edge has no face: all the same.
  load.nodes.clear();
  for (const unsigned int node : body.node_set("x+"))
    if (body.node_positions()[node][2] == -.5 * height)
      load.nodes.push_back(node);
  check("edge: equal shares", compute_load_shares(load, body) == std::vector<double>(4, .25));
  load.kind = LoadKind::pressure;
  refuse(load, body);

  load.kind  = LoadKind::acceleration;
  load.nodes = all_nodes(body);
  check("acceleration: the masses", compute_load_shares(load, body) == body.node_masses());
}

/** Surfaces of a plate of one layer, whose narrow sides have no other nodes. */
void surfaces()
{
  const Body    body("plate", make_block(Vector3(6., 4., 1.), {{3, 2, 1}}), Material());
  NodeSelection selection;
  const auto    area = [&](const std::vector<std::string> &sets, const std::string &where) {
    selection.sets   = sets;
    selection.where  = where;
    const auto nodes = selection.find_nodes(body, "Load");
    return sum_of(compute_nodal_areas(body, nodes, selection.find_faces(body, nodes, "Load")));
  };
  check_close("both skins", area({"z-", "z+"}, ""), 48., 1e-13);
  check_close("the faces of them on whose nodes a condition holds",
              area({"z-", "z+"}, "x > 1"),
              32.,
              1e-13);
  check_close("all nodes", area({"all"}, ""), 48. + 20., 1e-13);
  check("all nodes: no faces are selected", !selection.find_faces(body, {}, "Load"));
  Load load;
  load.name  = "press";
  load.kind  = LoadKind::pressure;
  load.nodes = body.node_set("z-");
  load.faces = std::set<std::array<unsigned int, 4>>();
  refuse(load, body);
}

/** The nodes of an end face that carry a moment. */
struct LoadedFace
{
  std::vector<double>  areas;
  std::vector<Vector3> undeformed;
  MeanMotion           set;

  explicit LoadedFace(const Body &body)
    : areas(compute_nodal_areas(body, body.node_set("x+")))
    , undeformed(places_of(body))
    , set(areas, undeformed, "load \"bend\"")
  {
  }

  static std::vector<Vector3> places_of(const Body &body)
  {
    std::vector<Vector3> places;
    for (const unsigned int node : body.node_set("x+"))
      places.push_back(body.node_positions()[node]);
    return places;
  }

  /** The motion of the nodes at @p places, summed as by two ranks. */
  MeanMotion::Motion motion(const std::vector<Vector3> &places) const
  {
    std::vector<double> sums           = MeanMotion::make_sums();
    std::vector<double> of_other_ranks = MeanMotion::make_sums();
    for (std::size_t i = 0; i < places.size(); ++i)
      set.add(i, places[i], Vector3::Zero(), i % 3 == 0 ? of_other_ranks : sums);
    for (std::size_t c = 0; c < sums.size(); ++c)
      sums[c] += of_other_ranks[c];
    return set.solve(sums);
  }

  /** Sum of the forces, and of their moments about the origin. */
  std::pair<Vector3, Vector3> resultant(const std::vector<Vector3> &places,
                                        const MeanMotion::Motion   &at,
                                        const Vector3              &moment) const
  {
    std::pair<Vector3, Vector3> sums(Vector3::Zero(), Vector3::Zero());
    for (std::size_t i = 0; i < places.size(); ++i)
      {
        const Vector3 nodal = set.force(i, at, Vector3::Zero(), moment);
        sums.first += nodal;
        sums.second += places[i].cross(nodal);
      }
    return sums;
  }
};

void moments()
{
  const Body       body = bar();
  RigidMotion      motion;
  const Vector3    moment(3000., -5000., 7000.);
  const LoadedFace face(body);
  for (const bool moved : {false, true})
    {
      if (moved)
        {
          motion.rotation    = rotation_about(Vector3(1., -1., 2.).normalized(), 2.);
          motion.translation = Vector3(100., -50., 7.);
        }
      std::vector<Vector3> places;
      for (const Vector3 &place : face.undeformed)
        places.push_back(motion(place));
      const auto    at           = face.motion(places);
      const Vector3 acting       = motion.rotation * moment;
      const auto [force, turned] = face.resultant(places, at, acting);
      double deviation           = 0;
      for (std::size_t i = 0; i < places.size(); ++i)
        {
          const Vector3 nodal = face.set.force(i, at, Vector3::Zero(), acting);
          // Beam theory with the second moments of the nodes' areas.
          const Vector3 r  = body.node_positions()[body.node_set("x+")[i]] - Vector3(20., 0., 0.);
          const double  Iz = width * height * (width * width / 12 + 4. / 6);
          const double  Iy = width * height * (height * height / 12 + 2.25 / 6);
          const Vector3 traction(moment[1] / Iy * r[2] - moment[2] / Iz * r[1],
                                 -moment[0] / (Iy + Iz) * r[2],
                                 moment[0] / (Iy + Iz) * r[1]);
          raise_to(deviation,
                   (motion.rotation.transpose() * nodal - face.areas[i] * traction).norm());
        }
      const std::string name = moved ? "moved end face: " : "end face: ";
      check_below(name + "sum of the forces [N]", force.norm(), 1e-9);
      check_below(name + "their moment less the load's [N mm]",
                  (motion.rotation.transpose() * turned - moment).norm(),
                  1e-8);
      check_below(name + "bending and torsion of beam theory [N]", deviation, 1e-9);
    }
  std::vector<Vector3> line;
  for (unsigned int i = 0; i < 4; ++i)
    line.emplace_back(i, 2. * i, 1.);
  print_refusal([&] { MeanMotion({1., 1., 1., 1.}, line, "load \"bend\""); });
}

/** A deformed end face that deforms further: the power of the forces is the moment times the
 * rate of the mean rotation, whatever the nodes do among themselves. */
void power_of_a_moment()
{
  const Body           body = bar();
  const LoadedFace     face(body);
  const Vector3        moment(3000., -5000., 7000.);
  const Matrix3        turn = rotation_about(Vector3(1., -1., 2.).normalized(), 2.);
  std::vector<Vector3> places, way;
  for (std::size_t i = 0; i < face.undeformed.size(); ++i)
    {
      const double s = static_cast<double>(i);
      places.push_back(turn * face.undeformed[i] +
                       .3 * Vector3(std::sin(3 * s), std::cos(5 * s), std::sin(7 * s + 1)));
      way.push_back(Vector3(std::cos(2 * s), std::sin(11 * s), std::cos(13 * s + 2)));
    }
  const auto at              = face.motion(places);
  const auto [force, turned] = face.resultant(places, at, moment);
  double power               = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    power += face.set.force(i, at, Vector3::Zero(), moment).dot(way[i]);
  check_below("deformed end face: sum of the forces [N]", force.norm(), 1e-9);
  check_below("deformed end face: their moment less the load's [N mm]",
              (turned - moment).norm(),
              1e-8);

  // Spin by central differences: R(+h) R(-h)^T = 1 + 2 h [spin]x + O(h^3).
  const double h     = 1e-5;
  const auto   moved = [&](const double amount) {
    std::vector<Vector3> there = places;
    for (std::size_t i = 0; i < there.size(); ++i)
      there[i] += amount * way[i];
    return face.motion(there).rotation;
  };
  const Matrix3 change = moved(h) * moved(-h).transpose();
  const Vector3 spin =
    Vector3(change(2, 1) - change(1, 2), change(0, 2) - change(2, 0), change(1, 0) - change(0, 1)) /
    (4 * h);
  check_ratio("deformed end face: power of the forces over moment times mean spin",
              power / moment.dot(spin),
              1e-8);

  // The same spin from velocities; a force besides works on the centre.
  std::vector<double> sums    = MeanMotion::make_sums();
  double              of_both = 0;
  const Vector3       push(-40., 90., 20.);
  for (std::size_t i = 0; i < places.size(); ++i)
    {
      face.set.add(i, places[i], way[i], sums);
      of_both += face.set.force(i, at, push, moment).dot(way[i]);
    }
  const MeanMotion::Motion moving = face.set.solve(sums);
  check_below("deformed end face: spin by velocities less spin by differences [rad]",
              (moving.spin - spin).norm(),
              1e-8);
  check_ratio("deformed end face: power of force and moment over that of the mean motion",
              of_both / (push.dot(moving.velocity) + moment.dot(moving.spin)),
              1e-12);
}

void transmission()
{
  Transmission t;
  t.driver_teeth = 27;
  t.driven_teeth = 79;
  t.driver_rate  = 20000 * pi / 30;
  check_close("ratio", t.ratio(), 27. / 79, 1e-16);
  check_close("rate of the driven member [rpm]",
              t.driven_rate() * 30 / pi,
              6835.4430379746835,
              1e-10);
  check_close("mesh frequency [Hz]", t.mesh_frequency(), 9000., 1e-9);
  t.driver_rate = -t.driver_rate;
  check_close("mesh frequency, turning back [Hz]", t.mesh_frequency(), 9000., 1e-9);

  // A tooth: 100 N along - y on the driver at (60, 0, 5), so + y on the driven member, whose axis
  // is parallel to z through (10, 0, 0).
  Model model = model_of({"driver", make_block(Vector3(1., 1., 1.), {{1, 1, 1}}), Material()});
  model.add_body({"driven", make_block(Vector3(1., 1., 1.), {{1, 1, 1}}), Material()});
  model.bodies[1].axis = {Vector3(10., 0., 0.), Vector3::UnitZ()};
  ContactPair pair;
  pair.side        = "drive";
  pair.master_body = 1;
  model.contacts   = {pair};
  GroupPairResult result;
  result.slave_group         = 3;
  result.master_group        = 8;
  result.force               = Vector3(0., -100., 20.);
  result.moment              = Vector3(60., 0., 5.).cross(result.force);
  result.normal_force        = 102.;
  result.area                = .5;
  result.largest_pressure    = 310.;
  result.largest_penetration = .002;
  const ToothContact plain   = make_tooth_contact(model, 0, result);
  check_close("torque about the master's axis [N mm]", plain.torque, 5000., 1e-10);
  check("what is passed on",
        plain.contact == 0 && plain.slave_group == 3 && plain.master_group == 8 &&
          plain.force == result.force && plain.normal_force == 102. && plain.area == .5 &&
          plain.largest_pressure == 310. && plain.penetration == .002);
  t.driven_sense      = -1;
  model.transmissions = {t};
  check_close("in the drive direction of a pair [N mm]",
              make_tooth_contact(model, 0, result).torque,
              -5000.,
              1e-10);
  model.transmissions.push_back(t);
  print_refusal([&] { make_tooth_contact(model, 0, result); });
}

void energies()
{
  EnergyLedger ledger;
  ledger.kinetic             = 120;
  ledger.kinetic_relative    = 3;
  ledger.strain              = 30;
  ledger.contact             = 7;
  ledger.start               = 100;
  ledger.drive_work          = 80;
  ledger.torque_work         = -50;
  ledger.damping_loss        = 11;
  ledger.mesh_damping_uptake = 5;
  ledger.contact_loss        = 2;
  // 157 stored less 100 at the start, 18 lost, 30 received
  check_close("residual [mJ]", ledger.residual(), 45., 1e-13);
  check_close("without a scale there is no error", ledger.error(), 0., 0.);
  ledger.scale = 500;
  check_close("error", ledger.error(), .09, 1e-15);
}

int main()
{
  return run_parts({shares, surfaces, moments, power_of_a_moment, transmission, energies});
}
