// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Elements under finite strain: derivatives of the energy, waves in a stretched medium, limits at
// rest and under rigid rotation; stiffness in spin beside that of explicit dynamics' elements.
#include "../element/samples.h"
#include "../internal_force.h"
#include "../model_parts.h"
#include "../parts.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/element/stiffness.h>
#include <vfife/fem/modes/rotating_body.h>
#include <vfife/fem/solvers/direct_solver.h>
#include <vfife/fem/solvers/sparse_matrix.h>
#include <vfife/fem/system/spin_state.h>
#include <vfife/mesh/primitives/primitives.h>

using namespace vfife;

const StrainMeasure measures[] = {StrainMeasure::biot, StrainMeasure::green};

std::string name_of(const StrainMeasure measure)
{
  return measure == StrainMeasure::biot ? "biot" : "green";
}

Matrix3 random_matrix(Samples &samples, const double size)
{
  Matrix3 matrix;
  for (unsigned int i = 0; i < 3; ++i)
    matrix.col(i) = size * samples.vector();
  return matrix;
}

/** Stress and tangent are the derivatives of the energy; turning the whole changes no energy. */
void derivatives(const Communicator &)
{
  const Material steel;
  for (const StrainMeasure measure : measures)
    {
      Samples samples;
      double  stress_error = 0, tangent_error = 0, energy_error = 0, symmetry = 0;
      for (unsigned int sample = 0; sample < 10; ++sample)
        {
          const Matrix3     H     = random_matrix(samples, .2);
          const StrainState state = compute_strain_state(H, steel, measure);
          constexpr double  step  = 1e-6;
          for (unsigned int c = 0; c < 9; ++c)
            {
              Matrix3 up = H, down = H;
              up.data()[c] += step;
              down.data()[c] -= step;
              const StrainState above = compute_strain_state(up, steel, measure),
                                below = compute_strain_state(down, steel, measure);
              raise_to(stress_error,
                       std::abs((above.energy - below.energy) / (2. * step) -
                                state.stress.data()[c]));
              const Matrix3 change = (above.stress - below.stress) / (2. * step);
              for (unsigned int r = 0; r < 9; ++r)
                raise_to(tangent_error, std::abs(change.data()[r] - state.tangent(r, c)));
            }
          raise_to(symmetry, (state.tangent - state.tangent.transpose()).cwiseAbs().maxCoeff());
          const Matrix3 R        = samples.rotation();
          const Matrix3 F_turned = R * (Matrix3::Identity() + H);
          raise_to(energy_error,
                   std::abs(
                     compute_strain_state(F_turned - Matrix3::Identity(), steel, measure).energy /
                       state.energy -
                     1.));
        }
      // Central differences: the square of the step, and round-off over it.
      check_below(name_of(measure) + ": stress", stress_error / steel.youngs_modulus, 1e-8);
      check_below(name_of(measure) + ": tangent", tangent_error / steel.youngs_modulus, 1e-8);
      check_below(name_of(measure) + ": symmetry", symmetry / steel.youngs_modulus, 1e-14);
      check_below(name_of(measure) + ": turned energy", energy_error, 1e-12);
    }
}

/**
 * Plane waves along 1 in a medium stretched by 1 + e_i along the axes move with the stiffnesses
 * d P_i1/d F_i1 (small waves superposed, Truesdell 1961). From the energies by hand: Biot
 * lambda + 2 mu along, 2 mu + (lambda tr e - 2 mu)/(2 + e_1 + e_2) across; Green
 * S_1 + (1 + e_1)^2 (lambda + 2 mu) and S_1 + (1 + e_2)^2 mu, S_1 = lambda tr E + 2 mu E_1.
 */
void waves(const Communicator &)
{
  const Material steel;
  const double   lambda = steel.lambda(), mu = steel.mu();
  const Vector3  e(.03, -.02, .01);
  const Matrix3  H = e.asDiagonal();
  {
    const Matrix9 C = compute_strain_state(H, steel, StrainMeasure::biot).tangent;
    check_ratio("biot: wave along the stretch", C(0, 0) / (lambda + 2. * mu), 1e-13);
    check_ratio("biot: wave across the stretch",
                C(1, 1) / (2. * mu + (lambda * e.sum() - 2. * mu) / (2. + e[0] + e[1])),
                1e-13);
  }
  {
    const Matrix9 C = compute_strain_state(H, steel, StrainMeasure::green).tangent;
    const Vector3 E = e.array() + .5 * e.array().square();
    const double  S = lambda * E.sum() + 2. * mu * E[0];
    check_ratio("green: wave along the stretch",
                C(0, 0) / (S + std::pow(1. + e[0], 2) * (lambda + 2. * mu)),
                1e-13);
    check_ratio("green: wave across the stretch",
                C(1, 1) / (S + std::pow(1. + e[1], 2) * mu),
                1e-13);
  }
}

/** All points of an element between its corners. */
ElementNodes points_of(const HexahedronNodes &corners, const FemElement element)
{
  const std::vector<double> places = places_along(degree_of(element));
  const std::size_t         n      = places.size();
  ElementNodes              all(3, n * n * n);
  for (std::size_t a = 0; a < n * n * n; ++a)
    all.col(a) = corners * shape_functions(Vector3(2. * places[a % n] - 1.,
                                                   2. * places[a / n % n] - 1.,
                                                   2. * places[a / (n * n)] - 1.));
  return all;
}

/** Elements: forces and tangent are derivatives, the tangent at rest is the stiffness, a rotation
 * makes no force, strains far below round-off of the places are exact. */
void elements(const Communicator &)
{
  const Material steel;
  for (const StrainMeasure measure : measures)
    for (const auto &choice : fem_element_choices())
      {
        const FemElement      element = choice.second;
        Samples               samples;
        const HexahedronNodes corners = samples.hexahedron(Vector3(3., 1., 2.), .1);
        const ElementNodes    X       = points_of(corners, element);
        const int             n       = X.size();
        const Eigen::MatrixXd K       = compute_fem_stiffness(X, steel, element);
        const double          size    = K.cwiseAbs().maxCoeff();
        const auto            state   = [&](const Eigen::VectorXd &u, const bool tangent = false) {
          return compute_element_state(X, steel, element, measure, u, tangent);
        };
        const std::string name = name_of(measure) + ", " + choice.first;
        check_below(name + ": tangent at rest",
                    (state(Eigen::VectorXd::Zero(n), true).tangent - K).cwiseAbs().maxCoeff() /
                      size,
                    1e-13);
        Eigen::VectorXd u(n);
        for (int i = 0; i < n; ++i)
          u[i] = .05 * samples.number();
        const ElementState at          = state(u, true);
        double             force_error = 0, tangent_error = 0;
        constexpr double   step = 1e-6;
        for (int i = 0; i < n; ++i)
          {
            Eigen::VectorXd up = u, down = u;
            up[i] += step;
            down[i] -= step;
            const ElementState above = state(up), below = state(down);
            raise_to(force_error,
                     std::abs((above.energy - below.energy) / (2. * step) - at.forces[i]));
            raise_to(tangent_error,
                     ((above.forces - below.forces) / (2. * step) - at.tangent.col(i))
                       .cwiseAbs()
                       .maxCoeff());
          }
        check_below(name + ": forces", force_error / size, 1e-8);
        check_below(name + ": tangent", tangent_error / size, 1e-8);
        const Matrix3      R      = samples.rotation();
        const ElementNodes turned = R * X - X;
        check_below(
          name + ": forces of a rotation",
          state(Eigen::Map<const Eigen::VectorXd>(turned.data(), n)).forces.cwiseAbs().maxCoeff() /
            size,
          1e-13);
        const Eigen::VectorXd tiny = 1e-14 * u;
        check_below(name + ": smallest strains",
                    (state(tiny).forces - K * tiny).norm() / (K * tiny).norm(),
                    1e-11);
      }
}

/** Forces of explicit dynamics' element, which turns as a whole, and their differences. */
Eigen::VectorXd turned_forces(const HexahedronNodes &X, const Matrix24 &K, const Eigen::VectorXd &u)
{
  const HexahedronNodes forces = -compute_internal_forces(
    K, X, X + Eigen::Map<const HexahedronNodes>(u.data()), FrameKind::polar);
  return Eigen::Map<const Vector24>(forces.data());
}

Eigen::MatrixXd
turned_stiffness(const HexahedronNodes &X, const Matrix24 &K, const Eigen::VectorXd &u)
{
  Eigen::MatrixXd  tangent(24, 24);
  constexpr double step = 1e-5;
  for (int i = 0; i < 24; ++i)
    {
      Eigen::VectorXd up = u, down = u;
      up[i] += step;
      down[i] -= step;
      tangent.col(i) = (turned_forces(X, K, up) - turned_forces(X, K, down)) / (2. * step);
    }
  return .5 * (tangent + tangent.transpose());
}

/**
 * A wheel with a thin web and a rim in spin. The reference is made of explicit dynamics'
 * elements, which know neither Green's nor Biot's strain but a turned linear element: their
 * equilibrium and their stiffness by differences of their forces. Rises of the frequencies with
 * the speed, and their part that is owed to the displaced places.
 */
void wheel(const Communicator &communicator)
{
  Model model = model_of(Body("wheel", make_ring(20., 60., 3., {{10, 60, 2}}), {}));
  Body &body  = model.bodies[0];
  body.axis   = {Vector3::Zero(), Vector3::UnitZ()};
  model.constraints.push_back({"hub", ConstraintKind::held, 0, body.node_set("inner")});
  FemOptions options;
  options.n_modes          = 12;
  const double       rate  = 4000.;
  const auto         rates = [rate](unsigned int) { return rate; };
  const RotatingBody rotating(model, 0, options, communicator);
  const ModesAtSpeed at_rest = rotating.find_modes(0.), spun = rotating.find_modes(rate);

  const FemSpace       &d = rotating.space();
  const FemSystem       system(d, {}, communicator);
  const ModalSolver     solver(system, options);
  const SystemMatrices &matrices = solver.matrices();
  const auto nodes = [&d](const unsigned int e) -> HexahedronNodes { return d.element_nodes(e); };
  const auto stiffness = [&](const unsigned int e) {
    return compute_stiffness(nodes(e), body.materials().front(), StiffnessKind::incompatible_modes);
  };
  const auto tangent = [&](const std::vector<double> &u) {
    return add_scaled(system.matrix([&](const unsigned int e) {
      return turned_stiffness(nodes(e), stiffness(e), d.gather(e, u));
    }),
                      -1.,
                      matrices.spin_mass(rates));
  };
  std::vector<double> u = rotating.find_equilibrium(rate);
  for (unsigned int round = 0; round < 3; ++round)
    {
      // Omega^2 S (X + u) - f(u), with the turned elements' f.
      OwnedVector q = matrices.spinning_residual(u, rates, true);
      q             = add_scaled(std::move(q), 1., system.vector([&](const unsigned int e) {
        const Eigen::VectorXd v = d.gather(e, u);
        return Eigen::VectorXd(
          compute_element_state(
            d.element_nodes(e), body.materials().front(), options.element, options.strain, v, false)
            .forces -
          turned_forces(nodes(e), stiffness(e), v));
      }));
      const DirectSolver factors(tangent(u));
      factors.solve(q.data(), 1);
      u = add_scaled(std::move(u), 1., system.expand(q));
    }
  const ModalResult reference = solver.solve(tangent(u), matrices.mass(), 0.);
  double            error     = 0;
  for (unsigned int k = 0; k < options.n_modes; ++k)
    {
      const double rise     = spun.modes[k].frequency - at_rest.modes[k].frequency;
      const double expected = reference.modes[k].frequency() - at_rest.modes[k].frequency;
      raise_to(error, std::abs(rise / expected - 1.));
    }
  check_below("wheel: rises of the frequencies", error, .025);
}
/** In spin a body still turns on its hub without a force, with a border that is not round, too:
 * u = a x (X + u0) costs no energy. */
void free_turn(const Communicator &communicator)
{
  Model       model = model_of(Body("wheel",
                              make_moved(*make_ring(20., 40., 3., {{4, 18, 2}}),
                                         "wheel",
                                         [](const Vector3 &x) {
                                           const double part = (x.head<2>().norm() - 20.) / 20.;
                                           return Vector3(x[0] * (1. + .1 * part), x[1], x[2]);
                                         }),
                              {}));
  const Body &body  = model.bodies[0];
  Constraint  hub{"hub", ConstraintKind::rigid_hub, 0, {}};
  for (unsigned int i = 0; i < body.n_nodes(); ++i)
    if (body.node_positions()[i].head<2>().norm() < 20.1)
      hub.nodes.push_back(i);
  model.constraints.push_back(hub);
  FemOptions           options;
  const double         rate  = 3000.;
  const auto           rates = [rate](unsigned int) { return rate; };
  const RotatingBody   rotating(model, 0, options, communicator);
  const FemSpace      &d = rotating.space();
  const FemSystem      system(d, {}, communicator);
  const SystemMatrices matrices(system, options.mass, options.strain);
  const auto           u = rotating.find_equilibrium(rate);
  std::vector<double>  turn(u.size());
  for (unsigned int p = 0; p < d.n_points(); ++p)
    Eigen::Map<Vector3>(turn.data() + 3 * p) =
      Vector3::UnitZ().cross(d.points()[p] + Eigen::Map<const Vector3>(u.data() + 3 * p));
  const OwnedVector  q = system.restrict_field(turn);
  const SparseMatrix K(matrices.spinning_stiffness(u, rates)), S(matrices.spin_mass(rates));
  check_below("a hub's turn in spin", K.project({q}, {q})(0, 0) / S.project({q}, {q})(0, 0), 1e-8);
  check_below("forces of a hub's turn in spin",
              std::sqrt(system.dot(K.apply(q), K.apply(q)) / system.dot(S.apply(q), S.apply(q))),
              1e-6);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {derivatives, waves, elements, wheel, free_turn});
}
