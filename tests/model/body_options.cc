// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies of a parameter file: shapes, material, place, bearing and motion at time zero; refusals.
#include "../parts.h"
#include "model_text.h"

using namespace vfife;

std::string body(const std::string &entries, const std::string &rest = "")
{
  return "subsection Model\n  set bodies = part\n  subsection Body part\n" + entries +
         "\n  end\nend\n" + rest;
}

/** Area of the polygon of n corners on the unit circle. */
double polygon(const unsigned int n)
{
  return .5 * n * std::sin(2 * pi / n);
}

void check_shape(const std::string &name,
                 const std::string &entries,
                 const unsigned int elements,
                 const double       volume,
                 const double       tolerance)
{
  const Model model = make_model(body("set mesh = " + name + "\n" + entries));
  const Body &made  = model.bodies.front();
  check(name + ": elements", made.n_elements() == elements);
  check_ratio(name + ": mass over density and volume", made.mass() / (7.85e-9 * volume), tolerance);
}

void shapes()
{
  check_shape("block",
              "set size x = 0.01 m\nset size y = 2\nset size z = 3\nset elements x = 2\n"
              "set elements y = 1\nset elements z = 3\n",
              6,
              60.,
              1e-13);
  check_shape("beam",
              "set length = 50\nset width = 2\nset height = 3\nset elements along length = 5\n"
              "set elements across width = 1\nset elements over height = 2\n",
              10,
              300.,
              1e-13);
  check_shape("ring",
              "set inner radius = 5\nset outer radius = 7\nset height = 2\n"
              "set radial elements = 2\nset elements around = 30\nset axial elements = 1\n",
              60,
              2 * 24 * polygon(30),
              1e-12);
  // Circles are divided by four times the cells across the core.
  check_shape("cylinder",
              "set radius = 8\nset height = 5\nset core elements = 6\n"
              "set radial elements = 2\nset axial elements = 3\n",
              (36 + 24 * 2) * 3,
              5 * 64 * polygon(24),
              1e-12);
  check_shape("disc",
              "set radius = 20\nset thickness = 2.5\nset core elements = 4\n"
              "set radial elements = 5\nset axial elements = 1\n",
              16 + 16 * 5,
              2.5 * 400 * polygon(16),
              1e-12);
  // Cubes of the surface are 15 degrees wide.
  check_shape("sphere",
              "set radius = 3\nset core elements = 6\nset radial elements = 2\n",
              216 + 6 * 36 * 2,
              4. / 3 * pi * 27,
              .03);
  const Model disc = make_model(body("set mesh = disc\nset thickness = 2.5\n"));
  double      low = 0, high = 0;
  for (const Vector3 &X : disc.bodies[0].node_positions())
    {
      low = std::min(low, X[2]);
      raise_to(high, X[2]);
    }
  check("disc: about z = 0", low == -1.25 && high == 1.25);
}

void material()
{
  const Model model = make_model(R"(
subsection Model
  set bodies = part
  subsection Body part
    set material = brass
  end
end
subsection Material brass
  set density = 8.5 g/cm^3
  set Young's modulus = 100 GPa
  set Poisson's ratio = 0.35
end
)");
  const Body &made  = model.bodies.front();
  check("material: its name", made.materials().front().name == "brass");
  check_close("material: mass of 1 cm^3 [kg]", 1e3 * made.mass(), .0085, 1e-15);
  check_close("material: shear modulus [MPa]", made.materials().front().mu(), 1e5 / 2.7, 1e-9);
}

void placed()
{
  const Model model =
    make_model(body("set position = 0.01, 0.02, 0.03 m\nset rotation axis = 0, 2, 0\n"
                    "set rotation angle = 90 deg\n"));
  const Body   &made = model.bodies.front();
  const Vector3 x    = made.placement(Vector3(4., 5., 6.));
  check_below("turned about y, then moved [mm]", (x - Vector3(16., 25., 26.)).norm(), 1e-13);
  check_below("free: its axis goes through the centre of mass [mm]",
              (made.axis.point - made.placement(Vector3(5., 5., 5.))).norm(),
              1e-12);
  const Axis axis =
    make_model(body("set axis point = 1, 2, 3\nset axis direction = 0, 3, 4\n")).bodies[0].axis;
  check_below("free: the axis that is given",
              (axis.point - Vector3(1., 2., 3.)).norm() +
                (axis.direction - Vector3(0., .6, .8)).norm(),
              1e-15);
}

void held_by_bearings()
{
  const Model model =
    make_model(body("set rotating = yes\nset axis point = 5, 5, -100\n"
                    "set axis direction = 0, 0, -2\nset rotational speed = 3000 rpm\n"));
  const Body &made = model.bodies.front();
  check("bearing: turns on its axis", made.turns_on_axis);
  check_close("bearing: rate [rad/s]", made.rate, 100 * pi, 1e-12);
  check_below("bearing: direction of length one",
              (made.axis.direction + Vector3::UnitZ()).norm(),
              1e-15);
  // A cube of 10 mm in four cells a side about its own axis: (10^2/12 + 2.5^2/6) m for each side.
  check_ratio("bearing: inertia about it over that of the cube",
              made.axial_inertia() / (2 * made.mass() * (100. / 12 + 6.25 / 6)),
              1e-12);
}

void moving()
{
  const Model model = make_model(body("set velocity = 1, 0, 0 m/s\n"
                                      "set angular velocity = 0, 30, 40 rad/s\n"
                                      "set initial velocity x = 7*y\n"
                                      "set initial velocity y = x^2 - 1\n"
                                      "set initial velocity z = if(z > 5, 2, -2)\n"));
  const Body &made  = model.bodies.front();
  check("free: no bearing", !made.turns_on_axis);
  check("free: velocity [mm/s]", made.velocity == Vector3(1000., 0., 0.));
  check_close("free: rate [rad/s]", made.rate, 50., 1e-13);
  check_below("free: axis", (made.axis.direction - Vector3(0., .6, .8)).norm(), 1e-15);
  double largest = 0;
  for (unsigned int i = 0; i < made.n_nodes(); ++i)
    {
      const Vector3 &X = made.node_positions()[i];
      const Vector3  v(7 * X[1], X[0] * X[0] - 1, X[2] > 5 ? 2. : -2.);
      raise_to(largest, (made.initial_velocity[i] - v).norm());
    }
  check_below("formulas of the undeformed places [mm/s]", largest, 1e-12);
  check("no formula, no field",
        make_model(body("set velocity = 1, 0, 0 m/s")).bodies[0].initial_velocity.empty());
}

const std::string strip =
  "set mesh = file\nset file = " + source_folder() + "/../../meshes/bimetal_strip.inp\n";

void composite()
{
  const Model model =
    make_model(body(strip + "set region materials = upper: brass\nset temperature = 10*x K\n",
                    "subsection Material brass\n set density = 8.5 g/cm^3\n"
                    " set thermal expansion = 2e-5 1/K\nend\n"));
  const Body &made  = model.bodies[0];
  bool        right = true;
  double      wrong = 0;
  for (unsigned int e = 0; e < made.n_elements(); ++e)
    {
      const Vector3 middle = made.element_nodes(e).rowwise().mean();
      right                = right && made.material(e).name == (middle[2] > .5 ? "brass" : "steel");
      raise_to(wrong,
               std::abs(made.initial_strain(e) -
                        (middle[2] > .5 ? 2e-5 : 1.2e-5) * 10. * middle[0]));
    }
  check("a region of the file has its own material", right);
  check_close("mass of both halves [g]", 1e6 * made.mass(), .01 * (7.85 + 8.5), 1e-12);
  check("a temperature of zero is none",
        !make_model(body("set temperature = 0.0\n")).bodies[0].has_initial_strains());
  check_below("strains of the temperature at the middles of elements", wrong, 1e-15);
  std::vector<unsigned int> lid, end;
  for (unsigned int i = 0; i < made.n_nodes(); ++i)
    {
      if (made.node_positions()[i][2] > 1. - 1e-9)
        lid.push_back(i);
      if (made.node_positions()[i][0] < 1e-9)
        end.push_back(i);
    }
  check("one material under the upper face", made.material_under(lid, "lid").name == "brass");
  print_refusal([&] { made.material_under(end, "surface \"end\""); });
  const std::string brass = "subsection Material brass\n set density = 8.5 g/cm^3\nend\n",
                    iron  = "subsection Material iron\n set density = 7.2 g/cm^3\nend\n";
  refuse(body(strip + "set region materials = UPER: brass\n", brass));
  refuse(body(strip + "set region materials = UPPER brass\n"));
  refuse(body(strip + "set region materials = UPPER: brass, UPPER: iron\n", brass + iron));
  refuse(body(strip + "set region materials = UPPER: brass, LOWER: iron\n", brass));
  refuse(body("set region materials = UPPER: brass\n"));
  refuse(body("set temperature = 20 C\n"));
  refuse(body("set temperature = 20*t\n"));
  refuse(body("set temperature = 1e5\n"));
}

void refusals()
{
  refuse("subsection Model\nend\n");
  for (const char *entries : {"set mesh = blok\n",
                              "set radius = 3 mm\n",
                              "set mesh = file\n",
                              "set mesh = file\nset file = nothing.msh\n",
                              "set mesh = ring\nset inner radius = 40 mm\n",
                              "set mesh = cylinder\nset core elements = 3\n",
                              "set rotation axis = 0, 0, 0\n",
                              "set rotating = yes\nset axis direction = 0, 0, 0\n",
                              "set rotating = yes\nset velocity = 1, 0, 0\n",
                              "set rotating = yes\nset angular velocity = 1, 0, 0\n",
                              "set rotational speed = 1 rpm\n",
                              "set velocity = 1, 0\n",
                              "set initial velocity y = 2*w\n"})
    refuse(body(entries));
  refuse(body("set material = brass\n", "subsection Material bras\nend\n"));
  refuse(body("set material = brass\n"));
  refuse(body("", "subsection Material steel\n set Poisson's ratio = 0.5\nend\n"));
}

int main()
{
  return run_parts({shapes, material, placed, held_by_bearings, moving, composite, refusals});
}
