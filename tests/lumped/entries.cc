// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Section Lumped: what its entries make of the model and of the run.
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/lumped/lumped_options.h>
#include <vfife/lumped/lumped_solver.h>

#include <deal.II/base/parameter_handler.h>

#include <fstream>

using namespace vfife;

struct Read
{
  LumpedOptions    options;
  LumpedRunOptions run;

  /** @p lines of the section, and more of the file. */
  explicit Read(const std::string &lines,
                const std::string &more     = "",
                const std::string &backlash = "90 um",
                const std::string &mesh     = "set stiffness = 2 MN m/rad")
  {
    std::ofstream("lumped.prm") << R"(subsection Lumped
  set pinion teeth = 27
  set gear teeth   = 79
  set gear inertia = 20000 kg mm^2
  set lever arm    = 90 mm
  set backlash     = )" << backlash
                                << "\n"
                                << mesh << "\n"
                                << lines << "end\n"
                                << more;
    const ParameterFile      file("lumped.prm");
    dealii::ParameterHandler prm;
    options.declare(prm, file);
    {
      Subsection section(prm, "Lumped");
      run.declare(prm);
    }
    file.read(prm);
    options.check();
  }

  /** At 800 N m. */
  LumpedPair pair() const
  {
    return options.make_pair(8e5);
  }
};

void series()
{
  const LumpedPair pair = Read("set stiffness cosines = 0.1, 0.02\nset stiffness sines = 0, 0.05\n"
                               "set error cosines = 4\nset error sines = -3 arcsec, 0.001 deg\n")
                            .pair();
  for (const double x : {0., .1, .37})
    {
      const double a = 2 * pi * x;
      check_close("stiffness over the mesh cycle [N mm/rad]",
                  pair.law.stiffness.value(x) / 2e9,
                  1 + .1 * std::cos(a) + .02 * std::cos(2 * a) + .05 * std::sin(2 * a),
                  1e-14);
      check_close("transmission error without load [rad]",
                  pair.law.unloaded_error.value(x),
                  (4 * std::cos(a) - 3 * std::sin(a)) * arcsecond +
                    3.6 * arcsecond * std::sin(2 * a),
                  1e-18);
    }
  check_close("backlash: turn of the gear [rad]", pair.law.backlash, 1e-3, 1e-17);
}

/** Torque where the flanks have moved back by half of what they are pressed together at 800 N m,
 * 55 arcsec, with the tangent of 3.8 MN m/rad there. */
void load_laws()
{
  std::ofstream("table.csv")
    << "position [mesh cycles],unloaded transmission error [arcsec],transmission error "
       "[arcsec],contact torque on the gear [N m],tangent stiffness [N m/rad]\n"
       "0,1,-54,800,3.8e6\n0.5,-1,-56,800,3.8e6\n";
  const double pressed = 55 * arcsecond, tangent = 3.8e9, torque = 8e5;
  for (const std::string &law :
       {std::string("power"), std::string("tangent"), std::string("secant")})
    {
      const LumpedPair pair = Read("set load law = " + law + "\n",
                                   "",
                                   "90 um",
                                   "set mesh = loaded contact\nset table = table.csv")
                                .pair();
      const double compression = pair.law.compression(torque, 0.);
      const double expected    = law == "power"    ? std::pow(.5, tangent * pressed / torque)
                                 : law == "secant" ? .5
                                                   : 1 - tangent * pressed / 2 / torque;
      check_close("load law " + law + ": torque half way back over 800 N m",
                  pair.law.torque(compression - pressed / 2, 0.) / torque,
                  expected,
                  1e-10);
    }
}

void inertias()
{
  const LumpedModel model(Read("set pinion = free\nset pinion inertia = 800 kg mm^2\n").pair());
  // Both members for the swing: 1/J = 1/J2 + (z1/z2)^2/J1.
  const double ratio = 27. / 79, inertia = 1 / (1 / 20. + ratio * ratio / .8);
  check_ratio("pinion inertia: of the swing", model.swing_inertia() / inertia, 1e-14);
  check_ratio("pinion inertia: frequency", model.swing_rate() / std::sqrt(2e9 / inertia), 1e-12);
  print_refused_entry([] { Read("set pinion = free\n").pair(); });
}

void supports()
{
  const LumpedPair pair = Read(R"(set contact normal = 0, 3, 4
set contact point = 10, 90, 40 mm
set supports = axial, tilt
subsection Support axial
  set direction = 0, 0, 2
  set mass = 2 kg
  set stiffness = 1e6
end
subsection Support tilt
  set member = pinion
  set motion = tilt
  set direction = 1, 0, 0
  set centre = 0, 0, 100
  set inertia = 9000
  set tilt stiffness = 1 MN m/rad
  set damping ratio = 0.05
end
)")
                            .pair();
  // What unit motions along the normal (0, 0.6, 0.8) do at the contact point, over the arm.
  check_close("contact normal: lever of a displacement [1/mm]",
              pair.supports[0].lever,
              .8 / 90,
              1e-16);
  // e_x x (10, 90, -60) = (0, 60, 90)
  check_close("contact point: lever of a tilt",
              pair.supports[1].lever,
              -(.6 * 60 + .8 * 90) / 90,
              1e-14);
  check("damping ratio: of its own support",
        pair.supports[1].damping_ratio == .05 && pair.supports[0].damping_ratio != .05);
  // kg, N/mm; kg mm^2, MN m/rad
  check_close("mass [t]", pair.supports[0].inertia, 2e-3, 1e-18);
  check_close("stiffness [N/mm]", pair.supports[0].stiffness, 1e6, 1e-9);
  check_close("inertia [t mm^2]", pair.supports[1].inertia, 9., 1e-15);
  check_close("tilt stiffness [N mm/rad]", pair.supports[1].stiffness, 1e9, 1e-6);
  check("motion: which one tilts", !pair.supports[0].tilts && pair.supports[1].tilts);
}

/** What is given as it stands, in internal units. */
void numbers()
{
  const LumpedPair pair =
    Read("set driven speed damping = 120\nset damping ratio = 0.07\nset pinion inertia = 800\n")
      .pair();
  check("teeth", pair.driver_teeth == 27 && pair.driven_teeth == 79 && pair.ratio() == 27. / 79);
  check_close("torque [N mm]", pair.torque, 8e5, 0.);
  check_close("gear inertia [t mm^2]", pair.driven_inertia, 20., 1e-14);
  check_close("pinion inertia [t mm^2]", pair.driver_inertia, .8, 1e-15);
  check_close("arm [mm]", pair.arm, 90., 0.);
  check_close("speed damping [1/s]", pair.speed_damping, 120., 0.);
  check_close("damping ratio", pair.damping_ratio, .07, 0.);
  check("pinion: prescribed unless free",
        !pair.driver_is_free &&
          Read("set pinion = free\nset pinion inertia = 1\n").pair().driver_is_free);
}

/** Of a table: 800 N m wind the gear up by 55 arcsec at both positions. */
void laws_of_a_table()
{
  std::ofstream("table.csv")
    << "position [mesh cycles],unloaded transmission error [arcsec],transmission error [arcsec],"
       "contact torque on the gear [N m],tangent stiffness [N m/rad]\n"
       "0,1,-54,800,3.8e6\n0.5,-1,-56,800,3.7e6\n";
  const double secant = 8e5 / (55 * arcsecond);
  for (const std::string law : {"power", "tangent", "secant"})
    {
      const LumpedPair pair =
        Read("set mesh = loaded contact\nset table = table.csv\nset load law = " + law + "\n")
          .pair();
      for (const double x : {0., .5})
        {
          const double tangent = x == 0 ? 3.8e9 : 3.7e9, touch = x == 0 ? arcsecond : -arcsecond;
          check_ratio("load law " + law + ": stiffness",
                      pair.law.stiffness.value(x) / (law == "tangent" ? tangent : secant),
                      1e-12);
          check_close("load law " + law + ": exponent",
                      pair.law.exponent.value(x),
                      law == "power" ? tangent / secant : 1.,
                      1e-12);
          // The tangent meets no torque where it would, not where the flanks touch.
          check_close("load law " + law + ": error without load [rad]",
                      pair.law.unloaded_error.value(x),
                      law == "tangent" ? touch - 55 * arcsecond + 8e5 / tangent : touch,
                      1e-18);
        }
    }
}

void damper()
{
  for (const bool always : {false, true})
    {
      const LumpedModel model(Read(std::string("set damping ratio = 0.05\n") +
                                   "set damping without contact = " + (always ? "yes" : "no") +
                                   "\n")
                                .pair());
      Eigen::VectorXd   q = model.find_equilibrium(0.), v = q;
      // In the middle of the play of 1 mrad, where no flank touches: the damper alone.
      q[0] += model.compression(q, 0.) + .5e-3;
      v[0]                 = .1;
      const double torque  = model.compute_rates(q, v, 0., 1000.).mesh_torque;
      const double dashpot = 2 * .05 * std::sqrt(2e9 * 20.);
      check_close(always ? "the damper acts where flanks are apart [N mm]" : "it does not [N mm]",
                  torque,
                  always ? -.1 * dashpot : 0.,
                  1e-9 * dashpot);
    }
}

/** Swing about the equilibrium of a linear pair without damping, over five periods. */
double swing_error(const std::string &tolerance, const std::string &per_mesh, unsigned int &samples)
{
  const Read        read("",
                  R"(
subsection Lumped
  set damping ratio   = 0
  set settling mesh cycles = 0
  set recorded mesh cycles = 5
  set tolerance       = )" +
                    tolerance + "\n  set samples per mesh cycle = " + per_mesh + "\nend\n",
                  "10 mm");
  const LumpedModel model(read.pair());
  LumpedSolver      solver(model, read.run);
  Eigen::VectorXd   q = model.find_equilibrium(0.), v = Eigen::VectorXd::Zero(1);
  const double      rest = q[0], swing = .2 * 8e5 / 2e9;
  q[0] += swing;
  solver.set_motion(q, v);
  double largest = 0;
  samples        = 0;
  solver.run(model.swing_rate() / (2 * pi), [&](const LumpedSolver::Sample &s) {
    raise_to(largest, std::abs((s.q[0] - rest) / swing - std::cos(model.swing_rate() * s.time)));
    ++samples;
  });
  return largest;
}

void run()
{
  unsigned int n    = 0;
  const double fine = swing_error("1e-11", "16", n);
  check("samples: 16 in each of 5 mesh cycles", n == 5 * 16);
  // Few samples, so that they do not cut the steps.
  const double rough = swing_error("1e-4", "4", n);
  check("samples: 4 in each", n == 5 * 4);
  // The error of a step is relative to the static deflection, of which the swing is a fifth.
  check_below("tolerance: a fine one", fine, 1e-8);
  check_below("tolerance: a rough one", rough, 2e-2);
  check("tolerance: the rough one shows", rough > 1e-6);
}

int main()
{
  return run_parts({series, load_laws, inertias, supports, numbers, laws_of_a_table, damper, run});
}
