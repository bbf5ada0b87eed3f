// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/fem/modes/gyroscopic_modes.h>
#include <vfife/fem/modes/rotating_body.h>
#include <vfife/fem/solvers/direct_solver.h>
#include <vfife/fem/system/rigid_motions.h>
#include <vfife/fem/system/spin_state.h>
#include <vfife/fem/system/turn_pins.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/constraints/rigid_freedom.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

// For one speed: the equilibrium under centrifugal force; stiffness and mass about it, for the
// whole body or for each harmonic of a sector; their modes; and, with Coriolis forces, waves in the
// space of these modes.
namespace vfife
{
  namespace
  {
    /** Both parts by one factor: the largest displacement of a node of the complex shape becomes
     * one. */
    void scale_to_one(std::vector<double> &shape, std::vector<double> &imaginary)
    {
      double largest = 0;
      // Of the nodes' displacements, not of their components: those depend on the axes.
      for (std::size_t i = 0; i < shape.size(); i += 3)
        largest =
          std::max(largest,
                   std::sqrt(Eigen::Map<const Vector3>(shape.data() + i).squaredNorm() +
                             Eigen::Map<const Vector3>(imaginary.data() + i).squaredNorm()));
      for (std::size_t i = 0; i < shape.size(); ++i)
        {
          shape[i] /= largest;
          imaginary[i] /= largest;
        }
    }

    /** Modes of a harmonic beside those of others, unsorted. */
    void append(ModesAtSpeed part, ModesAtSpeed &all)
    {
      all.modes.insert(all.modes.end(),
                       std::make_move_iterator(part.modes.begin()),
                       std::make_move_iterator(part.modes.end()));
      all.n_rigid += part.n_rigid;
      all.n_unknowns = std::max(all.n_unknowns, part.n_unknowns);
      all.memory     = std::max(all.memory, part.memory);
      all.counted    = all.counted && part.counted;
    }

    /** How often modes are searched again for the completeness of waves. */
    constexpr unsigned int most_attempts = 3;

    /**
     * Where bearings oppose rigid motions, their velocity relative to the ground is u' + Omega x u,
     * which adds b = Im(p^H J (Omega x p)) to omega m of the shape, p its rigid motion and J mass
     * and inertia. Where nothing opposes them, p^H J p of m is not damped.
     */
    double compute_rigid_damping(const Model               &model,
                                 const unsigned int         b,
                                 const double               rate,
                                 const double               omega,
                                 const std::vector<double> &real,
                                 const std::vector<double> &imaginary)
    {
      const Body &body = model.bodies[b];
      if (!body.turns_on_axis)
        return 0.;
      const RigidFreedom freedom(model, b);
      const bool         is_loose = freedom.opposed().empty();
      if (!body.floats && !is_loose)
        return 0.;
      const Vector3 &centre  = freedom.centre();
      const Matrix3 &inertia = freedom.inertia();
      double         square  = 0;
      // Of the real and the imaginary part: momentum and angular momentum per angular frequency.
      std::array<Vector3, 2> momentum = {{Vector3::Zero(), Vector3::Zero()}}, moment = momentum;
      for (unsigned int i = 0; i < body.n_nodes(); ++i)
        {
          const double  m = body.node_masses()[i];
          const Vector3 r = body.placement(body.node_positions()[i]) - centre;
          for (unsigned int part = 0; part < 2; ++part)
            {
              const Vector3 u =
                Eigen::Map<const Vector3>((part == 0 ? real : imaginary).data() + 3 * i);
              momentum[part] += m * u;
              moment[part] += m * r.cross(u);
              square += m * u.squaredNorm();
            }
        }
      const Matrix3 inverse = inertia.inverse();
      if (is_loose)
        {
          double rigid = 0;
          for (unsigned int part = 0; part < 2; ++part)
            rigid +=
              momentum[part].squaredNorm() / body.mass() + moment[part].dot(inverse * moment[part]);
          return -rigid / square;
        }
      // Im(p^H q) = Re p . Im q - Im p . Re q with q = J (a x p)
      const Vector3 &a      = body.axis.direction;
      double         around = 0;
      for (unsigned int part = 0; part < 2; ++part)
        {
          const Vector3 turn = inverse * moment[1 - part];
          around += (part == 0 ? 1. : -1.) *
                    (momentum[part].dot(a.cross(momentum[1 - part])) / body.mass() +
                     (inverse * moment[part]).dot(inertia * a.cross(turn)));
        }
      return rate * around / (omega * square);
    }
  } // namespace

  RotatingBody::RotatingBody(const Model        &model,
                             const unsigned int  body,
                             const FemOptions   &options,
                             const Communicator &communicator)
    : model_(model)
    , body_(body)
    , options_(options)
    , communicator_(communicator)
    , space_(options.cyclic_symmetry ? FemSpace::sector_of(model, body, options)
                                     : FemSpace(model, {body}, options))
    , whole_(model, {body}, FemElement::incompatible_modes)
    , describer_(whole_, whole_.parts()[0])
  {
    if (options.cyclic_symmetry && space_.degree() > 1)
      {
        shown_  = std::make_unique<const FemSpace>(model, std::vector<unsigned int>{body}, options);
        copies_ = std::make_unique<const SectorCopies>(space_, *shown_, shown_->parts()[0]);
      }
    for (const double rate : options.rates())
      if (model.bodies[body].floats && rate != 0 && !options.coriolis)
        throw InputError("Fem/coriolis",
                         "body \"" + model.bodies[body].name() +
                           "\" rotates in elastic bearings, where whirl requires Coriolis forces. "
                           "Set coriolis = yes");
  }

  RotatingBody::~RotatingBody() = default;

  unsigned int RotatingBody::count_free_motions() const
  {
    const auto         motions = find_free_motions(whole_, whole_.parts()[0]);
    const unsigned int n       = motions.size();
    if (turns_in_bearings(motions))
      return 0;
    return n > 0 && has_turning_hub(model_, body_) ? n - 1 : n; // the rotation is pinned
  }

  bool RotatingBody::turns_in_bearings(const std::vector<std::vector<double>> &motions) const
  {
    return model_.bodies[body_].floats && motions.size() == 1 && !has_turning_hub(model_, body_) &&
           is_turn(whole_, whole_.parts()[0], motions.front());
  }

  bool RotatingBody::deforms_at(const double rate) const
  {
    return rate != 0 || model_.bodies[body_].has_initial_strains();
  }

  std::vector<double> RotatingBody::find_equilibrium(const double rate) const
  {
    FemConstraints::Options options;
    options.rotation = options_.hold_hubs ? HubRotation::held : HubRotation::pinned;
    const FemSystem      system(space_, options, communicator_);
    const SystemMatrices matrices(system, options_.mass, options_.strain);
    const std::string    name =
      "body \"" + model_.bodies[body_].name() + "\" at " + std::to_string(rate * 30. / pi) + " rpm";
    const unsigned int n_free = count_free_motions();
    // A shaft that turns freely in its bearings is pinned at a ring, which carries nothing.
    std::vector<unsigned int> pinned;
    if (turns_in_bearings(find_free_motions(whole_, whole_.parts()[0])))
      pinned.push_back(body_);
    // Nothing holds the body: where it is balanced, the load does no work on rigid motions, and a
    // weak bed of springs only keeps the factorization from dividing by zero.
    const double bed =
      n_free > 0 ? -choose_shift(matrices.stiffness(constant_rate(rate)), matrices.mass()) : 0.;
    return find_spin_state(matrices,
                           constant_rate(rate),
                           true,
                           bed,
                           name,
                           [&](const FemMatrix &K) -> LinearSolve {
                             const auto solver =
                               std::make_shared<DirectSolver>(add_turn_pins(system, pinned, K));
                             // Spin softens what nothing holds: as many motions as are free may
                             // have a negative stiffness. On bearings, above a critical speed, so
                             // may others, which Coriolis forces keep stable; where the body is
                             // balanced, spin does no work on them.
                             const bool floats = model_.bodies[body_].floats;
                             if ((solver->n_negative() > n_free && !floats) || solver->n_zero() > 0)
                               throw NumericalError(name + ": no stable equilibrium (the speed" +
                                                    (model_.bodies[body_].has_initial_strains()
                                                       ? " or the temperature"
                                                       : "") +
                                                    " is too high)");
                             return [solver](OwnedVector &q) { solver->solve(q.data(), 1); };
                           })
      .displacements;
  }

  double RotatingMode::damping_ratio(const double zeta) const
  {
    // M u'' + (2 C + zeta M) u' + K u = 0, u = phi exp(lambda t): the first order of zeta is
    // delta lambda = -zeta omega m/(2 omega m + g), m = phi* M phi and g the skew part; with
    // omega^2 m + omega g = k this is -zeta omega^2 m/(omega^2 m + k) = -zeta T/(T + U).
    return frequency > 0 ? zeta * kinetic_share * (1. + rigid_damping) / (2. * pi * frequency)
                         : not_known;
  }

  ModesAtSpeed RotatingBody::find_modes(const double rate) const
  {
    ModesAtSpeed result;
    result.axis_point = model_.bodies[body_].axis.point;
    result.rate       = rate;
    std::vector<double> equilibrium;
    if (deforms_at(rate))
      {
        equilibrium = find_equilibrium(rate);
        for (std::size_t i = 0; i < equilibrium.size(); i += 3)
          result.growth =
            std::max(result.growth, Eigen::Map<const Vector3>(equilibrium.data() + i).norm());
      }
    result.counted = true;
    if (!options_.cyclic_symmetry)
      solve_harmonic(rate, equilibrium, 0, options_.n_modes, result);
    else if (options_.lowest_of_body)
      find_lowest(rate, equilibrium, result);
    else
      for (unsigned int h = 0; h <= std::min(largest_diameter(), options_.largest_diameter); ++h)
        solve_harmonic(rate, equilibrium, h, options_.n_modes, result);
    std::stable_sort(result.modes.begin(),
                     result.modes.end(),
                     [](const RotatingMode &a, const RotatingMode &b) {
                       return a.frequency < b.frequency;
                     });
    // As of the whole body: rigid motions are no waves, but are among the modes of these.
    const std::size_t kept = options_.n_modes - std::min(options_.n_modes, result.n_rigid);
    if (options_.lowest_of_body && options_.coriolis && rate != 0 && result.modes.size() > kept)
      result.modes.resize(kept);
    return result;
  }

  void RotatingBody::find_lowest(const double               rate,
                                 const std::vector<double> &equilibrium,
                                 ModesAtSpeed              &result) const
  {
    // The first search of a diameter, and diameters without a mode among the lowest that end it.
    constexpr unsigned int first_modes = 8, idle_diameters = 2;
    struct Diameter
    {
      unsigned int n_modes = 0;
      double       highest = 0; ///< found [Hz]
      ModesAtSpeed found;
    };
    std::vector<Diameter> diameters;
    // Frequency of the last of the lowest modes that are known; none where more are missing.
    const auto limit = [&] {
      std::vector<double> all;
      for (const Diameter &one : diameters)
        for (const RotatingMode &mode : one.found.modes)
          all.push_back(mode.frequency);
      if (all.size() < options_.n_modes)
        return std::numeric_limits<double>::infinity();
      std::nth_element(all.begin(), all.begin() + options_.n_modes - 1, all.end());
      return all[options_.n_modes - 1];
    };
    const auto solve = [&](const unsigned int h, const unsigned int n_modes) {
      Diameter &one     = diameters[h];
      one.n_modes       = n_modes;
      one.found         = ModesAtSpeed();
      one.found.counted = true;
      solve_harmonic(rate, equilibrium, h, n_modes, one.found);
      one.highest = 0;
      for (const RotatingMode &mode : one.found.modes)
        one.highest = std::max(one.highest, mode.frequency);
      // Shapes of the whole body are large: none is kept longer than it is of use.
      const double top = limit();
      for (Diameter &any : diameters)
        any.found.modes.erase(std::remove_if(any.found.modes.begin(),
                                             any.found.modes.end(),
                                             [top](const auto &mode) {
                                               return mode.frequency > top;
                                             }),
                              any.found.modes.end());
    };
    const unsigned int first = std::min(first_modes, options_.n_modes);
    for (unsigned int idle = 0; diameters.size() <= largest_diameter() && idle < idle_diameters;)
      {
        diameters.emplace_back();
        solve(diameters.size() - 1, first);
        idle = diameters.back().found.modes.empty() ? idle + 1 : 0;
      }
    for (unsigned int h = 0; h < diameters.size(); ++h)
      while (diameters[h].highest < limit() && diameters[h].n_modes < options_.n_modes)
        solve(h, std::min(2 * diameters[h].n_modes, options_.n_modes));
    for (Diameter &one : diameters)
      append(std::move(one.found), result);
  }

  std::vector<std::vector<double>> RotatingBody::rigid_motions(const FemSystem   &system,
                                                               const unsigned int harmonic) const
  {
    // Velocities at the body's axis and angular velocities that nothing opposes, a column each.
    const Axis           &axis    = model_.bodies[body_].axis;
    const Eigen::MatrixXd motions = find_free_coefficients(whole_, whole_.parts()[0], axis.point);
    if (motions.cols() == 0)
      return {};

    std::vector<std::vector<double>> list;
    const auto of_points = make_rigid_motions(space_, space_.parts()[0], axis.point);
    const auto field     = [&](const Vector6 &motion) {
      std::vector<double> sum(of_points.front().size(), 0.);
      for (unsigned int d = 0; d < 6; ++d)
        sum = add_scaled(std::move(sum), motion[d], of_points[d]);
      return sum;
    };
    const Vector3 a = axis.direction;
    for (Eigen::Index k = 0; k < motions.cols(); ++k)
      {
        Vector6 motion = motions.col(k);
        if (options_.hold_hubs && has_turning_hub(model_, body_))
          {
            const double whole = motion.norm();
            motion.tail<3>() -= a.dot(motion.tail<3>()) * a;
            if (motion.norm() < 1e-8 * whole)
              continue;
          }
        if (!options_.cyclic_symmetry)
          {
            list.push_back(field(motion));
            continue;
          }
        // Sectors have what lies along the axis in the harmonic 0, shifts and tilts v across it in
        // the harmonic 1: those of sector k are Re(R^k z exp(i k alpha)) = v with z = v + i a x v.
        const Vector3 along[] = {a * a.dot(motion.head<3>()), a * a.dot(motion.tail<3>())};
        Vector6       part;
        part << along[0], along[1];
        if (harmonic == 1)
          part = motion - part;
        if (harmonic > 1 || part.norm() < 1e-8 * motion.norm())
          continue;
        list.push_back(field(part));
        if (system.constraints().n_copies() == 2)
          {
            const Vector3 z = compute_sector_axis(model_.bodies[body_]).direction;
            Vector6       quarter;
            quarter << z.cross(part.head<3>()), z.cross(part.tail<3>());
            const std::vector<double> imaginary = field(quarter);
            list.back().insert(list.back().end(), imaginary.begin(), imaginary.end());
          }
      }
    return list;
  }

  void RotatingBody::solve_harmonic(const double               rate,
                                    const std::vector<double> &equilibrium,
                                    const unsigned int         harmonic,
                                    const unsigned int         n_modes,
                                    ModesAtSpeed              &result) const
  {
    FemConstraints::Options constraints;
    constraints.padded   = ModalSolver::needs_padding(options_);
    constraints.harmonic = harmonic;
    constraints.rotation = options_.hold_hubs ? HubRotation::held : HubRotation::free;
    const FemSystem      system(space_, constraints, communicator_);
    const SystemMatrices matrices(system, options_.mass, options_.strain);
    // About the equilibrium. Hubs that turn freely are not pinned: their rotation is a rigid mode.
    const FemMatrix K = !equilibrium.empty()
                          ? matrices.spinning_stiffness(equilibrium, constant_rate(rate))
                          : matrices.stiffness(constant_rate(0.));
    const FemMatrix M = matrices.mass();
    // Spin softens translations of a body that nothing holds, or soft bearings do, by this much;
    // the rotation of a hub, and of a shaft in bearings, is left with round-off.
    const bool         is_softened = count_free_motions() > 0 || model_.bodies[body_].floats;
    const double       lowest      = is_softened ? -rate * rate : -1e-3 * rate * rate;
    const auto         rigid       = rigid_motions(system, harmonic);
    const bool         with_waves  = options_.coriolis && rate != 0;
    const unsigned int most        = ModalSolver::largest_number(system.constraints().n());

    FemOptions options = options_;
    options.n_modes    = n_modes;
    for (unsigned int attempt = 0;; ++attempt)
      {
        const ModalResult found = ModalSolver(system, options).solve(K, M, lowest, rigid);
        ModesAtSpeed      part;
        bool              is_complete = true;
        if (with_waves)
          is_complete = add_waves(matrices, harmonic, rate, K, M, found, n_modes, part);
        else
          add_modes(matrices, harmonic, found, part);
        // The lowest waves may be made of modes that are not among the lowest.
        if (!is_complete && attempt < most_attempts && options.n_modes < most)
          {
            options.n_modes = std::min(most, options.n_modes + std::max(8u, options.n_modes / 4));
            continue;
          }
        part.n_rigid    = found.rigid.size();
        part.n_unknowns = found.n_unknowns;
        part.memory     = found.memory;
        part.counted    = found.counted && is_complete;
        append(std::move(part), result);
        return;
      }
  }

  std::array<double, 6>
  RotatingBody::compute_effective_mass(const std::vector<std::vector<double>> &loads,
                                       const unsigned int                      harmonic,
                                       const std::vector<double>              &shape) const
  {
    // r of a motion along and about the axis is in the harmonic 0, across it in the harmonic 1 as
    // in rigid_motions(). Over N sectors the squared norm of a shape of norm 1 is N, respectively
    // N/2, and so is its product with r over that of the sector.
    std::array<double, 6> effective = {};
    if (loads.empty())
      return effective;
    using Field               = Eigen::Map<const Eigen::VectorXd>;
    const Body       &body    = model_.bodies[body_];
    const std::size_t copy    = loads.front().size();
    const bool        is_pair = shape.size() > copy;
    const Vector3     a       = compute_sector_axis(body).direction;
    for (unsigned int d = 0; d < 6; ++d)
      {
        const Vector3 e = Vector3::Unit(d % 3), along = a * a.dot(e), across = e - along,
                      quarter = a.cross(across);
        double product        = 0;
        for (unsigned int c = 0; c < 3; ++c)
          {
            const Field load(loads[d / 3 * 3 + c].data(), copy);
            product += (harmonic == 0 ? along : across)[c] * load.dot(Field(shape.data(), copy));
            if (harmonic == 1 && is_pair)
              product += quarter[c] * load.dot(Field(shape.data() + copy, copy));
          }
        effective[d] = body.structure().n_sectors() / (harmonic == 0 ? 1. : 2.) * product * product;
      }
    return effective;
  }

  void RotatingBody::add_modes(const SystemMatrices &matrices,
                               const unsigned int    harmonic,
                               const ModalResult    &found,
                               ModesAtSpeed         &result) const
  {
    // M r of unit motions r, which sectors have in the harmonics 0 and 1.
    std::vector<std::vector<double>> loads;
    if (options_.cyclic_symmetry && harmonic <= 1)
      for (const auto &motion :
           make_rigid_motions(space_, space_.parts()[0], model_.bodies[body_].axis.point))
        loads.push_back(matrices.mass_forces(motion));
    for (const Mode &mode : found.modes)
      {
        if (!mode.is_rigid && mode.eigenvalue < -1e-3 * std::abs(found.shift))
          throw NumericalError("body \"" + model_.bodies[body_].name() +
                               "\" is not stable: a motion has a negative stiffness (speed too "
                               "high)");
        RotatingMode entry;
        // Round-off and softening give rigid motions small frequencies or imaginary ones.
        entry.frequency      = mode.is_rigid ? 0. : mode.frequency();
        entry.residual       = mode.residual;
        entry.effective_mass = options_.cyclic_symmetry
                                 ? compute_effective_mass(loads, harmonic, mode.shape)
                                 : mode.effective_mass;
        entry.shape          = whole_shape(mode.shape, harmonic);
        std::vector<double> none(entry.shape.size(), 0.);
        scale_to_one(entry.shape, none);
        entry.description = describer_.describe(entry.shape);
        result.modes.push_back(std::move(entry));
      }
  }

  bool RotatingBody::add_waves(const SystemMatrices &matrices,
                               const unsigned int    harmonic,
                               const double          rate,
                               const FemMatrix      &stiffness,
                               const FemMatrix      &mass,
                               const ModalResult    &found,
                               const unsigned int    n_asked,
                               ModesAtSpeed         &result) const
  {
    const FemSystem         &system = matrices.system();
    const DirectSolver       factors(add_scaled(stiffness, -found.shift, mass));
    const FemMatrix          coriolis = matrices.gyroscopic(constant_rate(rate));
    std::vector<OwnedVector> modes    = found.vectors;
    modes.insert(modes.end(), found.guards.begin(), found.guards.end());
    const unsigned int n_rigid = found.rigid.size();
    const auto         waves =
      find_gyroscopic_modes({stiffness, mass, coriolis, rate, factors, found.shift},
                            modes,
                            found.rigid,
                            n_asked - std::min(n_asked, n_rigid));
    for (const GyroscopicMode &wave : waves)
      {
        RotatingMode entry;
        entry.frequency               = wave.rate / (2. * pi);
        entry.residual                = wave.residual;
        entry.kinetic_share           = wave.kinetic_share;
        entry.shape                   = whole_shape(system.expand(wave.real), harmonic);
        std::vector<double> imaginary = whole_shape(system.expand(wave.imaginary), harmonic);
        scale_to_one(entry.shape, imaginary);
        entry.description = describer_.describe(entry.shape, imaginary);
        // Waves are named by the sense of the spin, descriptions by that of the axis.
        if (rate < 0)
          entry.description.forward = 1. - entry.description.forward;
        entry.rigid_damping =
          compute_rigid_damping(model_, body_, rate, wave.rate, entry.shape, imaginary);
        result.modes.push_back(std::move(entry));
      }
    // w^2 + 2 g w Omega = k/m of a wave, |g| <= 1: one that is made of modes above the highest has
    // k/m above their eigenvalue and (w + Omega)^2 - Omega^2 above it too.
    const double top = waves.empty() ? 0. : waves.back().rate;
    return found.highest >= top * (top + 2. * std::abs(rate));
  }

  std::vector<double> RotatingBody::whole_shape(const std::vector<double> &shape,
                                                const unsigned int         harmonic) const
  {
    const unsigned int n = shown().n_points();
    if (!options_.cyclic_symmetry)
      return std::vector<double>(shape.begin(), shape.begin() + 3 * std::size_t(n));

    // Sectors are turned about the line of the mesh, whatever the sense of the spin.
    const Body          &body    = model_.bodies[body_];
    const Vector3        axis    = compute_sector_axis(body).direction;
    const unsigned int   n_nodes = body.structure().nodes_per_sector();
    const std::size_t    copy    = 3 * static_cast<std::size_t>(space_.n_points());
    std::vector<Matrix3> turns;
    for (unsigned int k = 0; k < body.structure().n_sectors(); ++k)
      turns.push_back(rotation_about(axis, k * space_.sector_angle()));
    std::vector<double> whole;
    whole.reserve(3 * std::size_t(n));
    for (unsigned int point = 0; point < n; ++point)
      {
        const unsigned int k     = copies_ ? copies_->sector_of(point) : point / n_nodes;
        const std::size_t  i     = copies_ ? copies_->original_of(point) : point % n_nodes;
        const double       phase = harmonic * (k * space_.sector_angle());
        // u_k = Re(R^k (a + i b) exp(i h k angle)), a and b the two copies of the sector's points.
        Vector3 u = std::cos(phase) * Eigen::Map<const Vector3>(shape.data() + 3 * i);
        if (shape.size() > copy)
          u -= std::sin(phase) * Eigen::Map<const Vector3>(shape.data() + copy + 3 * i);
        u = (turns[k] * u).eval();
        whole.insert(whole.end(), u.data(), u.data() + 3);
      }
    return whole;
  }
} // namespace vfife
