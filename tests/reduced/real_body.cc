// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Exported matrices of reduced bodies, read again as another program would: a gear under a torque
// and a pinion, faster than it was reduced at, move as the bodies themselves.
#include "../parts.h"
#include "../study/gear_model.h"
#include "../study/shaft_pair.h"

#include <vfife/base/parameters/parameter_matrix.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/reduced/modal_motion.h>
#include <vfife/reduced/reduced_options.h>
#include <vfife/reduced/touch_rows.h>
#include <vfife/study/reduced/pair_reduction.h>

#include <unsupported/Eigen/MatrixFunctions>

#include <filesystem>

using namespace vfife;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const std::string folder = "exported";

MatrixXd read(const std::string &name)
{
  return read_parameter_matrix(folder + "/" + name + ".mtx");
}

/** Readings under forces that last from time zero, as a program that knows the files alone. */
VectorXd move_matrices(const std::string &body,
                       const double       rate,
                       const double       reduced_at,
                       const VectorXd    &force,
                       const double       time)
{
  const MatrixXd M = read(body + "_mass"), G = read(body + "_coriolis"),
                 K = read(body + "_stiffness") +
                     (rate * rate - reduced_at * reduced_at) * read(body + "_spin_stiffness");
  // x' = w y: balanced, or the exponential loses eight digits.
  const Eigen::Index n    = M.rows();
  const MatrixXd     inv  = M.inverse();
  const double       w    = std::sqrt((inv * K).cwiseAbs().maxCoeff());
  MatrixXd           A    = MatrixXd::Zero(2 * n + 1, 2 * n + 1);
  A.block(0, n, n, n)     = w * MatrixXd::Identity(n, n);
  A.block(n, 0, n, n)     = -inv * K / w;
  A.block(n, n, n, n)     = -2. * rate * inv * G;
  A.block(n, 2 * n, n, 1) = inv * force / w;
  const VectorXd x        = MatrixXd(time * A).exp().col(2 * n).head(n);
  return read(body + "_shapes") * x;
}

/** What a row of rows.csv reads of a body's modes and turn. */
double read_row(const std::string &name,
                const ReducedBody &body,
                const ModalMotion &motion,
                const Model       &model)
{
  std::vector<Eigen::MatrixXcd> gains;
  std::vector<Eigen::VectorXcd> coordinates;
  for (std::size_t i = 0; i < body.harmonics.size(); ++i)
    {
      gains.push_back(motion.gain(i));
      coordinates.push_back(motion.coordinates(i));
    }
  TouchRows rows(body, gains);
  rows.set_nodes({});
  const VectorXd none = VectorXd::Zero(rows.n_rows());
  if (name == "bore turn" || name == "rim turn")
    return motion.turn() + rows.read_all(body.find_reading(name), coordinates, none, {});
  const char *const components[] = {"displacement x",
                                    "displacement y",
                                    "displacement z",
                                    "stress xx",
                                    "stress yy",
                                    "stress zz",
                                    "stress xy",
                                    "stress yz",
                                    "stress zx"};
  for (unsigned int i = 0; i < 3 * body.touch_nodes.size(); ++i)
    if (name == "node " + std::to_string(body.touch_nodes[i / 3]) + " " + components[i % 3])
      return rows.displace_nodes({body.touch_nodes[i / 3]}, 0., {}, coordinates, none)[i % 3];
  for (const Probe &probe : model.probes)
    for (unsigned int c = 0; c < 9; ++c)
      if (name == probe.name + " " + components[c])
        return rows.read(body.find_reading("probe " + probe.name + " component " +
                                           std::to_string(c)),
                         body.sector_of(probe.node),
                         coordinates,
                         none,
                         {});
  for (unsigned int i = 0; i < 6 * body.rings.size(); ++i)
    if (name == body.rings.names[i / 6] + (i % 6 < 3 ? " displacement " : " turn ") + "xyz"[i % 3])
      return rows.read_ring(i / 6, 0., coordinates, none, {})[i % 6];
  check("row " + name, false);
  return 0;
}

void compare(const std::string &name,
             const ReducedBody &body,
             const Model       &model,
             const double       rate)
{
  const MatrixXd G = read(name + "_coriolis"), K = read(name + "_stiffness");
  check_below(name + ": Coriolis matrix antisymmetric",
              (G + G.transpose()).norm() / G.norm(),
              1e-12);
  check_below(name + ": stiffness symmetric", (K - K.transpose()).norm() / K.norm(), 1e-12);
  const Table coordinates = read_result_table(folder + "/" + name + "_coordinates.csv"),
              rows        = read_result_table(folder + "/" + name + "_rows.csv");
  check(name + ": a coordinate a row of the matrices",
        coordinates.n_rows() == std::size_t(K.rows()) && K.rows() > 4);

  // Modal forces on all harmonics and a torque, from time zero on.
  const double time = 4e-4;
  ModalMotion  motion(body, rate, {}, time);
  ModalForces  forces;
  VectorXd     force = 1e3 * read(name + "_torque").col(0);
  Eigen::Index first = 0;
  for (const ReducedBody::Harmonic &harmonic : body.harmonics)
    {
      const Eigen::Index n   = harmonic.n_modes();
      Eigen::VectorXcd   g   = 1e3 * harmonic.forces_of({1., 0.});
      const bool         two = harmonic.number > 0 && 2 * harmonic.number != body.n_sectors;
      for (Eigen::Index k = 0; k < n; ++k)
        {
          const std::complex<double> more(std::cos(3. * k + harmonic.number),
                                          two ? std::sin(2. * k + harmonic.number) : 0.);
          g[k] += more;
          force[first + k] += more.real();
          if (two)
            force[first + n + k] += more.imag();
        }
      forces.modes.push_back(g);
      first += two ? 2 * n : n;
    }
  forces.moment = 1e3;
  motion.advance(forces);
  const VectorXd readings = move_matrices(name, rate, body.rate, force, time);
  double         worst = 0, largest[3] = {0, 0, 0};
  const auto     kind_of = [&](const std::size_t i) {
    const std::string &unit = rows.column("unit").texts[i];
    return unit == "rad" ? 0 : unit == "mm" ? 1 : 2;
  };
  for (std::size_t i = 0; i < rows.n_rows(); ++i)
    largest[kind_of(i)] = largest_of(largest[kind_of(i)], std::abs(readings[i]));
  for (std::size_t i = 0; i < rows.n_rows(); ++i)
    raise_to(worst,
             std::abs(readings[i] -
                      read_row(rows.column("reading").texts[i], body, motion, model)) /
               largest[kind_of(i)]);
  const MatrixXd residual = read(name + "_residual");
  check_below(name + ": residual flexibility",
              (residual - body.residual[body.reach].topRows(residual.rows())).norm() /
                residual.norm(),
              1e-14);
  check(name + ": something is read", rows.n_rows() > 30 && largest[1] > 0);
  check_below(name + ": readings under forces after 0.4 ms", worst, 1e-8);
}

void exported(const std::string &pair, Communicator &world)
{
  std::filesystem::remove_all(folder);
  std::ofstream("exported.prm") << pair << "subsection Operation\n set speed = 20000 rpm\nend\n";
  const Model        model = make_gear_model("exported.prm", world);
  std::ostringstream screen;
  Log                log(screen, false);
  ReducedOptions     options;
  options.elements  = BodyElements::as_run;
  const auto bodies = reduce_pair(model,
                                  {options.store,
                                   options.reach,
                                   options.fem(StiffnessKind::incompatible_modes),
                                   60e3,
                                   1.,
                                   nullptr},
                                  world,
                                  log);
  {
    const OutputFolder results(folder, world);
    export_bodies(bodies, model, results);
  }
  compare("pinion", bodies[0], model, 1.1 * bodies[0].rate);
  compare("gear", bodies[1], model, bodies[1].rate);
  for (const ReducedBody &body : bodies)
    if (const Eigen::Index n = 6 * body.rings.n_bearings; n > 0)
      check(model.bodies[&body - bodies.data()].name() + ": springs of its bearings",
            read(model.bodies[&body - bodies.data()].name() + "_seat_stiffness").rows() == n);
}

void on_bores(Communicator &world)
{
  exported(coarse_pair("set body type = conical web", coarse_web), world);
}

void on_shafts(Communicator &world)
{
  exported(shaft_pair::pair_on_shafts(), world);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {on_bores, on_shafts});
}
