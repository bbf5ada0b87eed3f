// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Waves of stress over the sectors: amplitudes of made-up ones at probes and in fillets, their
// largest over a period against closed forms; what is refused.
#include "../../parts.h"
#include "../../refusal.h"
#include "../gear_model.h"
#include "../quick_pair.h"

#include <vfife/base/types.h>
#include <vfife/study/stress_waves/stress_wave_places.h>

using namespace vfife;

/** Two waves at once and a mean. */
double wave(const Complex &three, const Complex &five, const unsigned int sector)
{
  const double angle = 2. * pi * sector / 79.;
  return 7. + (three * std::exp(3. * imaginary_unit * angle)).real() +
         (five * std::exp(5. * imaginary_unit * angle)).real();
}

std::string text()
{
  return coarse_pair("set body type = conical web", coarse_web) +
         "subsection Operation\n  set speed = 8000 rpm\n  set torque = 800 N m\nend\n";
}

void amplitudes(Communicator &world)
{
  const Model   model = make_gear_model("stress_waves.prm", text(), world);
  FilletOptions options;
  options.teeth = RecordedTeeth::all;
  const RootStress       roots(model, options);
  const StressWavePlaces places(model, &roots);
  check("two probes and two fillets", places.n_probes() == 2 && places.names().size() == 4);

  // Of the component c 1 + c times as large, of the second probe twice as large.
  const unsigned int per_sector =
    model.bodies[model.only_transmission()->driven].structure().nodes_per_sector();
  const Complex      three(2., -1.), five(.3, 4.);
  unsigned int       n_measured = 0;
  const ProbeMeasure probes     = [&](const std::vector<Probe> &copies) {
    std::vector<ProbeValue> values;
    ++n_measured;
    for (const Probe &copy : copies)
      {
        ProbeValue value;
        for (unsigned int c = 0; c < 6; ++c)
          value.stress[c] = (1 + c) * n_measured * wave(three, five, copy.node / per_sector);
        values.push_back(value);
      }
    return values;
  };
  FilletStrains strains;
  strains.facet =
    [&](const MemberFillet &, const unsigned int column, unsigned int, const unsigned int tooth) {
      const double value = (1 + column) * wave(three, five, tooth);
      return SurfaceTensor(value, 2. * value, 3. * value);
    };
  const StressWaves found = places.measure(3, probes, &strains);
  double            worst = 0;
  for (unsigned int p = 0; p < 2; ++p)
    for (unsigned int c = 0; c < 6; ++c)
      worst = std::max(worst, std::abs(found.probes[p][c] - (1. + c) * (1. + p) * three));
  check_below("amplitudes at probes", worst, 1e-11);
  worst                = 0;
  const Fillet &fillet = places.fillets()[0]->fillet;
  const auto    n_rows = fillet.end_row() - Fillet::first_row;
  check("facets of a fillet", found.fillets[0].size() == fillet.n_columns() * n_rows);
  for (unsigned int facet = 0; facet < found.fillets[0].size(); ++facet)
    for (unsigned int c = 0; c < 3; ++c)
      worst =
        std::max(worst,
                 std::abs(found.fillets[0][facet][c] - (1. + c) * (1. + facet / n_rows) * three));
  check_below("in a fillet", worst, 1e-11);
  n_measured = 0;
  check_below("the other one of the two",
              std::abs(places.measure(5, probes, nullptr).probes[0][0] - five),
              1e-11);
  check("nothing of fillets without their strains",
        places.measure(5, nullptr, nullptr).fillets[0][0][0] == 0.);
}

void largest(Communicator &world)
{
  const Model   model = make_gear_model("stress_waves.prm", text(), world);
  FilletOptions options;
  options.teeth = RecordedTeeth::all;
  const RootStress       roots(model, options);
  const StressWavePlaces places(model, &roots);
  StressWaves            waves = places.none();
  // Shear; two normal stresses a quarter of a period apart: (cos^2 + cos sin + sin^2) 25 is 37.5
  // at 45 degrees. Strain along one direction: E/(1 - nu^2).
  waves.probes[0][3]         = Complex(3., 4.);
  waves.probes[1][0]         = 5.;
  waves.probes[1][1]         = 5. * imaginary_unit;
  waves.fillets[0].back()[0] = 1e-4 * imaginary_unit;
  const Material &material   = model.bodies[model.only_transmission()->driven].materials().front();
  const double    nu         = material.poissons_ratio;
  const std::vector<double> most = places.find_largest(waves);
  check_close("shear, sqrt(3) of its amplitude", most[0], std::sqrt(3.) * 5., 5e-3);
  check_close("normal stresses apart in time", most[1], std::sqrt(37.5), 1e-12);
  check_ratio("strain of a fillet",
              most[2] * (1. - nu * nu) / (material.youngs_modulus * 1e-4),
              1e-12);
  check("nothing in the other one", most[3] == 0.);
  // Half a period apart and as large.
  StressWaves sum = places.none();
  sum.add(waves, 2. * imaginary_unit);
  sum.add(waves, -imaginary_unit);
  check_close("a sum", places.find_largest(sum)[1], std::sqrt(37.5), 1e-12);
}

void refusals(Communicator &world)
{
  std::ofstream("stress_waves_run.prm") << text() << "subsection Study\n  set kind = run\nend\n";
  for (const char *diameters : {"4, 11", "-1", "4, 4"})
    print_refusal([&]() {
      run_pair("stress_waves_run.prm",
               "refused",
               world,
               {"Output/stress wave diameters=" + std::string(diameters)});
    });
  print_refusal([&]() {
    run_pair(tree_folder() + "/prm/verification/free_spin.prm",
             "refused",
             world,
             {"Output/stress wave diameters=3"});
  });
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {amplitudes, largest, refusals});
}
