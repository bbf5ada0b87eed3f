// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/cyclic/cyclic_sector.h>
#include <vfife/fem/cyclic/cyclic_statics.h>
#include <vfife/model/body_frame.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

// Unknowns of sector k are those of sector 0, turned by k sectors. Border 0 of a sector are the
// unknowns of its own points on the border to the sector before, border 1 those of the images on
// the border to the next one, which are border 0 of that.
namespace vfife
{
  CyclicStatics::CyclicStatics(const FemSpace       &whole,
                               const FemSpace::Part &part,
                               const FemOptions     &options,
                               const double          rate,
                               const BodySupports   &supports,
                               const Communicator   &communicator)
    : body_(whole.model(), part.body, options, rate)
    , copies_(body_.sector(), whole, part)
    , supports_(supports)
    , communicator_(communicator)
  {
    find_hub(whole.model(), part.body);
    if (!supports_.motions.empty() && body_.n_sectors() < 3)
      throw InputError("body \"" + body_.body().name() + "\" has two sectors on bearings");
    FemConstraints::Options constraints;
    constraints.open     = true;
    constraints.rotation = hub_;
    sector_ = std::make_unique<FemSystem>(body_.sector(), constraints, body_.communicator());
    matrices_ =
      std::make_unique<SystemMatrices>(*sector_, body_.options().mass, body_.options().strain);
    // The angle of a rigid hub is no unknown.
    const SectorUnknowns unknowns(*sector_);
    for (const auto &border : unknowns.borders)
      border_.insert(border_.end(), border.begin(), border.end());
    factorize();
  }

  void CyclicStatics::find_hub(const Model &model, const unsigned int body)
  {
    const Constraint *hub = nullptr;
    for (const Constraint &constraint : model.constraints)
      if (constraint.body == body && (constraint.kind == ConstraintKind::free_rotation ||
                                      constraint.kind == ConstraintKind::rigid_hub))
        {
          if (hub != nullptr || !body_.turns())
            throw InputError("body \"" + body_.body().name() + "\": constraint \"" +
                             constraint.name + "\" is not the only constraint of its rotation");
          hub = &constraint;
        }
    // The angle of a rigid hub is no unknown. Points that turn by themselves leave the turn of
    // h = 0, which is pinned where the whole body's is: at the hub's first point.
    if (hub != nullptr && hub->kind == ConstraintKind::free_rotation)
      {
        hub_    = HubRotation::free;
        pinned_ = true;
        pin_    = *std::min_element(hub->nodes.begin(), hub->nodes.end());
      }
  }

  void CyclicStatics::factorize()
  {
    const FemMatrix K = body_.stiffness(*matrices_);
    condensed_        = std::make_unique<Condensation>(K, border_);
    if (!supports_.motions.empty())
      stiffness_ = std::make_unique<SparseMatrix>(K);
    const Eigen::MatrixXd         &S      = condensed_->border_matrix();
    const std::vector<BorderBrace> braces = make_braces(S);
    bool unstable = condensed_->n_negative() > 0 || condensed_->n_zero() > 0;
    if (!unstable)
      {
        borders_ = std::make_unique<BorderHarmonics>(S, body_.n_sectors(), braces, communicator_);
        unstable = !borders_->is_positive();
      }
    // The matrix of the whole body has as many negative eigenvalues as its parts.
    if (communicator_.any(unstable))
      refuse();
    if (!braces.empty())
      correct(braces);
  }

  void CyclicStatics::refuse() const
  {
    throw NumericalError("body \"" + body_.body().name() +
                         "\": no stable equilibrium (the speed is too high)");
  }

  std::vector<BorderBrace> CyclicStatics::make_braces(const Eigen::MatrixXd &S) const
  {
    std::vector<BorderBrace> braces;
    const Eigen::Index       n         = border_.size() / 2; // border 0
    const auto               of_border = [&](const std::vector<double> &field) {
      const OwnedVector motion = sector_->restrict_field(field);
      Eigen::VectorXd   x(n);
      for (Eigen::Index b = 0; b < n; ++b)
        x[b] = motion[border_[b]];
      return x;
    };
    if (supports_.motions.empty())
      {
        if (pinned_)
          {
            const Eigen::VectorXd turn = of_border(body_.rigid_turn());
            braces.push_back({0, turn.cast<Complex>(), S.trace() / turn.squaredNorm()});
          }
        return braces;
      }
    // About as stiff as the supports, since braces much stiffer than these cost digits, and stiffer
    // than spin softens the motion.
    const auto energy = [&](const std::vector<double> &u) {
      const Eigen::VectorXd     d      = displacements_of_supports(u);
      const std::vector<double> forces = apply_stiffness(u);
      return std::max(d.dot(supports_.stiffness * d),
                      4. * std::abs(std::inner_product(u.begin(), u.end(), forces.begin(), 0.)));
    };
    const auto add = [&](const unsigned int harmonic, const Eigen::VectorXcd &z, const double e) {
      const double square = z.squaredNorm(), n = (harmonic == 0 ? 1. : .5) * body_.n_sectors();
      if (square > 0)
        braces.push_back({harmonic, z, e > 0 ? e / (n * square * square) : S.trace() / square});
    };
    const auto part = [&](const std::vector<double> &u) {
      return Eigen::VectorXcd(of_border(of_sector(0, u)).cast<Complex>());
    };
    for (const bool turns : {false, true})
      {
        // A motion along x is, in the axes of sector k, along x cos(k alpha) - y sin(k alpha).
        const std::vector<double> x = rigid_motion(0, turns), y = rigid_motion(1, turns),
                                  z = rigid_motion(2, turns);
        add(0, part(z), energy(z));
        add(1, part(x) + Complex(0., 1.) * part(y), std::max(energy(x), energy(y)));
      }
    return braces;
  }

  std::vector<double> CyclicStatics::rigid_motion(const unsigned int axis, const bool turns) const
  {
    const Axis          line = compute_sector_axis(body_.body());
    const Vector3       way  = axes_along(line.direction).col(axis);
    std::vector<double> u(3 * std::size_t(copies_.n_points()));
    // About a point of the axis in the middle of the body: about one beside it turns across the
    // axis are little else than shifts.
    double height = 0;
    for (const unsigned int p : copies_.own_points())
      height +=
        line.direction.dot(body_.sector().points()[p] - line.point) / copies_.own_points().size();
    const Vector3 centre = line.point + height * line.direction;
    for (unsigned int k = 0; k < body_.n_sectors(); ++k)
      {
        const Matrix3 turn = turned(k);
        for (const unsigned int p : copies_.own_points())
          Eigen::Map<Vector3>(u.data() + 3 * std::size_t(copies_.copy(p, k))) =
            turns ? way.cross(turn * (body_.sector().points()[p] - centre)) : way;
      }
    return u;
  }

  Eigen::VectorXd CyclicStatics::displacements_of_supports(const std::vector<double> &u) const
  {
    Eigen::VectorXd displacements(supports_.stiffness.rows());
    Eigen::Index    row = 0;
    for (const PointMotion &motion : supports_.motions)
      {
        displacements.segment(row, motion.motion.rows()) = motion.displacement(u);
        row += motion.motion.rows();
      }
    return displacements;
  }

  void CyclicStatics::correct(const std::vector<BorderBrace> &braces)
  {
    // 1. Columns of U on the unknowns of all sectors, and those of C^-1.
    const unsigned int           n_sectors = body_.n_sectors();
    const RootsOfUnity           phase(n_sectors);
    std::vector<Eigen::MatrixXd> columns;
    std::vector<double>          inverse;
    for (const BorderBrace &brace : braces)
      for (unsigned int part = 0; part < (brace.harmonic == 0 ? 1 : 2); ++part)
        {
          Eigen::MatrixXd x = Eigen::MatrixXd::Zero(sector_->constraints().n(), n_sectors);
          for (unsigned int k = 0; k < n_sectors; ++k)
            for (Eigen::Index i = 0; i < brace.motion.size(); ++i)
              {
                const Complex value = brace.motion[i] * phase(brace.harmonic, k);
                x(border_[i], k)    = part == 0 ? value.real() : value.imag();
              }
          columns.push_back(std::move(x));
          // The stiffness of a phasor is that of the sectors times N, or N/2 in h = 1.
          inverse.push_back(-(brace.harmonic == 0 ? 1. : .5) * n_sectors / brace.stiffness);
        }
    if (!supports_.motions.empty())
      add_supports(columns, inverse);
    if (pinned_)
      {
        const Body         &body = body_.body();
        std::vector<double> force(3 * std::size_t(copies_.n_points()), 0.);
        Eigen::Map<Vector3>(force.data() + 3 * std::size_t(pin_)) =
          body.axis.direction.cross(body.placement(body.node_positions()[pin_]) - body.axis.point)
            .normalized();
        columns.push_back(restrict_forces(force));
        inverse.push_back(0.);
      }

    // 2. C^-1 + U^T A U.
    const Eigen::Index m = columns.size();
    correction_fields_.resize(3 * static_cast<Eigen::Index>(copies_.n_points()), m);
    Eigen::MatrixXd system =
      Eigen::Map<const Eigen::VectorXd>(inverse.data(), m).asDiagonal().toDenseMatrix();
    for (Eigen::Index j = 0; j < m; ++j)
      {
        const Eigen::MatrixXd answer = solve_sectors(columns[j]);
        for (Eigen::Index i = 0; i < m; ++i)
          system(i, j) += columns[i].cwiseProduct(answer).sum();
        const std::vector<double> field = expand(answer);
        correction_fields_.col(j) = Eigen::Map<const Eigen::VectorXd>(field.data(), field.size());
      }
    system      = .5 * (system + system.transpose()).eval();
    correction_ = system.inverse();

    // 3. Negative eigenvalues of K are the positive ones of this matrix beyond those of C^-1
    // (Sylvester). Above a critical speed shifts and tilts may have some, which Coriolis forces
    // keep stable.
    Eigen::VectorXd scale(m);
    for (Eigen::Index i = 0; i < m; ++i)
      scale[i] = 1. / std::sqrt(inverse[i] != 0. ? std::abs(inverse[i]) : system(i, i));
    const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scale.asDiagonal() * system *
                                                       scale.asDiagonal(),
                                                     Eigen::EigenvaluesOnly)
        .eigenvalues();
    const auto n_springs =
      std::count_if(inverse.begin(), inverse.end(), [](const double c) { return c >= 0.; });
    const auto n_negative = (values.array() > 0.).count() - n_springs;
    if (n_negative > (body_.body().floats && body_.rate() != 0. ? 4 : 0))
      refuse();
  }

  void CyclicStatics::add_supports(std::vector<Eigen::MatrixXd> &columns,
                                   std::vector<double>          &inverse) const
  {
    // K0 = Q diag(lambda) Q^T, in units in which its diagonal is one.
    const Eigen::MatrixXd &K0 = supports_.stiffness;
    const Eigen::VectorXd  scale =
      K0.diagonal().unaryExpr([](const double k) { return k > 0. ? std::sqrt(k) : 1.; });
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      scale.cwiseInverse().asDiagonal() * K0 * scale.cwiseInverse().asDiagonal());
    for (Eigen::Index j = 0; j < K0.rows(); ++j)
      {
        if (solver.eigenvalues()[j] < 1e-12)
          continue;
        const Eigen::VectorXd load = scale.cwiseProduct(solver.eigenvectors().col(j));
        columns.push_back(restrict_forces(spread(load)));
        inverse.push_back(1. / solver.eigenvalues()[j]);
      }
  }

  std::vector<double> CyclicStatics::spread(const Eigen::VectorXd &loads) const
  {
    std::vector<double> forces(3 * std::size_t(copies_.n_points()), 0.);
    Eigen::Index        row = 0;
    for (const PointMotion &motion : supports_.motions)
      {
        motion.add_forces(loads.segment(row, motion.motion.rows()), forces);
        row += motion.motion.rows();
      }
    return forces;
  }

  Matrix3 CyclicStatics::turned(const unsigned int sector) const
  {
    return rotation_about(compute_sector_axis(body_.body()).direction,
                          sector * body_.sector().sector_angle());
  }

  void CyclicStatics::add_sector(const unsigned int         k,
                                 const std::vector<double> &u,
                                 std::vector<double>       &all) const
  {
    const Matrix3 turn = turned(k);
    for (const unsigned int p : copies_.own_points())
      Eigen::Map<Vector3>(all.data() + 3 * std::size_t(copies_.copy(p, k))) =
        turn * Eigen::Map<const Vector3>(u.data() + 3 * std::size_t(p));
  }

  std::vector<double> CyclicStatics::of_sector(const unsigned int         k,
                                               const std::vector<double> &u) const
  {
    std::vector<double> field(3 * std::size_t(body_.sector().n_points()), 0.);
    const Matrix3       back = turned(k).transpose();
    const auto          take = [&](const unsigned int p, const unsigned int copy) {
      Eigen::Map<Vector3>(field.data() + 3 * std::size_t(p)) =
        back * Eigen::Map<const Vector3>(u.data() + 3 * std::size_t(copy));
    };
    for (const unsigned int p : copies_.own_points())
      take(p, copies_.copy(p, k));
    for (const auto &[image, original] : body_.sector().images())
      take(image, copies_.copy(original, (k + 1) % body_.n_sectors()));
    return field;
  }

  std::vector<double>
  CyclicStatics::sum_sectors(const std::function<OwnedVector(unsigned int sector)> &forces) const
  {
    std::vector<double> all(3 * std::size_t(copies_.n_points()), 0.);
    for (unsigned int k = 0; k < body_.n_sectors(); ++k)
      {
        std::vector<double> of_points = sector_->expand(forces(k));
        // Points that hang have no forces of their own.
        for (const auto &[point, masters] : body_.sector().hanging())
          std::fill_n(of_points.begin() + 3 * std::size_t(point), 3, 0.);
        const Matrix3 turn = turned(k);
        const auto    add  = [&](const unsigned int p, const unsigned int copy) {
          Eigen::Map<Vector3>(all.data() + 3 * std::size_t(copy)) +=
            turn * Eigen::Map<const Vector3>(of_points.data() + 3 * std::size_t(p));
        };
        for (const unsigned int p : copies_.own_points())
          add(p, copies_.copy(p, k));
        for (const auto &[image, original] : body_.sector().images())
          add(image, copies_.copy(original, (k + 1) % body_.n_sectors()));
      }
    return all;
  }

  std::vector<double> CyclicStatics::apply_stiffness(const std::vector<double> &u) const
  {
    return sum_sectors([&](const unsigned int k) {
      return stiffness_->apply(sector_->restrict_field(of_sector(k, u)));
    });
  }

  std::vector<double> CyclicStatics::apply_mass(const std::vector<double> &u) const
  {
    return sum_sectors(
      [&](const unsigned int k) { return matrices_->apply_mass(of_sector(k, u)); });
  }

  std::vector<double> CyclicStatics::spun() const
  {
    std::vector<double> u(3 * std::size_t(copies_.n_points()));
    for (unsigned int k = 0; k < body_.n_sectors(); ++k)
      add_sector(k, body_.equilibrium(), u);
    if (supports_.motions.empty() || !body_.deforms())
      return u;
    // The sector's state has supports as one harmonic knows them: a step of Newton's method to
    // those of the body.
    const OwnedVector residual =
      matrices_->spinning_residual(body_.equilibrium(), constant_rate(body_.rate()), true);
    std::vector<double> forces = sum_sectors([&](unsigned int) { return residual; });
    forces                     = add_scaled(std::move(forces),
                        1.,
                        spread(-supports_.stiffness * displacements_of_supports(u)));
    return add_scaled(std::move(u), 1., solve(forces));
  }

  Eigen::MatrixXd CyclicStatics::restrict_forces(const std::vector<double> &forces) const
  {
    // Forces of each sector in the axes of sector 0; none on the images of the next one's.
    std::vector<double> at_points(3 * std::size_t(body_.sector().n_points()), 0.);
    Eigen::MatrixXd     x(sector_->constraints().n(), body_.n_sectors());
    for (unsigned int k = 0; k < body_.n_sectors(); ++k)
      {
        const Matrix3 back = turned(k).transpose();
        for (const unsigned int p : copies_.own_points())
          Eigen::Map<Vector3>(at_points.data() + 3 * std::size_t(p)) =
            back * Eigen::Map<const Vector3>(forces.data() + 3 * std::size_t(copies_.copy(p, k)));
        const OwnedVector loads = sector_->restrict_forces(at_points);
        x.col(k)                = Eigen::Map<const Eigen::VectorXd>(loads.data(), loads.size());
      }
    return x;
  }

  std::vector<double> CyclicStatics::expand(const Eigen::MatrixXd &x) const
  {
    std::vector<double> u(3 * std::size_t(copies_.n_points()));
    for (unsigned int k = 0; k < body_.n_sectors(); ++k)
      add_sector(k, sector_->expand(OwnedVector(x.col(k).data(), x.col(k).data() + x.rows())), u);
    return u;
  }

  Eigen::MatrixXd CyclicStatics::solve_sectors(Eigen::MatrixXd x) const
  {
    // Down to the borders, around the body, and back. Loads of h = 0 and 1, as those of a torque or
    // a bearing, are three columns times their waves around the body.
    Eigen::MatrixXd waves(body_.n_sectors(), 3);
    for (unsigned int k = 0; k < body_.n_sectors(); ++k)
      waves.row(k) << 1., std::cos(k * body_.sector().sector_angle()),
        std::sin(k * body_.sector().sector_angle());
    waves.colwise().normalize();
    Eigen::MatrixXd of_waves = x * waves;
    const bool      is_slow =
      body_.n_sectors() > 2 && (x - of_waves * waves.transpose()).norm() <= 1e-13 * x.norm();
    Eigen::MatrixXd &loads = is_slow ? of_waves : x;
    condensed_->solve(loads, [&](const Eigen::MatrixXd &on_borders) -> Eigen::MatrixXd {
      if (is_slow)
        return borders_->solve(on_borders * waves.transpose()) * waves;
      return borders_->solve(on_borders);
    });
    return is_slow ? Eigen::MatrixXd(of_waves * waves.transpose()) : x;
  }

  std::vector<double> CyclicStatics::solve(const std::vector<double> &forces) const
  {
    std::vector<double> u = expand(solve_sectors(restrict_forces(forces)));
    if (correction_.size() > 0)
      Eigen::Map<Eigen::VectorXd>(u.data(), u.size()) -=
        correction_fields_ *
        (correction_ * (correction_fields_.transpose() *
                        Eigen::Map<const Eigen::VectorXd>(forces.data(), forces.size())));
    return u;
  }

  void CyclicStatics::watch(std::vector<Watched> points)
  {
    // 1. The points as copies of those of sector 0.
    watched_ = std::move(points);
    std::map<Copy, const Watched *> originals;
    std::set<unsigned int>          sectors;
    for (const Watched &watched : watched_)
      {
        const unsigned int sector = copies_.sector_of(watched.point);
        for (const auto &weight : watched.weights)
          if (copies_.sector_of(weight.first) != sector)
            throw InputError("body \"" + body_.body().name() +
                             "\": a contact surface crosses the border of two sectors");
        originals.emplace(copy_of(watched), &watched);
        sectors.insert(sector);
      }
    watched_fields_.resize(3 * watched_.size(), correction_fields_.cols());
    for (std::size_t i = 0; i < watched_.size(); ++i)
      {
        watched_fields_.middleRows<3>(3 * i).setZero();
        for (const auto &[point, weight] : watched_[i].weights)
          watched_fields_.middleRows<3>(3 * i) +=
            weight * correction_fields_.middleRows<3>(3 * std::size_t(point));
      }
    // Flexibilities of more points and sectors serve fewer of them.
    std::vector<Copy> locals;
    for (const auto &original : originals)
      locals.push_back(original.first);
    std::set<unsigned int> distances;
    for (const unsigned int from : sectors)
      for (const unsigned int to : sectors)
        distances.insert((to + body_.n_sectors() - from) % body_.n_sectors());
    if (std::includes(locals_.begin(), locals_.end(), locals.begin(), locals.end()) &&
        std::all_of(distances.begin(), distances.end(), [this](const unsigned int d) {
          return flexibility_.count(d) != 0;
        }))
      return;
    locals_ = std::move(locals);
    flexibility_.clear();
    if (watched_.empty())
      return;

    // 2. Unit forces at these points: what the sector does with its borders held, and the loads on
    // them. The transpose of these is what the points do as the borders move.
    const unsigned int  m = 3 * locals_.size();
    Eigen::MatrixXd     x(sector_->constraints().n(), m), loads;
    std::vector<double> unit(3 * std::size_t(body_.sector().n_points()), 0.);
    for (unsigned int i = 0; i < m; ++i)
      {
        const auto set = [&](const double force) {
          for (const auto &[point, weight] : originals.at(locals_[i / 3])->weights)
            unit[3 * std::size_t(copies_.original_of(point)) + i % 3] = force * weight;
        };
        set(1.);
        const OwnedVector force = sector_->restrict_forces(unit);
        x.col(i)                = Eigen::Map<const Eigen::VectorXd>(force.data(), force.size());
        set(0.);
      }
    const Eigen::MatrixXd forces = x;
    condensed_->solve(x, [&loads](const Eigen::MatrixXd &on_borders) -> Eigen::MatrixXd {
      loads = on_borders;
      return Eigen::MatrixXd::Zero(on_borders.rows(), on_borders.cols());
    });

    // 3. Around the body, for all pairs of sectors that are asked for.
    flexibility_ = borders_->find_flexibility(loads, distances);
    flexibility_.at(0) += forces.transpose() * x;
  }

  Eigen::VectorXd CyclicStatics::column(const std::size_t  watched,
                                        const unsigned int component) const
  {
    const unsigned int n_sectors = body_.n_sectors();
    const auto         local     = [&](const Watched &point) {
      return 3 *
             (std::lower_bound(locals_.begin(), locals_.end(), copy_of(point)) - locals_.begin());
    };
    // The force in the axes of its sector, each displacement in those of its own.
    const unsigned int at = watched_[watched].point, from = copies_.sector_of(at);
    const Vector3      force = turned(from).transpose().col(component);
    Eigen::VectorXd    u(3 * watched_.size());
    for (std::size_t i = 0; i < watched_.size(); ++i)
      {
        const unsigned int     to = copies_.sector_of(watched_[i].point);
        const Eigen::MatrixXd &A  = flexibility_.at((to + n_sectors - from) % n_sectors);
        u.segment<3>(3 * i) =
          turned(to) * A.block<3, 3>(local(watched_[i]), local(watched_[watched])) * force;
      }
    if (correction_.size() > 0)
      u -=
        watched_fields_ * (correction_ * watched_fields_.row(3 * watched + component).transpose());
    return u;
  }

  CyclicStatics::Copy CyclicStatics::copy_of(const Watched &watched) const
  {
    return {copies_.original_of(watched.point), watched.kind};
  }

  unsigned int CyclicStatics::n_unknowns() const
  {
    return body_.n_sectors() * (sector_->constraints().n() - borders_->n_unknowns()) -
           (pinned_ ? 1 : 0);
  }

  double CyclicStatics::memory() const
  {
    return condensed_->memory() + borders_->memory();
  }
} // namespace vfife
