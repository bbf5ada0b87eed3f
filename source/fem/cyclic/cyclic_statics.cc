// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/cyclic/cyclic_sector.h>
#include <vfife/fem/cyclic/cyclic_statics.h>
#include <vfife/model/body_frame.h>

#include <algorithm>
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
                               const Communicator   &communicator)
    : body_(whole.model(), part.body, options, rate)
    , copies_(body_.sector(), whole, part)
    , communicator_(communicator)
  {
    find_hub(whole.model(), part.body);
    FemConstraints::Options constraints;
    constraints.open     = true;
    constraints.rotation = hub_;
    sector_ = std::make_unique<FemSystem>(body_.sector(), constraints, body_.communicator());
    // No bearings, and the angle of a rigid hub is no unknown.
    border_ = SectorUnknowns(*sector_).kept();
    factorize();
    if (pinned_)
      find_pin();
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
    const SystemMatrices matrices(*sector_, body_.options().mass, body_.options().strain);
    condensed_               = std::make_unique<Condensation>(body_.stiffness(matrices), border_);
    const Eigen::MatrixXd &S = condensed_->border_matrix();
    if (pinned_)
      {
        turn_.motion    = turn_of_border();
        turn_.stiffness = S.trace() / turn_.motion.squaredNorm();
      }
    bool unstable = condensed_->n_negative() > 0 || condensed_->n_zero() > 0;
    if (!unstable)
      {
        borders_ = std::make_unique<BorderHarmonics>(S, body_.n_sectors(), turn_, communicator_);
        unstable = !borders_->is_positive();
      }
    // The matrix of the whole body has as many negative eigenvalues as its parts.
    if (communicator_.any(unstable))
      throw NumericalError("body \"" + body_.body().name() +
                           "\": no stable equilibrium (the speed is too high)");
  }

  Matrix3 CyclicStatics::turned(const unsigned int sector) const
  {
    return rotation_about(compute_sector_axis(body_.body()).direction,
                          sector * body_.sector().sector_angle());
  }

  Eigen::VectorXd CyclicStatics::turn_of_border() const
  {
    const OwnedVector turn = sector_->restrict_field(body_.turn());
    Eigen::VectorXd   x(border_.size() / 2); // of both borders
    for (Eigen::Index b = 0; b < x.size(); ++b)
      x[b] = turn[border_[b]];
    return x;
  }

  void CyclicStatics::find_pin()
  {
    // What is factorized is K + s b b^T, b the turn of all borders, since K alone has next to no
    // stiffness against it. K u = f + lambda e with e . u = 0 at the pin: u = A f + lambda A e +
    // mu A b with A = (K + s b b^T)^-1 and mu = s b . u, which gives two equations for both.
    const unsigned int n_sectors = body_.n_sectors();
    const Body        &body      = body_.body();
    const Vector3      tangent =
      body.axis.direction.cross(body.placement(body.node_positions()[pin_]) - body.axis.point)
        .normalized();
    std::vector<double> force(3 * std::size_t(copies_.n_points()), 0.);
    Eigen::Map<Vector3>(force.data() + 3 * std::size_t(pin_)) = tangent;

    Eigen::MatrixXd b = Eigen::MatrixXd::Zero(sector_->constraints().n(), n_sectors);
    for (Eigen::Index i = 0; i < turn_.motion.size(); ++i)
      b.row(border_[i]).setConstant(turn_.motion[i]);
    const Eigen::MatrixXd     Ab      = solve_sectors(b);
    const std::vector<double> of_pin  = expand(solve_sectors(restrict_forces(force))),
                              of_turn = expand(Ab);
    pin_fields_.resize(force.size(), 2);
    pin_fields_ << Eigen::Map<const Eigen::VectorXd>(of_pin.data(), of_pin.size()),
      Eigen::Map<const Eigen::VectorXd>(of_turn.data(), of_turn.size());
    Eigen::Matrix2d system;
    system.row(0)   = tangent.transpose() * pin_fields_.middleRows<3>(3 * std::size_t(pin_));
    system(1, 0)    = system(0, 1);
    system(1, 1)    = b.cwiseProduct(Ab).sum() - n_sectors / turn_.stiffness;
    pin_compliance_ = system.inverse();
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

  std::vector<double> CyclicStatics::spun() const
  {
    std::vector<double> u(3 * std::size_t(copies_.n_points()));
    for (unsigned int k = 0; k < body_.n_sectors(); ++k)
      add_sector(k, body_.equilibrium(), u);
    return u;
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
    // Down to the borders, around the body, and back.
    condensed_->solve(x, [this](const Eigen::MatrixXd &loads) { return borders_->solve(loads); });
    return x;
  }

  std::vector<double> CyclicStatics::solve(const std::vector<double> &forces) const
  {
    std::vector<double> u = expand(solve_sectors(restrict_forces(forces)));
    if (pinned_)
      Eigen::Map<Eigen::VectorXd>(u.data(), u.size()) -=
        pin_fields_ *
        (pin_compliance_ * (pin_fields_.transpose() *
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
    Eigen::Vector2d    held  = Eigen::Vector2d::Zero();
    if (pinned_)
      held = pin_compliance_ * pin_field_of(watched_[watched]).row(component).transpose();
    Eigen::VectorXd u(3 * watched_.size());
    for (std::size_t i = 0; i < watched_.size(); ++i)
      {
        const unsigned int     to = copies_.sector_of(watched_[i].point);
        const Eigen::MatrixXd &A  = flexibility_.at((to + n_sectors - from) % n_sectors);
        u.segment<3>(3 * i) =
          turned(to) * A.block<3, 3>(local(watched_[i]), local(watched_[watched])) * force;
        if (pinned_)
          u.segment<3>(3 * i) -= pin_field_of(watched_[i]) * held;
      }
    return u;
  }

  CyclicStatics::Copy CyclicStatics::copy_of(const Watched &watched) const
  {
    return {copies_.original_of(watched.point), watched.kind};
  }

  Eigen::MatrixXd CyclicStatics::pin_field_of(const Watched &watched) const
  {
    Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(3, pin_fields_.cols());
    for (const auto &[point, weight] : watched.weights)
      mean += weight * pin_fields_.middleRows<3>(3 * std::size_t(point));
    return mean;
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
