// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/column_names.h>
#include <vfife/fem/modes/modal_solver.h>
#include <vfife/fem/pair/coupled_modes.h>
#include <vfife/fem/solvers/sparse_matrix.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/pair_measures.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>

namespace vfife
{
  namespace
  {
    /**
     * rate u': what material that turns at @p rate [rad/s] of each body about its axis sees of a
     * displacement field that stands still in space; u' is the derivative along the circumference,
     * vectors turning along, by central differences of fourth order over equal sectors. Zero on
     * bodies of fewer than five sectors.
     */
    std::vector<double> apply_standing_derivative(const FemSpace            &space,
                                                  const std::vector<double> &u)
    {
      std::vector<double> result(u.size(), 0.);
      for (const FemSpace::Part &part : space.parts())
        {
          const Body          &body      = space.model().bodies[part.body];
          const BodyStructure &structure = body.structure();
          // Two sectors on either side have to be different ones, and turn into each other; of
          // quadratic elements' points only nodes are numbered by sectors.
          if (structure.n_sectors() < 5 || part.n_points != body.n_nodes() ||
              !turns_about_sector_axis(body))
            continue;
          // Sectors follow each other in the sense of their own axis, spin has that of the body's.
          const Vector3 axis = compute_sector_axis(body).direction;
          const double  rate = body.rate * body.axis.direction.dot(axis), angle = structure.pitch();
          // The displacement "away" sectors further on, turned back into this sector.
          const auto seen = [&](const unsigned int node, const int away) {
            const std::size_t point = part.first_point + structure.copy(node, away);
            return Vector3(rotation_about(axis, -away * angle) *
                           Eigen::Map<const Vector3>(u.data() + 3 * point));
          };
          // f' = (8 (f_1 - f_-1) - (f_2 - f_-2)) / 12 per sector
          for (unsigned int node = 0; node < body.n_nodes(); ++node)
            Eigen::Map<Vector3>(result.data() + 3 * std::size_t(part.first_point + node)) =
              rate / (12 * angle) *
              (8 * (seen(node, 1) - seen(node, -1)) - (seen(node, 2) - seen(node, -2)));
        }
      return result;
    }

    /** Shapes that stand in space are made of more than as many turning ones. */
    unsigned int n_basis(const unsigned int n)
    {
      return 2 * n + 10;
    }

    FemSystem::Links make_links(const std::vector<ContactTie> &ties)
    {
      FemSystem::Links links;
      for (const ContactTie &tie : ties)
        {
          links.emplace_back();
          for (const auto &point : tie.points)
            links.back().push_back(point.first);
        }
      return links;
    }

    /** sum k d d^T over the points under pressure. */
    FemMatrix make_contact(const FemSystem &system, const std::vector<ContactTie> &ties)
    {
      return system.link_matrix([&](const unsigned int l) {
        Eigen::VectorXd direction(3 * ties[l].points.size());
        for (std::size_t k = 0; k < ties[l].points.size(); ++k)
          direction.segment<3>(3 * k) = ties[l].points[k].second;
        return Eigen::MatrixXd(ties[l].stiffness * direction * direction.transpose());
      });
    }

    /** Of all rings: bearings by their tangents @p bearings at the position, couplings as they are.
     */
    Eigen::MatrixXd make_ring_stiffness(const BearingRings       &rings,
                                        const Eigen::MatrixXd    &bearings,
                                        const BearingRings::Rate &rate)
    {
      Eigen::MatrixXd K                                 = rings.stiffness(rate);
      K.topLeftCorner(bearings.rows(), bearings.cols()) = bearings;
      return K;
    }

    /** Forces of a unit torque on the driven body, as the model's torques act. */
    OwnedVector make_unit_torque(const FemSystem &system)
    {
      const FemSpace     &d = system.space();
      const Model        &m = d.model();
      std::vector<double> forces(3 * static_cast<std::size_t>(d.n_points()), 0.);
      const unsigned int  driven = m.only_transmission()->driven;
      const double        sum    = torque_on(m, driven);
      for (const Torque &torque : m.torques)
        if (torque.body == driven)
          add_torque_forces(torque, d, *d.find_part(torque.body), torque.value / sum, forces);
      return system.restrict_forces(forces);
    }

    /** Kinetic energies of both bodies and the motion of the driven one for a complex shape. */
    class ShapeReader
    {
    public:
      explicit ShapeReader(const FemSpace &d)
        : part_(*d.find_part(d.model().only_transmission()->driven))
        , space_(d)
        , describer_(d, part_)
      {
      }

      CoupledMode read(const double               frequency,
                       std::vector<double>        real,
                       const std::vector<double> &imaginary) const
      {
        CoupledMode mode;
        mode.frequency = frequency;
        mode.driven    = describer_.describe(real, imaginary);
        double all = 0, driven = 0, largest = 0;
        // Kinetic energies up to a common factor, with the row sums of mass.
        for (const FemSpace::Part &part : space_.parts())
          {
            const Body &body = space_.model().bodies[part.body];
            for (unsigned int i = 0; i < body.n_nodes(); ++i)
              {
                const std::size_t row = 3 * std::size_t(part.first_point + i);
                const double      square =
                  Eigen::Map<const Vector3>(real.data() + row).squaredNorm() +
                  Eigen::Map<const Vector3>(imaginary.data() + row).squaredNorm();
                all += body.node_masses()[i] * square;
                driven += part.body == part_.body ? body.node_masses()[i] * square : 0.;
                largest = std::max(largest, square);
              }
          }
        mode.driven_energy = driven / all;
        mode.shape         = std::move(real);
        for (double &value : mode.shape)
          value /= std::sqrt(largest);
        return mode;
      }

    private:
      const FemSpace::Part &part_;
      const FemSpace       &space_;
      ModeDescriber         describer_;
    };

    /** Displacements of all points, sum of the modes' shapes times coefficients. */
    std::vector<double> combine(const std::vector<Mode> &modes, const Eigen::VectorXd &coefficients)
    {
      std::vector<double> sum(modes.front().shape.size(), 0.);
      for (std::size_t k = 0; k < modes.size(); ++k)
        for (std::size_t i = 0; i < sum.size(); ++i)
          sum[i] += coefficients[k] * modes[k].shape[i];
      return sum;
    }

    /** The equations of doc/theory/fem.md in a basis of turning modes, M the unit matrix. */
    struct Reduced
    {
      Eigen::MatrixXd stiffness, skew;
      Eigen::VectorXd load; ///< of a unit torque
    };

    /** The problem of standing shapes on the span of all modes found; @p more: what the rings'
     * stiffness is there beyond that of the modes. Collective. */
    Reduced reduce(const FemSystem       &system,
                   const SystemMatrices  &matrices,
                   const FemMatrix       &mass,
                   const ModalResult     &found,
                   const Eigen::MatrixXd &more)
    {
      const Model &model = system.space().model();
      const auto   rate  = [&model](const unsigned int body) { return model.bodies[body].rate; };
      const SparseMatrix M(mass), G(matrices.gyroscopic(rate));
      // P x of each mode x; P and G carry the rates of their bodies.
      std::vector<OwnedVector> turned;
      for (const Mode &mode : found.modes)
        turned.push_back(
          system.restrict_field(apply_standing_derivative(system.space(), mode.shape)));
      // In the basis x, M = 1 and x^T (K) x = diag(omega^2):
      //     q'' + skew q' + stiffness q = 0,   skew = 2 x^T (M P + G) x,
      //     stiffness = diag(omega^2) + x^T (M P^2 + 2 G P) x
      const auto     &x = found.vectors;
      Reduced         r;
      Eigen::MatrixXd skew = 2 * (M.project(x, turned) + G.project(x, x));
      // Derivative and turning commute; P is skew under M, so that P^2 is -P^T P.
      Eigen::MatrixXd stiffness = 2 * G.project(x, turned) - M.project(turned, turned);
      Eigen::MatrixXd ways(more.rows(), x.size());
      for (std::size_t k = 0; k < x.size(); ++k)
        {
          stiffness(k, k) += found.modes[k].eigenvalue;
          ways.col(k) = system.rings().displacement(found.modes[k].shape);
        }
      stiffness += ways.transpose() * more * ways;
      r.skew      = .5 * (skew - skew.transpose());
      r.stiffness = .5 * (stiffness + stiffness.transpose());
      r.load.resize(x.size());
      const OwnedVector torque = make_unit_torque(system);
      for (std::size_t k = 0; k < x.size(); ++k)
        r.load[k] = system.dot(torque, x[k]);
      return r;
    }

    /** Modes that stand in space; @p compliance: turn under a unit torque of the whole pair, frozen
     * in turning axes. */
    std::vector<CoupledMode> find_standing(const Reduced           &r,
                                           const std::vector<Mode> &basis,
                                           const double             compliance,
                                           const unsigned int       n,
                                           const ShapeReader       &reader)
    {
      const int       size   = basis.size();
      const double    scale  = std::sqrt(r.stiffness.diagonal().cwiseAbs().maxCoeff());
      Eigen::MatrixXd linear = Eigen::MatrixXd::Zero(2 * size, 2 * size);
      // States (q, q'/scale), as for waves of one body.
      linear.topRightCorner(size, size)    = scale * Eigen::MatrixXd::Identity(size, size);
      linear.bottomLeftCorner(size, size)  = -r.stiffness / scale;
      linear.bottomRightCorner(size, size) = -r.skew;
      const Eigen::EigenSolver<Eigen::MatrixXd> solver(linear);
      std::vector<std::pair<double, int>>       order;
      for (int k = 0; k < 2 * size; ++k)
        {
          const std::complex<double> value = solver.eigenvalues()[k];
          if (value.real() > 1e-6 * std::abs(value))
            throw NumericalError("the pair is not stable at this speed: a coupled motion in the "
                                 "stationary frame grows");
          if (value.imag() > 0)
            order.emplace_back(value.imag(), k);
        }
      std::sort(order.begin(), order.end());
      order.resize(std::min<std::size_t>(order.size(), n));
      // The whole turn under a unit torque: of the basis by the standing problem, of all other
      // modes by what the compliance has beyond those of the basis.
      // Modes beyond the basis give way as they do in turning axes.
      double total = compliance + r.load.dot(r.stiffness.partialPivLu().solve(r.load));
      for (int k = 0; k < size; ++k)
        total -= r.load[k] * r.load[k] / basis[k].eigenvalue;
      std::vector<CoupledMode> modes;
      for (const auto &entry : order)
        {
          // The phase at which the mode moves most, which its shape then shows.
          Eigen::VectorXcd x = solver.eigenvectors().col(entry.second).head(size);
          x *= std::polar(1., -.5 * std::arg((x.transpose() * x)(0)));
          CoupledMode mode =
            reader.read(entry.first / (2 * pi), combine(basis, x.real()), combine(basis, x.imag()));
          // x^H K x + omega^2 x^H M x
          const double energy =
            entry.first * entry.first * x.squaredNorm() + x.dot(r.stiffness * x).real();
          mode.share_of_turn =
            2 * std::norm(x.dot(r.load.cast<std::complex<double>>())) / energy / total;
          modes.push_back(std::move(mode));
        }
      return modes;
    }
  } // namespace

  CoupledModes find_coupled_modes(const Compliance              &compliance,
                                  const FemOptions              &fem_options,
                                  const bool                     centrifugal,
                                  const std::vector<ContactTie> &ties,
                                  const Eigen::MatrixXd         &bearings,
                                  const unsigned int             n,
                                  const Communicator            &communicator)
  {
    const FemSpace &d        = compliance.space();
    FemOptions      options  = fem_options;
    const bool      at_state = centrifugal || d.model().has_initial_strains();
    if (at_state && degree_of(options.element) > 1)
      throw InputError("Fem/element type",
                       "coupled modes of a pair with centrifugal forces or temperatures require "
                       "elements of eight nodes. Use incompatible modes, or neither of these");
    options.eigen_solver = EigenSolverKind::shift_invert;
    options.n_modes      = n_basis(n);
    const FemSystem    system(d, FemConstraints::Options(), communicator, make_links(ties));
    const unsigned int largest = ModalSolver::largest_number(system.constraints().n());
    if (options.n_modes > largest)
      throw InputError("Loaded contact/coupled modes",
                       std::to_string(n) + " coupled modes require " +
                         std::to_string(options.n_modes) + " modes in the rotating frame, and " +
                         std::to_string(system.constraints().n()) + " unknowns have at most " +
                         std::to_string(largest) +
                         ". Reduce the number of modes, or refine the mesh");
    const ModalSolver     solver(system, options);
    const SystemMatrices &matrices = solver.matrices();
    const auto      rate = [&d](const unsigned int body) { return d.model().bodies[body].rate; };
    const FemMatrix M    = matrices.mass();
    const auto      rate_of_state = [&](const unsigned int body) {
      return centrifugal ? rate(body) : 0.;
    };
    FemMatrix K = at_state ? matrices.spinning_stiffness(compliance.spun(), rate_of_state)
                           : matrices.stiffness(rate);
    K           = add_scaled(std::move(K), 1., make_contact(system, ties));
    // Turning bodies feel their bearings in the mean over all turns; what stands in space feels
    // them as they are.
    const BearingRings   &rings    = system.rings();
    const Eigen::MatrixXd in_space = make_ring_stiffness(rings, bearings, rate),
                          in_mean  = rings.mean_over_turns(in_space, rate);
    if (!rings.list().empty())
      K = add_scaled(std::move(K), 1., system.ring_matrix(in_mean - rings.stiffness(rate)));
    CoupledModes result;
    OwnedVector  turn = make_unit_torque(system);
    {
      // K u = f with the traction f of a unit torque: f . u is the turn of its points, the tangent
      // mesh stiffness its inverse. The driven hub is free here, the contact carries the torque.
      const OwnedVector  torque = turn;
      const DirectSolver factors(K);
      factors.solve(turn.data(), 1);
      result.stiffness = 1 / system.dot(torque, turn);
    }
    const ModalResult found = solver.solve(K, M, 0.);
    result.counted          = found.counted;
    result.n_unknowns       = found.n_unknowns;
    const ShapeReader         reader(d);
    const Reduced             reduced = reduce(system, matrices, M, found, in_space - in_mean);
    const std::vector<double> none(found.modes.front().shape.size(), 0.);
    for (unsigned int k = 0; k < n; ++k)
      {
        const Mode &mode = found.modes[k];
        result.turning.push_back(reader.read(mode.frequency(), mode.shape, none));
        // f . K^-1 f = sum over modes of (x . f)^2 / omega^2
        result.turning.back().share_of_turn =
          reduced.load[k] * reduced.load[k] / mode.eigenvalue * result.stiffness;
      }
    if (centrifugal)
      result.standing = find_standing(reduced, found.modes, 1 / result.stiffness, n, reader);
    return result;
  }

  Table make_coupled_mode_table()
  {
    Table table{{column::axes},
                {"mode", "-"},
                {column::frequency, "Hz"},
                {column::share_of_static_rotation, "-"},
                {"energy in the gear", "-"},
                {"nodal diameter of the gear", "-"},
                {"share of the diameter", "-"}};
    for (const char *part : {"axial", "radial", "tangential"})
      table.add_column(part, "-");
    return table;
  }

  void add_coupled_modes(const CoupledModes &modes, Table &table)
  {
    const auto add = [&table](const char *axes, const std::vector<CoupledMode> &list) {
      for (std::size_t k = 0; k < list.size(); ++k)
        {
          const ModeDescription &d = list[k].driven;
          table.add_row({axes,
                         k + 1,
                         list[k].frequency,
                         list[k].share_of_turn,
                         list[k].driven_energy,
                         d.nodal_diameter,
                         d.share,
                         d.axial,
                         d.radial,
                         d.tangential});
        }
    };
    add(axes_of_modes::rotating, modes.turning);
    add(axes_of_modes::fixed, modes.standing);
  }
} // namespace vfife
