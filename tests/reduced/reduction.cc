// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Modes and residual flexibilities of one sector, beside the same of the whole body.
#include "../parts.h"
#include "../refusal.h"
#include "whole_body.h"

#include <vfife/fem/modes/modal_solver.h>
#include <vfife/fem/modes/rotating_body.h>
#include <vfife/fem/statics/compliance.h>
#include <vfife/fem/system/bearing_rings.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/reduced/body_reduction.h>
#include <vfife/reduced/reduction_source.h>

#include <Eigen/Eigenvalues>

using namespace vfife;

using Field = std::vector<double>;

double product(const Field &a, const Field &b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}

/** The whole body by the solvers that know no sectors. */
class Whole
{
public:
  /** @p loose: the same body without a constraint. */
  Whole(const Model        &model,
        const Model        &loose,
        const FemOptions   &fem,
        const Communicator &communicator)
    : model_(model)
    , fem_(fem)
    , communicator_(communicator)
    , space_(loose, {0}, fem)
    , system_(space_, {}, communicator)
    , matrices_(system_, fem.mass, fem.strain)
    , compliance_(model, fem, model.bodies[0].rate != 0, communicator, Factorized::bodies)
    , turn_(3 * std::size_t(space_.n_points()))
  {
    for (std::size_t i = 0; i < space_.n_points(); ++i)
      Eigen::Map<Vector3>(turn_.data() + 3 * i) = body().axis.direction.cross(
        space_.points()[i] + Eigen::Map<const Vector3>(compliance_.spun().data() + 3 * i) -
        body().axis.point);
    momentum_ = momentum(turn_);
    turns_    = compliance_.turns_freely(0);
  }

  const Body &body() const
  {
    return model_.bodies[0];
  }
  bool turns() const
  {
    return turns_;
  }
  /** Whether nodes are all points. */
  bool has_nodes_only() const
  {
    return space_.degree() == 1;
  }
  Field no_forces() const
  {
    return Field(turn_.size(), 0.);
  }
  /** The first values of a field, those of the nodes. */
  Field at_nodes(Field u) const
  {
    u.resize(3 * std::size_t(body().n_nodes()));
    return u;
  }
  /** M u, 3 a point. */
  Field momentum(const Field &u) const
  {
    return system_.expand(matrices_.apply_mass(u));
  }
  /** Angular momentum of displacements about the axis, over the largest they could have. */
  double turn_of(const Field &u) const
  {
    return std::abs(product(momentum_, u)) / std::sqrt(inertia() * product(u, momentum(u)));
  }
  double inertia() const
  {
    return product(momentum_, turn_);
  }
  /** Displacements under forces whose moment the inertia of the turn balances. */
  Field answer(const Field &forces) const
  {
    return less(compliance_.solve(less(forces, momentum_, turn_)), turn_, momentum_);
  }
  Field spin() const
  {
    return less(compliance_.spun(), turn_, momentum_);
  }
  Field torque() const
  {
    Field forces(turn_.size(), 0.);
    add_torque_forces(model_.torques[0], space_, space_.parts()[0], 1., forces);
    return forces;
  }
  /** Forces of a unit angular acceleration. */
  Field euler() const
  {
    Field forces = momentum_;
    for (double &force : forces)
      force *= -1.;
    return forces;
  }
  ModalResult modes(const unsigned int n) const
  {
    const FemSpace  held(model_, {0}, fem_);
    const FemSystem system(held, {}, communicator_);
    FemOptions      options = fem_;
    options.n_modes         = n;
    const ModalSolver solver(system, options);
    const double      rate = body().rate;
    // Spin softens what hangs in bearings.
    const double lowest = body().floats ? -rate * rate : turns_ ? -1e-3 * rate * rate : 0.;
    return solver.solve(solver.matrices().spinning_stiffness(compliance_.spun(),
                                                             [rate](unsigned int) { return rate; }),
                        solver.matrices().mass(),
                        lowest);
  }

private:
  Field less(Field u, const Field &along, const Field &by) const
  {
    const double part = turns_ ? product(u, by) / inertia() : 0.;
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] -= part * along[i];
    return u;
  }

  const Model        &model_;
  FemOptions          fem_;
  const Communicator &communicator_;
  FemSpace            space_;
  FemSystem           system_;
  SystemMatrices      matrices_;
  Compliance          compliance_;
  Field               turn_, momentum_;
  bool                turns_ = false;
};

bool is_double(const ReducedBody::Harmonic &harmonic, const ReducedBody &body)
{
  return harmonic.number > 0 && 2 * harmonic.number < body.n_sectors;
}

/** As many modes as the whole body has, with its frequencies. */
void compare_frequencies(const std::string &name, const ReducedBody &reduced, const Whole &whole)
{
  Field values(reduced.turns ? 1 : 0, 0.);
  for (const ReducedBody::Harmonic &harmonic : reduced.harmonics)
    for (const double value : harmonic.eigenvalues)
      values.insert(values.end(), is_double(harmonic, reduced) ? 2 : 1, value);
  std::sort(values.begin(), values.end());
  const ModalResult result  = whole.modes(values.size() + 4);
  unsigned int      n_below = 0;
  double            worst   = 0;
  for (std::size_t k = 0; k < result.modes.size(); ++k)
    if (result.modes[k].eigenvalue < reduced.cutoff * reduced.cutoff)
      {
        ++n_below;
        if (values[std::min(k, values.size() - 1)] > 0)
          raise_to(worst, std::abs(result.modes[k].eigenvalue / values[k] - 1.));
      }
  check(name + ": number of modes", n_below == values.size() && n_below > 20);
  check(name + ": counted", reduced.counted && result.counted);
  check_below(name + ": eigenvalues", worst, 1e-8);
}

/** Both real modes of each complex one are orthonormal with the masses of the whole body. */
void compare_shapes(const std::string &name, const ReducedBody &reduced, const Whole &whole)
{
  std::vector<Field> shapes, momenta;
  double             turn = 0;
  for (const ReducedBody::Harmonic &harmonic : reduced.harmonics)
    for (unsigned int j = 0; j < harmonic.n_modes(); ++j)
      for (unsigned int part = 0; part < (is_double(harmonic, reduced) ? 2 : 1); ++part)
        {
          const std::complex<double> c =
            part == 0 ? std::complex<double>(1.) : std::complex<double>(0., 1.);
          shapes.push_back(whole_field(whole.body(), [&](const unsigned int k) {
            return Eigen::VectorXd((harmonic.shapes.col(j) * c *
                                    std::polar(1., harmonic.number * k * reduced.sector_angle))
                                     .real());
          }));
          momenta.push_back(whole.momentum(shapes.back()));
          raise_to(turn, whole.turn_of(shapes.back()));
        }
  double defect = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (std::size_t k = 0; k <= i; ++k)
      raise_to(defect, std::abs(product(shapes[i], momenta[k]) - (i == k ? 1. : 0.)));
  check_below(name + ": orthonormality", defect, 1e-8);
  if (reduced.turns)
    check_below(name + ": modes without angular momentum", turn, 1e-8);
}

/** Unit forces on some nodes, a unit torque, and the state of spin: modes and residuals together
 * are what the whole body does. */
void compare_statics(const std::string &name, const ReducedBody &reduced, const Whole &whole)
{
  check(name + ": turns", reduced.turns == whole.turns());
  if (reduced.turns)
    check_ratio(name + ": inertia", reduced.turn_inertia / whole.inertia(), 1e-9);
  const Body                  &body = whole.body();
  const unsigned int           n    = reduced.n_sectors;
  std::vector<Eigen::MatrixXd> answers;
  for (unsigned int k = 0; k < n; ++k)
    answers.push_back(static_answer(reduced, 2 * k > n ? int(k) - int(n) : int(k)));
  double worst = 0, turn = 0;
  for (unsigned int column = 0; column < answers[0].cols(); column += 7)
    {
      Field forces = whole.no_forces();
      Eigen::Map<Vector3>(forces.data() + 3 * std::size_t(reduced.touch_nodes[column / 3])) =
        body.placement.rotation.col(column % 3);
      // Nodes of the hub do not move.
      if (answers[0].col(column).cwiseAbs().maxCoeff() < 1e-12)
        continue;
      const Field u = whole_field(body, [&](const unsigned int k) {
        return Eigen::VectorXd(answers[k].col(column));
      });
      raise_to(worst, relative_difference(whole.at_nodes(whole.answer(forces)), u));
      if (whole.has_nodes_only())
        raise_to(turn, whole.turn_of(u));
    }
  check_below(name + ": displacements under forces", worst, 1e-7);

  const auto alike = [&](const Eigen::VectorXd &rows) {
    return whole_field(body, [&](unsigned int) { return rows; });
  };
  const ReducedBody::Harmonic &umbrella = reduced.harmonics[0];
  check(name + ": modes with the axis", umbrella.number == 0);
  const auto under = [&](const Eigen::VectorXd &residual, const AxialLoad &load) {
    return alike(residual + (umbrella.shapes * umbrella.eigenvalues.cwiseInverse().asDiagonal() *
                             umbrella.forces_of(load))
                              .real());
  };
  if (reduced.turns)
    {
      if (whole.has_nodes_only())
        check_below(name + ": displacements without angular momentum", turn, 1e-8);
      check_below(name + ": displacements under the torque",
                  relative_difference(whole.at_nodes(whole.answer(whole.torque())),
                                      under(reduced.torque_residual, {1., 0.})),
                  1e-7);
      check(name + ": an acceleration turns it only",
            reduced.euler_residual.norm() == 0. && umbrella.euler.norm() == 0.);
    }
  else
    check_below(name + ": displacements under an acceleration",
                relative_difference(whole.at_nodes(whole.answer(whole.euler())),
                                    under(reduced.euler_residual, {0., 1.})),
                1e-7);
  if (reduced.rate != 0)
    // Both are found by Newton's method to 1e-7.
    check_below(name + ": state of spin",
                relative_difference(whole.at_nodes(whole.spin()), alike(reduced.spin)),
                1e-6);
}

/** Unit loads on the seats of bearings and couplings, and what they, all nodes and the body as a
 * whole do under them. */
void compare_rings(const std::string &name,
                   const Model       &model,
                   const ReducedBody &reduced,
                   const Whole       &whole)
{
  const Body        &body = whole.body();
  const FemSpace     space(model, {0}, FemElement::incompatible_modes);
  const BearingRings seats(space);
  check(name + ": rings", reduced.rings.size() == seats.list().size() + 1);
  Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(6 * reduced.rings.size(), 6 * reduced.rings.size());
  for (Eigen::Index i = 0; i < turn.rows(); i += 3)
    turn.block<3, 3>(i, i) = body.placement.rotation;
  // Modes' parts of h = 0 and 1 beside the residual ones.
  Eigen::MatrixXd  rings   = reduced.rings.residual;
  Eigen::MatrixXcd rows[2] = {reduced.rings.answers[0], reduced.rings.answers[1]};
  for (const ReducedBody::Harmonic &harmonic : reduced.harmonics)
    if (harmonic.number < 2)
      {
        const Eigen::MatrixXcd modal =
          harmonic.eigenvalues.cwiseInverse().asDiagonal() * harmonic.rings.adjoint();
        rings += (harmonic.rings * modal).real();
        rows[harmonic.number] += harmonic.shapes * modal;
      }
  double nodes = 0, motions = 0, mean = 0;
  for (std::size_t c = 0; c < 6 * seats.list().size(); ++c)
    {
      const Eigen::VectorXd load = Eigen::VectorXd::Unit(6 * seats.list().size(), c);
      Field                 forces(3 * std::size_t(body.n_nodes()), 0.);
      seats.add_forces(load, forces);
      const Field     u = whole.answer(forces);
      Eigen::VectorXd all(turn.rows());
      all << load, Eigen::VectorXd::Zero(6);
      const Eigen::VectorXd own = turn.transpose() * all;
      // About the axis nothing is left where it turns freely.
      if (reduced.turns && std::abs(body.axis.direction[c % 3]) > .5 && c % 6 > 2)
        continue;
      raise_to(nodes,
               relative_difference(u, whole_field(body, [&](const unsigned int k) {
                                     return Eigen::VectorXd(
                                       (rows[0] * own +
                                        std::polar(1., k * reduced.sector_angle) * (rows[1] * own))
                                         .real());
                                   })));
      const Eigen::VectorXd moved = turn * rings * own, known = seats.displacement(u);
      // Turns as ways at 10 mm.
      const double largest =
        Eigen::Map<const Eigen::VectorXd>(u.data(), u.size()).cwiseAbs().maxCoeff();
      for (std::size_t i = 0; i < 2 * seats.list().size(); ++i)
        raise_to(motions,
                 (i % 2 == 0 ? 1. : 10.) / largest *
                   (moved.segment<3>(3 * i) - known.segment<3>(3 * i)).norm());
      const Field momentum = whole.momentum(u);
      Vector3     sum      = Vector3::Zero();
      for (std::size_t i = 0; i < body.n_nodes(); ++i)
        sum += Eigen::Map<const Vector3>(momentum.data() + 3 * i);
      raise_to(
        mean,
        (sum / reduced.rings.inertia(0, 0) - moved.segment<3>(6 * seats.list().size())).norm() /
          largest);
    }
  check_below(name + ": displacements under loads on rings", nodes, 1e-7);
  check_below(name + ": rings under them", motions, 1e-7);
  check_below(name + ": centre of mass under them", mean, 1e-7);
}

void compare(const std::string  &name,
             const Model        &model,
             const Model        &loose,
             const double        cutoff,
             const Communicator &communicator,
             const FemOptions   &fem = {})
{
  const double      rate    = model.bodies[0].rate;
  const ReducedBody reduced = reduce_body(
    model, 0, {first_sector(model.bodies[0]), {}, fem, rate, cutoff, 100}, communicator);
  const Whole whole(model, loose, fem, communicator);
  compare_frequencies(name, reduced, whole);
  if (whole.has_nodes_only())
    compare_shapes(name, reduced, whole);
  compare_statics(name, reduced, whole);
  if (reduced.rings.size() > 0)
    compare_rings(name, model, reduced, whole);
}

/** Twelve sectors with mirror planes: modes of different shapes share frequencies by chance only,
 * those of half the sectors stand. */
void wheels(const Communicator &communicator)
{
  const auto wheel = [&](const std::string &name, const ConstraintKind hub, const double rate) {
    compare(name, make_wheel(hub, rate), make_wheel({}, rate), 4e5, communicator);
  };
  wheel("led wheel", ConstraintKind::prescribed_rotation, 3000.);
  wheel("wheel at rest", ConstraintKind::prescribed_rotation, 0.);
  wheel("free wheel", ConstraintKind::free_rotation, 3000.);
  wheel("wheel on a rigid hub", ConstraintKind::rigid_hub, 3000.);
}

/** Elements with points between the nodes. */
void quadratic(const Communicator &communicator)
{
  FemOptions fem;
  fem.element      = FemElement::quadratic;
  fem.geometry     = FemGeometry::curved;
  const auto wheel = [&](const std::string &name, const ConstraintKind hub) {
    constexpr std::array<unsigned int, 3> cells = {{2, 12, 1}};
    compare(
      name, make_wheel(hub, 3000., cells), make_wheel({}, 3000., cells), 4e5, communicator, fem);
  };
  wheel("led quadratic wheel", ConstraintKind::prescribed_rotation);
  wheel("free quadratic wheel", ConstraintKind::free_rotation);
}

/** 27 sectors without a mirror plane. */
void pinions(const Communicator &communicator)
{
  const auto pinion = [&](const std::string &name, const ConstraintKind hub) {
    compare(name,
            make_pinion(hub, 2000., communicator),
            make_pinion({}, 2000., communicator),
            6e5,
            communicator);
  };
  pinion("led pinion", ConstraintKind::prescribed_rotation);
  pinion("pinion on a rigid hub", ConstraintKind::rigid_hub);
}

/** On shafts: driven by a coupling and at rest, free to turn, slower than their bearings allow
 * and faster, with bearings that differ across the axis, which turning bodies feel in the mean.
 */
void bearings(const Communicator &communicator)
{
  const auto wheel = [&](const std::string &name,
                         const double       rate,
                         const double       radial,
                         const double       unlike,
                         const double       coupling) {
    compare(name,
            hang_in_bearings(make_wheel({}, rate), "inner", radial, unlike, coupling),
            make_wheel({}, rate),
            4e5,
            communicator);
  };
  wheel("wheel in bearings at rest", 0., 2e4, 1., 1e6);
  wheel("wheel in bearings", 3000., 2e4, 1., 1e6);
  wheel("wheel in unlike bearings", 3000., 2e4, 3., 1e6);
  wheel("driven wheel", 3000., 2e4, 1., 0.);
  wheel("wheel in soft bearings", 3000., 50., 1., 1e6);
  compare("pinion in bearings",
          hang_in_bearings(make_pinion({}, 2000., communicator), "bore", 1e5, 2., 1e8),
          make_pinion({}, 2000., communicator),
          6e5,
          communicator);
}

/** A body is not known again at another temperature. */
void sources(const Communicator &)
{
  Model      model = make_wheel(ConstraintKind::rigid_hub, 0.);
  Body      &wheel = model.bodies[0];
  const auto make  = [&] { return ReductionSource(model, 0, {}); };
  const auto heat  = [&](const double strain) {
    wheel.add_initial_strains(std::vector<double>(wheel.n_elements(), strain));
    return make();
  };
  const ReductionSource cold = make(), warm = heat(1e-4), hot = heat(1e-4);
  check("a body is known again",
        make().find_difference(hot).empty() && cold.find_difference(cold).empty());
  for (const auto &[one, other] : {std::pair(cold, warm), std::pair(warm, hot)})
    check("temperature",
          one.find_difference(other) == "temperature" &&
            other.find_difference(one) == "temperature");
}

/** Two cut-offs: what modes lose residuals gain. */
void cutoffs(const Communicator &communicator)
{
  const Model model = make_pinion(ConstraintKind::rigid_hub, 2000., communicator);
  const auto  nodes = first_sector(model.bodies[0]);
  const auto  below = [&](const double cutoff) {
    return reduce_body(model, 0, {nodes, {}, {}, 2000., cutoff, 2}, communicator);
  };
  const ReducedBody few = below(2e5), many = below(6e5);
  check("more modes with the higher cut-off", 2 * few.n_modes() < many.n_modes());
  double worst = 0;
  for (const int d : {-2, -1, 0, 1, 2})
    raise_to(worst,
             (static_answer(few, d) - static_answer(many, d)).norm() /
               static_answer(few, d).norm());
  check_below("displacements under forces with two cut-offs", worst, 1e-9);
}

/** Frequencies of the reduced body with Coriolis forces, without motions slower than a part of
 * the rate. */
Field waves_of(const ReducedBody &reduced)
{
  const double omega = reduced.rate;
  Field        rates;
  for (const ReducedBody::Harmonic &harmonic : reduced.harmonics)
    {
      // c'' + 2 Omega G c' + Lambda c = 0, the turn one of them where it is free; c' over a
      // scale, so that all numbers have one size.
      const bool       with_turn = reduced.turns && harmonic.number == 0;
      const int        n         = harmonic.n_modes() + (with_turn ? 1 : 0);
      const double     scale     = reduced.cutoff;
      Eigen::MatrixXcd G         = Eigen::MatrixXcd::Zero(n, n);
      Eigen::VectorXcd lambda    = Eigen::VectorXcd::Zero(n);
      G.topLeftCorner(harmonic.n_modes(), harmonic.n_modes()) = harmonic.coriolis;
      lambda.head(harmonic.n_modes())                         = harmonic.eigenvalues;
      if (with_turn)
        {
          const Eigen::VectorXcd row = reduced.turn_coriolis / std::sqrt(reduced.turn_inertia);
          G.row(n - 1).head(n - 1)   = row.transpose();
          G.col(n - 1).head(n - 1)   = -row;
        }
      Eigen::MatrixXcd A          = Eigen::MatrixXcd::Zero(2 * n, 2 * n);
      A.topRightCorner(n, n)      = scale * Eigen::MatrixXcd::Identity(n, n);
      A.bottomLeftCorner(n, n)    = -lambda.asDiagonal().toDenseMatrix() / scale;
      A.bottomRightCorner(n, n)   = -2. * omega * G;
      const Eigen::VectorXcd rate = Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(A).eigenvalues();
      // Of real coordinates i omega and -i omega are one wave.
      for (const std::complex<double> value : rate)
        if (is_double(harmonic, reduced) || value.imag() > 0)
          if (std::abs(value) > .1 * omega)
            rates.push_back(std::abs(value.imag()));
    }
  std::sort(rates.begin(), rates.end());
  return rates;
}

/** Waves with Coriolis forces beside those of the whole body. */
void coriolis(const Communicator &communicator)
{
  const double rate = 10000.;
  for (const ConstraintKind hub : {ConstraintKind::prescribed_rotation, ConstraintKind::rigid_hub})
    {
      const Model model   = make_wheel(hub, rate);
      ReducedBody reduced = reduce_body(model,
                                        0,
                                        {first_sector(model.bodies[0]), {}, {}, rate, 1.5e6, 1},
                                        communicator);
      FemOptions  fem;
      fem.coriolis             = true;
      fem.n_modes              = 40;
      const ModesAtSpeed whole = RotatingBody(model, 0, fem, communicator).find_modes(rate);
      const Field        waves = waves_of(reduced);
      Field              still;
      for (const ReducedBody::Harmonic &harmonic : reduced.harmonics)
        for (const double value : harmonic.eigenvalues)
          still.insert(still.end(), is_double(harmonic, reduced) ? 2 : 1, std::sqrt(value));
      std::sort(still.begin(), still.end());
      double       worst = 0, split = 0;
      unsigned int k = 0;
      for (const RotatingMode &mode : whole.modes)
        if (mode.frequency > 0 && k < 34)
          {
            raise_to(worst, std::abs(waves[k] / (2. * pi * mode.frequency) - 1.));
            raise_to(split, std::abs(waves[k] / still[k] - 1.));
            ++k;
          }
      // Breathing turns the body on a free hub, as a skater's arms do.
      double skater = 0;
      if (reduced.turns)
        {
          reduced.turn_coriolis.setZero();
          const Field held = waves_of(reduced);
          for (unsigned int i = 0; i < k; ++i)
            skater = std::max(skater, std::abs(held[i] / waves[i] - 1.));
        }
      if (reduced.turns)
        check("waves: breathing turns the hub", skater > 1e-4);
      // Both are projections, on modes and on modes with what Coriolis forces begin to bend.
      check("waves: enough", k == 34);
      check("waves: Coriolis forces matter", split > 1e-2);
      check_below("waves: frequencies", worst, 5e-6);
    }
}

/** Modes at half the rate, from those at the rate. */
void speed(const Communicator &communicator)
{
  for (const double rate : {4000., 0.})
    {
      const double other = rate != 0 ? .5 * rate : 4000.;
      const auto   at    = [&](const double omega) {
        const Model model = make_wheel(ConstraintKind::free_rotation, omega);
        return reduce_body(model,
                           0,
                           {first_sector(model.bodies[0]), {}, {}, omega, 6e5, 1},
                           communicator);
      };
      const ReducedBody here = at(rate), there = at(other);
      double            worst = 0, change = 0;
      for (std::size_t i = 0; i < here.harmonics.size(); ++i)
        {
          const ReducedBody::Harmonic &harmonic = here.harmonics[i];
          Eigen::MatrixXcd             K        = harmonic.eigenvalues.asDiagonal();
          K += (other * other - rate * rate) * harmonic.spin_stiffness;
          const Eigen::VectorXd values =
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd>(K).eigenvalues();
          for (unsigned int k = 0; k < std::min(2u, harmonic.n_modes()); ++k)
            {
              raise_to(worst, std::abs(values[k] / there.harmonics[i].eigenvalues[k] - 1.));
              raise_to(change,
                       std::abs(harmonic.eigenvalues[k] / there.harmonics[i].eigenvalues[k] - 1.));
            }
        }
      check("speed matters", change > 1e-2);
      // The curvature over Omega^2 is of the order of the strain, 1e-3.
      check_below("eigenvalues at another speed", worst / change, 1e-3);
    }
}

/** What lies beyond the reach, and readings across the borders of sectors. */
void rows(const Communicator &communicator)
{
  const Model               model      = make_wheel(ConstraintKind::rigid_hub, 3000.);
  const Body               &body       = model.bodies[0];
  const unsigned int        per_sector = body.structure().nodes_per_sector();
  std::vector<unsigned int> touch;
  for (const unsigned int node : body.node_set("outer"))
    if (node < per_sector)
      touch.push_back(node);
  // The first touch node of the next sector and of the one before, turned; the sum of both.
  const Vector3              weight(.3, -.5, .7);
  std::vector<SectorReading> readings(3);
  readings[0] = {"next", {{touch[0] + per_sector, weight}}};
  readings[1] = {"last", {{touch[0] + body.n_nodes() - per_sector, weight}}};
  readings[2] = {"both", readings[0].weights};
  readings[2].weights.push_back(readings[1].weights[0]);
  const auto reduce = [&](const unsigned int reach) {
    return reduce_body(model, 0, {touch, readings, {}, body.rate, 4e5, reach}, communicator);
  };
  const ReducedBody all = reduce(6), some = reduce(2);
  const std::size_t n = 3 * touch.size();
  check("rows", all.n_rows() == n + 3 && all.spin.size() == int(n + 3) && all.reach == 6);
  double within = 0, beyond = 0, difference = 0;
  for (int d = -6; d <= 6; ++d)
    {
      const double largest                = all.residual[d + 6].topRows(n).cwiseAbs().maxCoeff();
      (std::abs(d) > 2 ? beyond : within) = std::max(std::abs(d) > 2 ? beyond : within, largest);
      if (std::abs(d) <= 2)
        raise_to(difference, (all.residual[d + 6] - some.residual[d + 2]).norm() / largest);
    }
  check_below("residuals do not depend on the reach", difference, 1e-12);
  check_close("what is left beyond the reach", some.residual_left, beyond / within, 1e-12);
  check("nothing is left all around", all.residual_left == 0.);

  // R^-1 of what the next sector reads of itself, and so on.
  const Matrix3 turn  = rotation_about(Vector3::UnitZ(), all.sector_angle);
  double        worst = 0, size = 0;
  for (const int d : {-3, 0, 2})
    {
      const Eigen::MatrixXd next = (turn.transpose() * weight).transpose() *
                                   static_answer(all, d + 1).topRows(3),
                            last =
                              (turn * weight).transpose() * static_answer(all, d - 1).topRows(3),
                            read = static_answer(all, d).bottomRows(3);
      worst                      = largest_of({worst,
                                               (read.row(0) - next).norm(),
                                               (read.row(1) - last).norm(),
                                               (read.row(2) - next - last).norm()});
      raise_to(size, read.norm());
    }
  check_below("readings of other sectors", worst / size, 1e-10);
  Eigen::MatrixXd summed = Eigen::MatrixXd::Zero(3, n);
  for (const Eigen::MatrixXd &residual : all.residual)
    summed += residual.bottomRows(3);
  check_below("readings of all sectors",
              (some.summed_residual - summed).norm() / summed.norm(),
              1e-10);
  check_close("a reading in spin",
              all.spin[n],
              (turn.transpose() * weight).dot(all.spin.head<3>()),
              1e-12);
  check_close("the sum of both in spin", all.spin[n + 2], all.spin[n] + all.spin[n + 1], 1e-12);
}

/** What is refused, and how it is named. */
void refusals(const Communicator &communicator)
{
  const auto refuse_node = [&](const Model &model, const unsigned int node, const double cutoff) {
    const ReductionOptions options{{node}, {}, {}, 3000., cutoff, 2};
    print_refusal([&]() { reduce_body(model, 0, options, communicator); });
  };
  const auto refuse = [&](const auto &change) {
    Model model = make_wheel(ConstraintKind::rigid_hub, 3000.);
    change(model);
    refuse_node(model, 0, 4e5);
  };
  const Model good = make_wheel(ConstraintKind::rigid_hub, 3000.);
  refuse_node(good, 35, 4e5);
  refuse_node(good, 0, 1e8);
  refuse([](Model &model) { model.constraints[0].nodes.pop_back(); });
  refuse([](Model &model) { model.torques[0].nodes.resize(3); });
  refuse([](Model &model) { model.constraints.clear(); });
  refuse([](Model &model) {
    model.constraints.push_back(hold(model.bodies[0].node_set("top"), {{true, false, false}}));
  });
  refuse([](Model &model) {
    model.loads.emplace_back();
    model.loads.back().name = "push";
  });
  refuse([](Model &model) {
    model = hang_in_bearings(std::move(model), "inner", 1e4, 1., 0.);
    model.bearings[0].nodes.pop_back();
  });
  // Without spin there is no mean over turns.
  print_refusal([&]() {
    const Model model = hang_in_bearings(make_wheel({}, 0.), "inner", 1e4, 1.01, 1e6);
    reduce_body(model, 0, {first_sector(model.bodies[0]), {}, {}, 0., 4e5, 2}, communicator);
  });
  refuse([](Model &model) { model.bodies[0].axis.direction = Vector3::UnitX(); });
}

int main(int argc, char **argv)
{
  return run_parts(
    argc,
    argv,
    {wheels, quadratic, pinions, bearings, cutoffs, coriolis, speed, rows, sources, refusals});
}
