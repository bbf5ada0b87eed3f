// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/types.h>
#include <vfife/fem/cyclic/cyclic_harmonic.h>
#include <vfife/fem/modes/modal_solver.h>
#include <vfife/fem/solvers/eigen_solver.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <functional>

// Matrices act on real and imaginary parts alike, and x^T A y = Re(z^H A w) of the phasors of x
// and y.
namespace vfife
{
  using Eigen::Index;
  using Eigen::MatrixXcd;
  using Eigen::MatrixXd;
  using Eigen::VectorXcd;
  using Eigen::VectorXd;

  namespace
  {
    MatrixXcd hermitian_part(const MatrixXcd &A)
    {
      return .5 * (A + A.adjoint());
    }

    MatrixXcd multiply(const SectorMatrix &A, const MatrixXcd &z)
    {
      MatrixXcd product(A.rows(), z.cols());
      product.real() = A * MatrixXd(z.real());
      product.imag() = A * MatrixXd(z.imag());
      return product;
    }

    /** Of a function. */
    class Operator : public ColumnOperator
    {
    public:
      using Act = std::function<void(const Columns &x, Columns &y)>;

      explicit Operator(Act act)
        : act_(std::move(act))
      {
      }
      void apply(const Columns &x, Columns &y) const override
      {
        act_(x, y);
      }

    private:
      Act act_;
    };

    VectorXd as_vector(const std::vector<double> &x)
    {
      return Eigen::Map<const VectorXd>(x.data(), x.size());
    }
  } // namespace

  CyclicHarmonic::CyclicHarmonic(const CyclicSector &sector, const unsigned int number)
    : sector_(sector)
    , number_(number)
    , unknowns_(sector, number)
  {
    if (number == 0 && sector.body().turns())
      find_turn();
    factorize();
  }

  void CyclicHarmonic::find_turn()
  {
    turn_.emplace();
    turn_->motion   = as_vector(sector_.system().restrict_field(sector_.body().turn()));
    turn_->momentum = sector_.mass() * turn_->motion;
    turn_->inertia  = turn_->motion.dot(turn_->momentum);
  }

  void CyclicHarmonic::factorize()
  {
    MatrixXcd A = unknowns_.make_matrix(sector_.condensed().border_matrix());
    if (turn_)
      {
        // The harmonic's kept unknowns are the first border, seats and hubs.
        const auto kept = sector_.unknowns().kept();
        const auto n    = static_cast<Index>(sector_.unknowns().borders[0].size());
        VectorXcd  b(A.rows());
        for (Index k = 0; k < b.size(); ++k)
          b[k] = turn_->motion[kept[k < n ? k : k + n]];
        A += A.trace().real() / b.squaredNorm() * b * b.adjoint();
      }
    borders_.emplace(std::move(A));
    // Shifts and tilts may be faster than their bearings allow: one of each.
    const unsigned int n_whirls = sector_.body().whirls(number_) ? 2 : 0;
    if (borders_->n_negative() > n_whirls)
      throw NumericalError("body \"" + sector_.body().body().name() + "\" is not stable with " +
                           std::to_string(number_) + " nodal diameters: the speed is too high");
  }

  double CyclicHarmonic::scale() const
  {
    // Of phasors with z^H M z = 1 to the kinetic energy of the body. All sectors together: the mean
    // of cos^2 over them is one half, where they are not alike.
    return std::sqrt(double(unknowns_.n_parts()) / sector_.body().n_sectors());
  }

  unsigned int CyclicHarmonic::count_modes() const
  {
    // By Sylvester's law of inertia, inside and on the borders.
    const unsigned int n =
      sector_.n_held_modes() +
      HermitianSolver(unknowns_.make_matrix(sector_.border_matrix_at_cutoff())).n_negative();
    return turn_ ? n - std::min(n, 1u) : n;
  }

  CyclicModes CyclicHarmonic::find_modes()
  {
    const unsigned int n_below = count_modes();
    if (n_below == 0)
      return {VectorXd(), MatrixXcd(sector_.system().constraints().n(), 0)};
    const unsigned int n_wanted = unknowns_.n_parts() * n_below,
                       most     = ModalSolver::largest_number(unknowns_.n());
    if (n_wanted > most)
      throw InputError("body \"" + sector_.body().body().name() + "\": its mesh has " +
                       std::to_string(n_below) + " modes of " + std::to_string(number_) +
                       " nodal diameters below the cut-off, too many for its " +
                       std::to_string(unknowns_.n()) +
                       " unknowns; lower the cut-off or refine the mesh");

    return make_complex(find_pairs(n_wanted, most));
  }

  EigenPairs CyclicHarmonic::find_pairs(const unsigned int n, const unsigned int most) const
  {
    const Operator mass([this](const Columns &x, Columns &y) {
      unknowns_.fold(sector_.mass() * unknowns_.expand(x), y);
    });
    const Operator stiffness([this](const Columns &x, Columns &y) {
      const MatrixXd u      = unknowns_.expand(x);
      MatrixXd       forces = sector_.stiffness() * u;
      unknowns_.add_ring_forces(u, forces);
      unknowns_.fold(forces, y);
    });
    // K^-1 M; a free turn is mapped to zero.
    const Operator      inverse([this](const Columns &x, Columns &y) {
      unknowns_.take(solve(sector_.mass() * unknowns_.expand(x)), y);
    });
    const Communicator &alone = sector_.body().communicator();
    Columns             masses(alone, unknowns_.n(), 1);
    unknowns_.take(VectorXd(sector_.mass().diagonal()).replicate(1, unknowns_.n_parts()), masses);
    const MassOperator M{mass,
                         OwnedVector(masses[0].data(), masses[0].data() + unknowns_.n()),
                         0,
                         alone};
    const double       limit = sector_.cutoff() * sector_.cutoff();
    // As many of them as there are; where the search has missed one, more.
    for (unsigned int attempt = 0; attempt < 3; ++attempt)
      {
        EigenPairs pairs = solve_shift_invert(M,
                                              inverse,
                                              0.,
                                              std::min(most, n + 4 * attempt),
                                              sector_.body().options().eigen_tolerance);
        if (std::lower_bound(pairs.values.begin(), pairs.values.end(), limit) !=
            pairs.values.begin() + n)
          continue;
        pairs.values.resize(n);
        pairs.vectors.resize(n);
        const std::vector<double> residuals = compute_residuals(stiffness, mass, alone, pairs, 0.);
        for (unsigned int k = 0; k < n; ++k)
          check_residual(residuals[k], std::sqrt(std::abs(pairs.values[k])) / (2. * pi));
        check_orthogonality(compute_orthogonality_defect(mass, alone, pairs.vectors));
        return pairs;
      }
    throw NumericalError("body \"" + sector_.body().body().name() +
                         "\": the number of modes with " + std::to_string(number_) +
                         " nodal diameters differs from the count of a factorization");
  }

  CyclicModes CyclicHarmonic::make_complex(const EigenPairs &pairs) const
  {
    const MatrixXcd z =
      unknowns_.join_parts(unknowns_.expand(Columns(sector_.body().communicator(), pairs.vectors)));
    if (unknowns_.n_parts() == 1)
      return {as_vector(pairs.values), scale() * z};
    // Each eigenvalue of real and imaginary parts is double, of z and i z, and the solver gives any
    // two vectors of their plane, or any four where two modes have one frequency. As phasors they
    // span half as many dimensions: the Hermitian products of all of them have the eigenvalues 2
    // and 0.
    const MatrixXcd H = hermitian_part(z.adjoint() * multiply(sector_.mass(), z));
    const Eigen::SelfAdjointEigenSolver<MatrixXcd> planes(H);
    const Index                                    n      = z.cols() / 2;
    const VectorXd                                &values = planes.eigenvalues();
    const double defect = std::max(values.head(n).cwiseAbs().maxCoeff(),
                                   (values.tail(n).array() - 2.).abs().maxCoeff());
    if (!(defect < 1e-6))
      throw NumericalError("body \"" + sector_.body().body().name() + "\": modes with " +
                           std::to_string(number_) + " nodal diameters do not come in pairs");
    const MatrixXcd basis =
      planes.eigenvectors().rightCols(n) * values.tail(n).cwiseSqrt().cwiseInverse().asDiagonal();
    // The stiffness of all vectors is known from their values.
    const VectorXcd                                lambda = as_vector(pairs.values).cast<Complex>();
    const Eigen::SelfAdjointEigenSolver<MatrixXcd> modes(
      hermitian_part(basis.adjoint() * H * lambda.asDiagonal() * basis));
    return {modes.eigenvalues(), scale() * (z * (basis * modes.eigenvectors()))};
  }

  MatrixXcd CyclicHarmonic::project(const CyclicModes &modes, const SectorMatrix &A) const
  {
    return modes.phasors.adjoint() * multiply(A, modes.phasors) / (scale() * scale());
  }

  MatrixXcd CyclicHarmonic::sum_parts(const MatrixXcd &parts) const
  {
    MatrixXcd rows = MatrixXcd::Zero(sector_.n_rows(), parts.cols());
    for (std::size_t p = 0; p < sector_.parts().size(); ++p)
      rows.row(sector_.parts()[p].row) += unknowns_.phase(sector_.parts()[p].sector) * parts.row(p);
    return rows;
  }

  MatrixXcd CyclicHarmonic::read(const CyclicModes &modes) const
  {
    return sum_parts(multiply(sector_.reads(), modes.phasors));
  }

  MatrixXd CyclicHarmonic::solve_pinned(MatrixXd forces) const
  {
    // Down to the borders, around the body, and back.
    sector_.condensed().solve(forces, [this](const MatrixXd &loads) {
      return unknowns_.split_parts(
        unknowns_.expand_kept(borders_->solve(unknowns_.fold_kept(unknowns_.join_parts(loads)))));
    });
    return forces;
  }

  MatrixXd CyclicHarmonic::solve(MatrixXd forces) const
  {
    // With P = 1 - M r r^T/(r^T M r), r the turn: P f has no moment, and P^T u no part of the turn.
    if (!turn_)
      return solve_pinned(std::move(forces));
    forces -= turn_->momentum * (turn_->motion.transpose() * forces) / turn_->inertia;
    MatrixXd u = solve_pinned(std::move(forces));
    u -= turn_->motion * (turn_->momentum.transpose() * u) / turn_->inertia;
    return u;
  }

  MatrixXcd CyclicHarmonic::answers(const unsigned int first, const unsigned int n) const
  {
    const auto     &parts = sector_.parts();
    const MatrixXcd loads = unknowns_.fold_kept(sector_.part_loads().cast<Complex>());
    // Unit forces along rows are those along their parts, with the phase of each.
    MatrixXcd along = MatrixXcd::Zero(loads.rows(), n), held = MatrixXcd::Zero(parts.size(), n);
    for (std::size_t p = 0; p < parts.size(); ++p)
      if (parts[p].row >= first && parts[p].row < first + n)
        {
          const Complex phase = std::conj(unknowns_.phase(parts[p].sector));
          along.col(parts[p].row - first) += phase * loads.col(p);
          held.col(parts[p].row - first) +=
            phase * sector_.part_flexibility().col(p).cast<Complex>();
        }
    MatrixXcd rows = sum_parts(held + loads.adjoint() * borders_->solve(along));
    if (turn_)
      {
        // P of both sides, by what the momentum of the turn causes.
        const MatrixXd caused = solve_pinned(turn_->momentum);
        const VectorXd read   = sum_parts((sector_.reads() * caused).cast<Complex>()).real(),
                       turns  = sum_parts((sector_.reads() * turn_->motion).cast<Complex>()).real(),
                       moments = turns.segment(first, n) / turn_->inertia,
                       of_turn =
                         (read.segment(first, n) - turn_->momentum.dot(caused.col(0)) * moments) /
                         turn_->inertia;
        rows -= (read * moments.transpose() + turns * of_turn.transpose()).cast<Complex>();
      }
    return rows;
  }

  VectorXd CyclicHarmonic::answer(const std::vector<double> &forces) const
  {
    const MatrixXd u = solve(as_vector(sector_.system().restrict_forces(forces)));
    return sum_parts((sector_.reads() * u).cast<Complex>()).real();
  }

  VectorXd CyclicHarmonic::modal_forces(const CyclicModes         &modes,
                                        const std::vector<double> &forces) const
  {
    return sector_.body().n_sectors() * modes.phasors.real().transpose() *
           as_vector(sector_.system().restrict_forces(forces));
  }

  VectorXd CyclicHarmonic::euler_forces(const CyclicModes &modes) const
  {
    const CyclicBody &body = sector_.body();
    if (body.turns())
      return VectorXd::Zero(modes.phasors.cols());
    return -1. * body.n_sectors() * modes.phasors.real().transpose() *
           as_vector(sector_.matrices().apply_mass(body.rigid_turn()));
  }

  VectorXd CyclicHarmonic::euler_answer() const
  {
    const CyclicBody &body = sector_.body();
    if (body.turns())
      return VectorXd::Zero(sector_.n_rows());
    const MatrixXd u = solve(-as_vector(sector_.matrices().apply_mass(body.rigid_turn())));
    return sum_parts((sector_.reads() * u).cast<Complex>()).real();
  }

  VectorXd CyclicHarmonic::turn_coriolis(const CyclicModes &modes, const SectorMatrix &G) const
  {
    // r^T G z = -(G r)^T z
    return -1. * sector_.body().n_sectors() * modes.phasors.real().transpose() *
           (G * turn_->motion);
  }
} // namespace vfife
