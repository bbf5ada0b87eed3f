// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// An elastic block on a floor with friction, floor a body or a rigid wall, without other damping
// than that of the contact: it slides, stops and stays as a rigid one, whatever step and mesh.
#include "../model/model_text.h"
#include "one_solver.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/mesh/body_mesh.h>

#include <Eigen/Geometry>

using namespace vfife;

constexpr double mu = 0.3, length = 20., width = 10., height = 4.;      // [-], [mm]
constexpr double area = length * width, mass = area * height * 7.85e-9; // [mm^2], [t]
constexpr double press = 50.;                                           // [N]

struct Case
{
  bool         on_wall;
  double       safety  = 0.9;
  unsigned int cells   = 4;  ///< of the length: half as many of the width, a quarter of the height
  double       penalty = 0.; ///< [N/mm^3]; 0: the default
  double       slope   = 0.; ///< of the floor, falling along x [deg]
  double       speed   = 0.; ///< at the start, along x [mm/s]
  std::string  entries = {}; ///< of the contact

  std::string name() const
  {
    std::ostringstream text;
    text << (on_wall ? "on a wall, " : "on a body, ") << safety << " of the step, " << cells
         << " cells" << (penalty > 0. ? ", soft: " : ": ");
    return text.str();
  }

  Matrix3 axes() const
  {
    return Eigen::AngleAxisd(slope * pi / 180., Vector3::UnitY()).toRotationMatrix();
  }

  /** Normal stiffness of the whole face [N/mm]: 5 E* over the width of a facet. */
  double stiffness() const
  {
    return (penalty > 0. ? penalty : 5. * 2e5 / .91 * cells / length) * area;
  }

  /** @p loads: a section each, of the name that it begins with. */
  Model model(const std::vector<std::string> &loads) const
  {
    const auto block = [this](const std::string &name,
                              const Vector3     &size,
                              const unsigned int n,
                              const Vector3     &corner,
                              const double       velocity) {
      const Eigen::IOFormat row(17, Eigen::DontAlignCols, ", ", ", ");
      std::ostringstream    text;
      text.precision(17);
      text << "  subsection Body " << name << "\n    set mesh = block\n    set size x = " << size[0]
           << " mm\n    set size y = " << size[1] << " mm\n    set size z = " << size[2]
           << " mm\n    set elements x = " << n << "\n    set elements y = " << n / 2
           << "\n    set elements z = " << n / 4
           << "\n    set position = " << (axes() * corner).transpose().format(row)
           << " mm\n    set rotation axis = 0, 1, 0\n    set rotation angle = " << slope
           << " deg\n    set velocity = " << velocity << ", 0, 0 mm/s\n  end\n";
      return text.str();
    };
    const Vector3      normal = axes().col(2);
    std::ostringstream text;
    text.precision(17);
    text << "subsection Model\n  set bodies = block" << (on_wall ? "" : ", floor")
         << "\n  set contacts = face\n  set loads = ";
    for (std::size_t i = 0; i < loads.size(); ++i)
      text << (i > 0 ? ", " : "") << loads[i].substr(0, loads[i].find('\n'));
    text << "\n" << block("block", {length, width, height}, cells, Vector3::Zero(), speed);
    if (!on_wall)
      text << "  set constraints = rest\n"
           << block("floor", {34, 20, 4}, 6, {-5, -5, -4}, 0.)
           << "  subsection Constraint rest\n    set kind = fixed\n    set body = floor\n"
              "    set nodes = all\n  end\n";
    text << "  subsection Contact face\n    set friction coefficient = " << mu
         << "\n    set penalty = " << penalty << "\n"
         << entries;
    if (on_wall)
      text << "    set kind = wall\n    set body = block\n    set nodes = z-\n"
              "    set wall normal = "
           << normal[0] << ", " << normal[1] << ", " << normal[2] << "\n";
    else
      text << "    set slave body = block\n    set slave surface = z-\n"
              "    set master body = floor\n    set master surface = z+\n";
    text << "  end\n";
    for (const std::string &load : loads)
      text << "  subsection Load " << load << "    set body = block\n  end\n";
    text << "end\n";
    return make_model(text.str());
  }
};

/** Displacement of the block's lower face, mean by mass, along the floor's axes. */
Vector3 mean_way(const Case &example, const Model &model, const State &state)
{
  Vector3     sum   = Vector3::Zero();
  double      all   = 0;
  const Body &block = model.bodies[0];
  for (const unsigned int node : block.node_set("z-"))
    {
      const double m = block.node_masses()[node];
      sum += m * (state.node_position(state.partition->local_node[node]) -
                  block.placement(block.node_positions()[node]));
      all += m;
    }
  return example.axes().transpose() * sum / all;
}

/** Of the steps after @p from [s]. */
struct Run
{
  Vector3              way   = Vector3::Zero();
  Vector3              force = Vector3::Zero(); ///< sum over the steps, on the block
  double               error = 0;               ///< energy
  unsigned int         steps = 0, open = 0;     ///< open: nothing presses
  std::vector<Vector3> ways;
};

Run run(const Case                     &example,
        const std::vector<std::string> &loads,
        const double                    from,
        const double                    end)
{
  const Model     model   = example.model(loads);
  DynamicsOptions options = undamped();
  options.safety          = example.safety;
  OneSolver solver(model, options);
  Run       result;
  auto      observers = watch(1, [&](const State &state) {
    if (!(state.time > from))
      return;
    const Vector3 force = example.axes().transpose() * state.measured.contact_forces.at(0);
    result.force += force;
    raise_to(result.error, std::abs(state.measured.energy.error()));
    ++result.steps;
    result.open += force[2] > 0 ? 0 : 1;
    result.way = mean_way(example, model, state);
    result.ways.push_back(result.way);
  });
  solver.solver.run(solver.state, end, observers);
  return result;
}

std::string force_load(const std::string &name, const Vector3 &force, const std::string &history)
{
  std::ostringstream text;
  text << name << "\n    set nodes = z-\n    set force = " << force[0] << ", " << force[1] << ", "
       << force[2] << " N\n    set history = " << history << "\n";
  return text.str();
}

std::string acceleration_load(const double along_z)
{
  std::ostringstream text;
  text << "weight\n    set kind = acceleration\n    set nodes = all\n    set acceleration = 0, 0, "
       << along_z << " mm/s^2\n";
  return text.str();
}

const std::string press_load = force_load("press", {0, 0, -press}, "min(t/4e-4,1)");

void check_contact(const std::string &name, const Run &found)
{
  check_ratio(name + "mean friction over mu times the mean normal force",
              found.force.head<2>().norm() / (mu * found.force[2]),
              0.004);
  check_below(name + "part of the steps without contact",
              static_cast<double>(found.open) / found.steps,
              0.01);
  check_below(name + "energy error", found.error, 1e-3);
}

/** Pushed by more than friction holds, after 0.5 ms, by a force that is there at once. */
void pushed(const Case &example, const Vector3 &direction)
{
  const double start = 5e-4, end = 2e-3, push = 20., limit = mu * press;
  const Run    found =
    run(example, {press_load, force_load("push", push * direction, "if(t<5e-4,0,1)")}, start, end);
  // A rigid block swings on the springs that stick until these have mu N, then slides.
  const double k = example.stiffness(), omega = std::sqrt(k / mass);
  const double angle = std::acos(1. - limit / push);
  const double time  = end - start - angle / omega;
  const double way   = limit / k + push / k * omega * std::sin(angle) * time +
                     .5 * (push - limit) / mass * time * time;
  const std::string name = example.name();
  // What is left of the vibrations lets finer blocks stick now and then (doc/theory/contact.md).
  check_ratio(name + "pushed, way over that of a rigid block",
              found.way.dot(direction) / way,
              example.cells > 4 ? 0.015 : 0.01);
  check_below(name + "pushed, way across over that along",
              found.way.cross(direction)[2] / way,
              example.cells > 4 ? 0.01 : 0.003);
  check_contact(name + "pushed, ", found);
}

/** By its weight down a slope, from rest: g (sin - mu cos). */
void slides_down(Case example)
{
  example.slope        = 30.;
  const double gravity = 9810., end = 4e-3, s = example.slope * pi / 180.;
  const Run    found = run(example, {acceleration_load(-gravity)}, 1e-4, end);
  check_ratio(example.name() + "slides down, way over g (sin - mu cos) t^2/2",
              found.way[0] / (gravity * (std::sin(s) - mu * std::cos(s)) * end * end / 2.),
              0.01);
  check_below(example.name() + "slides down, energy error", found.error, 1e-3);
}

/** Thrown along the floor: stops after v^2/(2 mu g) and stays. */
void stops(Case example)
{
  example.speed  = 2000.;
  const double g = press / mass, way = example.speed * example.speed / (2. * mu * g);
  const Run    found = run(example, {acceleration_load(-g)}, 0., 4. * way / example.speed);
  check_ratio(example.name() + "stops, way over v^2/(2 mu g)", found.way[0] / way, 0.01);
  check_below(example.name() + "stops, energy error", found.error, 1e-3);
}

/** Thrown along the floor with friction that grows as it slows down: the way is the integral of
 * v dv/(g mu(v)). */
void stops_by_decay(Case example, const std::string &entries)
{
  constexpr double   mu_s = 0.5, decay = 500., g = press / mass; // [-], [mm/s], [mm/s^2]
  constexpr unsigned n   = 1000;
  double             way = 0.;
  example.speed          = 2000.;
  for (unsigned int i = 0; i < n; ++i)
    {
      const double v = example.speed * (i + .5) / n;
      way += v * example.speed / n / (g * (mu + (mu_s - mu) * std::exp(-v / decay)));
    }
  const auto entries_for = [&](const double at_rest) {
    std::ostringstream text;
    text << "    set friction law = exponential decay\n    set static friction coefficient = "
         << at_rest << "\n    set friction decay speed = " << decay << " mm/s\n"
         << entries;
    return text.str();
  };
  const auto thrown = [&](const std::string &of_contact, const double time) {
    example.entries = of_contact;
    return run(example, {acceleration_load(-g)}, 0., time);
  };
  const double      time  = 4. * way / example.speed;
  const Run         found = thrown(entries_for(mu_s), time);
  const std::string name =
    example.name() + "decaying friction" + (entries.empty() ? "" : ", explicit contact") + ", ";
  check_ratio(name + "way over the integral of v/(g mu(v))", found.way[0] / way, 0.01);
  check_below(name + "energy error", found.error, 1e-3);
  check(name + "mu_s = mu_k: Coulomb's friction to the last digit",
        thrown(entries_for(mu), .2 * time).ways == thrown(entries, .2 * time).ways);
}

/** Pushed by less than friction holds: it stays, whatever vibrates. */
void sticks(const Case &example)
{
  const double push = 10., start = 1e-3;
  const Run    found = run(example,
                        {press_load, force_load("push", {push, 0, 0}, "min(max(t-5e-4,0)/2e-4,1)")},
                        start,
                        2e-3);
  // Mean ways of the first and the last fifth.
  const std::size_t part  = found.ways.size() / 5;
  double            first = 0, last = 0;
  for (std::size_t i = 0; i < part; ++i)
    {
      first += found.ways[i][0] / part;
      last += found.ways[found.ways.size() - 1 - i][0] / part;
    }
  check_below(example.name() + "sticks, creep over the elastic way",
              (last - first) / (push / example.stiffness()),
              0.01);
  check_ratio(example.name() + "sticks, mean friction over the push",
              -found.force[0] / found.steps / push,
              0.01);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  for (const bool on_wall : {false, true})
    {
      for (const double safety : {0.9, 0.3, 0.1})
        pushed({on_wall, safety}, Vector3::UnitX());
      pushed({on_wall, 0.3, 8}, Vector3(.6, -.8, 0));
      for (const double safety : {0.9, 0.3})
        pushed({on_wall, safety, 4, 5000.}, Vector3::UnitX());
      slides_down({on_wall});
      stops({on_wall});
      stops_by_decay({on_wall}, "");
      if (!on_wall)
        stops_by_decay({on_wall}, "    set integration = explicit\n");
      sticks({on_wall});
    }
  return 0;
}
