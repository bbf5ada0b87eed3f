// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Flanks and fillets of the paper's pair against independently computed points and normals:
// make_reference.py writes the tables beside this file.
#include "../refusal.h"
#include "../tests.h"
#include "paper_pair.h"

#include <fstream>
#include <map>
#include <sstream>

using namespace vfife;

struct Row
{
  std::string         flank;
  std::vector<double> numbers;
};

std::vector<Row> read(const std::string &name)
{
  std::ifstream    file(source_folder() + "/" + name);
  std::vector<Row> rows;
  std::string      line, word;
  std::getline(file, line);
  while (std::getline(file, line))
    {
      std::istringstream words(line);
      Row                row;
      std::getline(words, row.flank, ',');
      while (std::getline(words, word, ','))
        row.numbers.push_back(std::stod(word));
      rows.push_back(row);
    }
  return rows;
}

double distance(const std::vector<double> &numbers, const unsigned int first, const Vector3 &v)
{
  return (Vector3(numbers[first], numbers[first + 1], numbers[first + 2]) - v).norm();
}

void check_reference(const std::string      &name,
                     const Flank            &flank,
                     const std::vector<Row> &flank_rows,
                     const std::vector<Row> &fillet_rows)
{
  double position = 0, normal = 0, parameters = 0, fillet = 0, fillet_normal = 0;
  for (const Row &row : flank_rows)
    if (row.flank == name)
      {
        const auto          &n     = row.numbers; // i,j,L,h,t,phi,s,x,y,z,nx,ny,nz
        const GeneratedPoint point = flank.point_at(n[2], n[3]);
        raise_to(position, distance(n, 7, point.position));
        raise_to(normal, distance(n, 10, point.normal));
        raise_to(parameters, distance(n, 4, {point.t, point.phi, point.s}));
      }
  for (const Row &row : fillet_rows)
    if (row.flank == name)
      {
        const auto          &n     = row.numbers; // L,lambda,t,phi,x,y,z,nx,ny,nz
        const GeneratedPoint point = flank.fillet_at(n[0], n[1]);
        raise_to(fillet, distance(n, 4, point.position));
        raise_to(fillet_normal, distance(n, 7, point.normal));
      }
  // the tables are rounded to 1e-9 mm in positions and in h, 1e-12 in normals
  check_below(name + " position [mm]", position, 1e-8);
  check_below(name + " normal", normal, 1e-9);
  check_below(name + " t, phi, s", parameters, 1e-8);
  check_below(name + " fillet position [mm]", fillet, 1e-8);
  check_below(name + " fillet normal", fillet_normal, 1e-10);
}

void check_consistency(const std::string &name, const Flank &flank)
{
  // central differences: 1e-5 leaves about 1e-9 of truncation and round-off
  const double             e       = 1e-5;
  const GeneratedPoint     middle  = flank.point_at(116.49, 0.);
  const SurfaceDerivatives surface = flank.derivatives(middle.t, middle.phi);
  const auto               by      = [&](const double dt, const double dphi, const bool of_normal) {
    const GeneratedPoint up   = flank.evaluate(middle.t + dt, middle.phi + dphi);
    const GeneratedPoint down = flank.evaluate(middle.t - dt, middle.phi - dphi);
    return Vector3(
      (of_normal ? Vector3(up.normal - down.normal) : Vector3(up.position - down.position)) /
      (2 * e));
  };
  const double derivative = largest_of({(by(e, 0, false) - surface.position_t).norm(),
                                        (by(0, e, false) - surface.position_phi).norm(),
                                        (by(e, 0, true) - surface.normal_t).norm(),
                                        (by(0, e, true) - surface.normal_phi).norm()});
  check_below(name + " derivatives [mm/rad]", derivative, 1e-6);

  // the flank is tangent to its normal and joins the fillet without a kink
  check_below(name + " normal is normal [mm/rad]",
              largest_of(std::abs(surface.position_t.dot(surface.point.normal)),
                         std::abs(surface.position_phi.dot(surface.point.normal))),
              1e-11);
  const GeneratedPoint end   = flank.fillet_at(116.49, pi / 2 - flank.settings().blade_angle);
  const Vector2        L_h   = flank.cone_coordinates(end.position);
  const GeneratedPoint start = flank.point_at(L_h[0], L_h[1]);
  check_below(name + " joint with the fillet [mm]", (end.position - start.position).norm(), 1e-10);
  check_below(name + " joint normal", (end.normal - start.normal).norm(), 1e-10);
  check_close(name + " joint at the blade's straight start [mm]",
              start.s,
              flank.straight_start(),
              1e-9);
}

int main()
{
  const GearPair                     pair(paper::options());
  const std::map<std::string, Flank> flanks = {
    {"gear convex", pair.gear().generated_flank(FlankSide::convex)},
    {"gear concave", pair.gear().generated_flank(FlankSide::concave)},
    {"pinion convex", pair.pinion().generated_flank(FlankSide::convex)},
    {"pinion concave", pair.pinion().generated_flank(FlankSide::concave)}};
  const std::vector<Row> flank_rows  = read("flank_reference.csv");
  const std::vector<Row> fillet_rows = read("fillet_reference.csv");
  check("180 flank and 60 fillet points", flank_rows.size() == 180 && fillet_rows.size() == 60);

  for (const auto &named : flanks)
    {
      check_reference(named.first, named.second, flank_rows, fillet_rows);
      check_consistency(named.first, named.second);
    }

  // mean spiral angles of the gear, to the digits given; 30 deg is the design value
  const auto spiral = [&](const std::string &name) {
    return flanks.at(name).spiral_angle(flanks.at(name).point_at(116.49, 0.)) / degree;
  };
  check_close("spiral angle of the gear's concave flank [deg]",
              spiral("gear concave"),
              29.999,
              0.0005);
  check_close("spiral angle of the gear's convex flank [deg]",
              spiral("gear convex"),
              29.995,
              0.0005);

  const std::string text = message_of([&] { flanks.at("pinion concave").point_at(116.49, -60.); });
  check("no flank far below the root: the message names flank, L and h",
        has_text(text, "concave flank") && has_text(text, "116.49") && has_text(text, "-60"));
  return 0;
}
