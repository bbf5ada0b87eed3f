// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later

#include <vfife/base/errors.h>
#include <vfife/base/types.h>
#include <vfife/fem/cyclic/cyclic_harmonic.h>
#include <vfife/fem/solvers/direct_solver.h>
#include <vfife/fem/solvers/sparse_matrix.h>
#include <vfife/fem/system/turn_pins.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <numeric>

// A phasor z = a + i b of a sector is the vector (a, b) of two copies of its points; i z is (-b,
// a). Matrices of the two copies commute with that, and x^T A y = Re(z^H A w) of the phasors of x
// and y.

namespace vfife
{
  namespace
  {
    using PhasorRows = Eigen::SparseMatrix<Complex, Eigen::RowMajor>;

    /** What the rows read of a harmonic's unknowns: phasors. The real part, transposed, are unit
     * forces along the rows, the same in all sectors but for the phase. */
    PhasorRows make_phasor_rows(const FemSystem              &system,
                                const unsigned int            harmonic,
                                const std::vector<SectorRow> &rows)
    {
      const FemConstraints                &constraints = system.constraints();
      const std::size_t                    copy        = 3 * std::size_t(system.space().n_points());
      const double                         angle       = harmonic * system.space().sector_angle();
      std::vector<Eigen::Triplet<Complex>> entries;
      for (std::size_t i = 0; i < rows.size(); ++i)
        for (const SectorTerm &term : rows[i])
          for (unsigned int part = 0; part < constraints.n_copies(); ++part)
            {
              const Complex phase =
                std::polar(1., term.sector * angle) * (part == 0 ? Complex(1.) : Complex(0., 1.));
              for (unsigned int c = 0; c < 3; ++c)
                {
                  const std::size_t row = part * copy + 3 * std::size_t(term.point) + c;
                  for (const auto &[unknown, coefficient] : constraints.line(row))
                    entries.emplace_back(i, unknown, phase * (term.weight[c] * coefficient));
                }
            }
      PhasorRows matrix(rows.size(), constraints.n());
      matrix.setFromTriplets(entries.begin(), entries.end());
      return matrix;
    }

    FemConstraints::Options options_of(const unsigned int harmonic, const HubRotation rotation)
    {
      FemConstraints::Options options;
      options.harmonic = harmonic;
      options.rotation = rotation;
      return options;
    }

    Eigen::Map<const Eigen::VectorXd> as_vector(const OwnedVector &x)
    {
      return {x.data(), static_cast<Eigen::Index>(x.size())};
    }

    Eigen::MatrixXd as_matrix(const std::vector<OwnedVector> &vectors)
    {
      Eigen::MatrixXd X(vectors.empty() ? 0 : vectors.front().size(), vectors.size());
      for (std::size_t k = 0; k < vectors.size(); ++k)
        X.col(k) = as_vector(vectors[k]);
      return X;
    }

    /** The unknowns of -i z. */
    OwnedVector turn_back_by_quarter(const FemSystem &system, const OwnedVector &q)
    {
      const std::vector<double> u = system.expand(q);
      const std::size_t         n = u.size() / 2;
      std::vector<double>       turned(u.begin() + n, u.end());
      for (std::size_t i = 0; i < n; ++i)
        turned.push_back(-u[i]);
      return system.restrict_field(turned);
    }

    /** Phasors z_j^H A z_l of a real basis. */
    class PhasorProducts
    {
    public:
      PhasorProducts(const FemSystem &system, const std::vector<OwnedVector> &vectors)
        : vectors_(vectors)
      {
        if (system.constraints().n_copies() == 2)
          for (const OwnedVector &x : vectors)
            turned_.push_back(turn_back_by_quarter(system, x));
      }

      Eigen::MatrixXcd of(const FemMatrix &A) const
      {
        const SparseMatrix matrix(A);
        Eigen::MatrixXcd   products = matrix.project(vectors_, vectors_).cast<Complex>();
        if (!turned_.empty())
          // Im(z^H A w) = Re(z^H A (-i w))
          products += Complex(0., 1.) * matrix.project(vectors_, turned_);
        return products;
      }

    private:
      const std::vector<OwnedVector> &vectors_;
      std::vector<OwnedVector>        turned_;
    };

    Eigen::MatrixXcd hermitian_part(const Eigen::MatrixXcd &A)
    {
      return .5 * (A + A.adjoint());
    }

    /** Right sides solved for at once: enough for the solver's dense blocks. */
    constexpr unsigned int block = 64;
  } // namespace

  CyclicHarmonic::CyclicHarmonic(const CyclicBody &body, const unsigned int number)
    : body_(body)
    , number_(number)
    , system_(body.sector(), options_of(number, body.rotation()), body.communicator())
    , matrices_(system_, body.options().mass, body.options().strain)
    , K_(body.stiffness(matrices_))
    , M_(matrices_.mass())
  {
    if (number == 0 && body.turns())
      pinned_ = std::make_unique<FemSystem>(body.sector(),
                                            options_of(0, HubRotation::pinned),
                                            body.communicator());
  }

  CyclicHarmonic::~CyclicHarmonic() = default;

  double CyclicHarmonic::scale() const
  {
    // All sectors together: the mean of cos^2 over them is one half, where they are not alike.
    const unsigned int n = body_.n_sectors();
    return std::sqrt((system_.constraints().n_copies() == 2 ? 2. : 1.) / n);
  }

  unsigned int CyclicHarmonic::count_modes(double &limit)
  {
    // A double value of the two copies at the cut-off itself may be cut in two by round-off.
    unsigned int n_below = 0;
    for (unsigned int attempt = 0; attempt < 3; ++attempt)
      {
        const DirectSolver count(add_scaled(K_, -limit, M_));
        n_below = count.n_negative();
        memory_ = std::max(memory_, count.memory());
        if (n_below % system_.constraints().n_copies() == 0)
          break;
        limit *= 1. + 1e-7;
      }
    return n_below;
  }

  CyclicModes CyclicHarmonic::find_modes(const double cutoff)
  {
    double             limit     = cutoff * cutoff;
    const unsigned int n_below   = count_modes(limit);
    const bool         with_turn = pinned_ != nullptr;
    if (n_below <= (with_turn ? 1u : 0u))
      return {};
    const unsigned int most = ModalSolver::largest_number(system_.constraints().n());
    if (n_below > most)
      throw InputError("body \"" + body_.body().name() + "\": its mesh has " +
                       std::to_string(n_below) + " modes of " + std::to_string(number_) +
                       " nodal diameters below the cut-off, too many for its " +
                       std::to_string(system_.constraints().n()) +
                       " unknowns; lower the cut-off or refine the mesh");

    // As many of them as there are; where the search has missed one, more.
    FemOptions options  = body_.options();
    options.count_modes = false;
    for (unsigned int attempt = 0; attempt < 3; ++attempt)
      {
        options.n_modes = std::min(most, n_below + 4 * attempt);
        const ModalSolver solver(system_, options);
        // Round-off leaves the turn this much, spin takes it from shifts in bearings, as in
        // RotatingBody.
        const double lowest = body_.whirls(number_) ? -1. : with_turn ? -1e-3 : 0.;
        ModalResult  found  = solver.solve(K_, M_, lowest * body_.rate() * body_.rate());
        memory_             = std::max(memory_, found.memory);
        std::vector<double> eigenvalues;
        for (const Mode &mode : found.modes)
          if (mode.eigenvalue < limit)
            eigenvalues.push_back(mode.eigenvalue);
        if (eigenvalues.size() != n_below)
          continue;
        found.vectors.resize(n_below);

        // Phasors of them, each mode once.
        if (with_turn)
          return without_turn(std::move(found.vectors), eigenvalues);
        if (system_.constraints().n_copies() == 2)
          return make_complex(found.vectors);
        return {Eigen::Map<Eigen::VectorXd>(eigenvalues.data(), n_below),
                std::move(found.vectors),
                scale() * Eigen::MatrixXcd::Identity(n_below, n_below)};
      }
    throw NumericalError("body \"" + body_.body().name() + "\": the number of modes with " +
                         std::to_string(number_) +
                         " nodal diameters differs from the count of a factorization");
  }

  CyclicModes CyclicHarmonic::make_complex(const std::vector<OwnedVector> &vectors) const
  {
    // Each eigenvalue of the two copies is double, of z and i z, and the solver gives any two
    // vectors of their plane, or any four where two modes have one frequency. As phasors they span
    // half as many dimensions: the Hermitian products of all of them have the eigenvalues 2 and 0.
    const PhasorProducts   products(system_, vectors);
    const Eigen::MatrixXcd H = hermitian_part(products.of(M_)), K = hermitian_part(products.of(K_));
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> planes(H);
    const int                                             n      = vectors.size() / 2;
    const Eigen::VectorXd                                &values = planes.eigenvalues();
    const double defect = std::max(values.head(n).cwiseAbs().maxCoeff(),
                                   (values.tail(n).array() - 2.).abs().maxCoeff());
    if (!(defect < 1e-6))
      throw NumericalError("body \"" + body_.body().name() + "\": modes with " +
                           std::to_string(number_) + " nodal diameters do not come in pairs");
    const Eigen::MatrixXcd basis =
      planes.eigenvectors().rightCols(n) * values.tail(n).cwiseSqrt().cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> modes(
      hermitian_part(basis.adjoint() * K * basis));
    return {modes.eigenvalues(), vectors, scale() * basis * modes.eigenvectors()};
  }

  CyclicModes CyclicHarmonic::without_turn(std::vector<OwnedVector>   vectors,
                                           const std::vector<double> &eigenvalues) const
  {
    const OwnedVector turn     = system_.restrict_field(body_.turn()),
                      momentum = matrices_.apply_mass(body_.turn());
    const double inertia       = system_.dot(momentum, turn);
    CyclicModes  modes;
    double       of_turn = 0;
    for (std::size_t k = 0; k < vectors.size(); ++k)
      {
        const double part = system_.dot(momentum, vectors[k]);
        if (part * part > .5 * inertia)
          {
            of_turn += part * part / inertia;
            continue;
          }
        modes.eigenvalues.conservativeResize(modes.eigenvalues.size() + 1);
        modes.eigenvalues.tail<1>()[0] = eigenvalues[k];
        modes.vectors.push_back(add_scaled(std::move(vectors[k]), -part / inertia, turn));
      }
    if (!(std::abs(of_turn - 1.) < 1e-6))
      throw NumericalError("body \"" + body_.body().name() +
                           "\": the rigid rotation is not among the modes");
    const int n       = modes.vectors.size();
    modes.combination = scale() * Eigen::MatrixXcd::Identity(n, n);
    return modes;
  }

  Eigen::MatrixXcd CyclicHarmonic::project(const CyclicModes &modes, const FemMatrix &A) const
  {
    return modes.combination.adjoint() * PhasorProducts(system_, modes.vectors).of(A) *
           modes.combination / (scale() * scale());
  }

  FemMatrix CyclicHarmonic::coriolis() const
  {
    return matrices_.gyroscopic(constant_rate(1.));
  }

  FemMatrix CyclicHarmonic::spin_stiffness(const std::vector<double> &equilibrium,
                                           const double               rate) const
  {
    const double factor = 1. / (rate * rate - body_.rate() * body_.rate());
    FemMatrix    change =
      add_scaled(matrices_.spinning_stiffness(equilibrium, constant_rate(rate)), -1., K_);
    return change *= factor;
  }

  Eigen::MatrixXcd CyclicHarmonic::read(const CyclicModes            &modes,
                                        const std::vector<SectorRow> &rows) const
  {
    return make_phasor_rows(system_, number_, rows) * as_matrix(modes.vectors).cast<Complex>() *
           modes.combination;
  }

  void CyclicHarmonic::factorize()
  {
    if (factors_)
      return;
    FemMatrix K = K_;
    if (pinned_)
      {
        // The pinned hub loses an unknown: its matrix is made anew.
        const SystemMatrices pinned(*pinned_, body_.options().mass, body_.options().strain);
        K = body_.stiffness(pinned);
        // In bearings alone the turn is pinned at a ring.
        if (!has_turning_hub(body_.sector().model(), body_.sector().parts()[0].body))
          K = add_turn_pins(*pinned_, {body_.sector().parts()[0].body}, std::move(K));
        const OwnedVector momentum = pinned.apply_mass(body_.turn());
        momentum_ = Eigen::Map<const Eigen::VectorXd>(momentum.data(), momentum.size());
      }
    factors_ = std::make_unique<DirectSolver>(K);
    memory_  = std::max(memory_, factors_->memory());
    // Shifts and tilts may be faster than their bearings allow: two of each, in two copies.
    const unsigned int n_whirls = body_.whirls(number_) ? 4 : 0;
    if (factors_->n_negative() > n_whirls || factors_->n_zero() > 0)
      throw NumericalError("body \"" + body_.body().name() + "\" is not stable with " +
                           std::to_string(number_) + " nodal diameters: the speed is too high");
  }

  void CyclicHarmonic::solve(Eigen::MatrixXd &q, const Eigen::VectorXd &moments) const
  {
    // With P = 1 - M r r^T/(r^T M r), r the turn: P f has no moment, so that the pin carries
    // nothing, and P^T u no part of the turn (which turn_in() tells).
    if (pinned_)
      q -= momentum_ * (body_.n_sectors() / body_.turn_inertia() * moments).transpose();
    factors_->solve(q.data(), q.cols());
  }

  Eigen::VectorXd CyclicHarmonic::turn_in(const Eigen::MatrixXd &q) const
  {
    return pinned_ ? Eigen::VectorXd(body_.n_sectors() / body_.turn_inertia() *
                                     (q.transpose() * momentum_))
                   : Eigen::VectorXd::Zero(q.cols());
  }

  Eigen::MatrixXcd CyclicHarmonic::answers(const std::vector<SectorRow> &forces,
                                           const std::vector<SectorRow> &rows)
  {
    factorize();
    const PhasorRows reads = make_phasor_rows(static_system(), number_, rows);
    const Eigen::SparseMatrix<double, Eigen::RowMajor> along =
      make_phasor_rows(static_system(), number_, forces).real();
    const Eigen::SparseMatrix<double> loads = along.transpose();
    const Eigen::VectorXd             turn = read_turn(rows), moments = read_turn(forces);
    Eigen::MatrixXcd                  answers(rows.size(), forces.size());
    for (std::size_t first = 0; first < forces.size(); first += block)
      {
        const std::size_t n = std::min<std::size_t>(block, forces.size() - first);
        Eigen::MatrixXd   q = loads.middleCols(first, n);
        solve(q, moments.segment(first, n));
        answers.middleCols(first, n) = reads * q.cast<Complex>();
        if (pinned_)
          answers.middleCols(first, n) -= (turn * turn_in(q).transpose()).cast<Complex>();
      }
    return answers;
  }

  Eigen::VectorXd CyclicHarmonic::read_turn(const std::vector<SectorRow> &rows) const
  {
    Eigen::VectorXd values(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      values[i] = read_row(rows[i], body_.turn());
    return values;
  }

  Eigen::VectorXd CyclicHarmonic::answer(const std::vector<double>    &forces,
                                         const std::vector<SectorRow> &rows)
  {
    factorize();
    const OwnedVector load = static_system().restrict_forces(forces);
    Eigen::MatrixXd   q    = Eigen::Map<const Eigen::VectorXd>(load.data(), load.size());
    const double      moment =
      std::inner_product(forces.begin(), forces.end(), body_.turn().begin(), 0.);
    solve(q, Eigen::VectorXd::Constant(1, moment));
    return (make_phasor_rows(static_system(), number_, rows) * q.cast<Complex>()).real() -
           read_turn(rows) * turn_in(q);
  }

  Eigen::VectorXd CyclicHarmonic::modal_forces(const CyclicModes         &modes,
                                               const std::vector<double> &forces) const
  {
    const OwnedVector load = system_.restrict_forces(forces);
    return body_.n_sectors() * product(modes, load);
  }

  Eigen::VectorXd CyclicHarmonic::euler_forces(const CyclicModes &modes) const
  {
    if (body_.turns())
      return Eigen::VectorXd::Zero(modes.vectors.size());
    return -1. * body_.n_sectors() * product(modes, matrices_.apply_mass(body_.rigid_turn()));
  }

  Eigen::VectorXd CyclicHarmonic::euler_answer(const std::vector<SectorRow> &rows)
  {
    if (body_.turns())
      return Eigen::VectorXd::Zero(rows.size());
    factorize();
    const OwnedVector inertia = matrices_.apply_mass(body_.rigid_turn());
    Eigen::MatrixXd   q       = -Eigen::Map<const Eigen::VectorXd>(inertia.data(), inertia.size());
    solve(q, Eigen::VectorXd::Zero(1));
    return (make_phasor_rows(system_, number_, rows) * q.cast<Complex>()).real();
  }

  Eigen::VectorXd CyclicHarmonic::turn_coriolis(const CyclicModes &modes) const
  {
    // r^T G z = -(G r)^T z
    const OwnedVector Gr = SparseMatrix(coriolis()).apply(system_.restrict_field(body_.turn()));
    return -1. * body_.n_sectors() * product(modes, Gr);
  }

  Eigen::VectorXd CyclicHarmonic::product(const CyclicModes &modes, const OwnedVector &load) const
  {
    Eigen::VectorXd products(modes.vectors.size());
    for (std::size_t k = 0; k < modes.vectors.size(); ++k)
      products[k] = system_.dot(modes.vectors[k], load);
    return modes.combination.real().transpose() * products;
  }
} // namespace vfife
