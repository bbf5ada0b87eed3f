// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/cyclic/cyclic_sector.h>

#include <algorithm>
#include <map>
#include <set>

namespace vfife
{
  namespace
  {
    FemConstraints::Options open_borders(const HubRotation rotation)
    {
      FemConstraints::Options options;
      options.rotation = rotation;
      options.open     = true;
      return options;
    }

    /** On one rank; without the zeros that it has in the pattern of its system. */
    SectorMatrix make_sector_matrix(const FemMatrix &A)
    {
      const SparsePattern &pattern = A.pattern();
      SectorMatrix         matrix(pattern.n, pattern.n);
      std::vector<int>     sizes(pattern.n);
      for (int i = 0; i < pattern.n; ++i)
        sizes[i] = pattern.begin[i + 1] - pattern.begin[i];
      matrix.reserve(sizes);
      for (int i = 0; i < pattern.n; ++i)
        for (std::size_t k = pattern.begin[i]; k < pattern.begin[i + 1]; ++k)
          if (A.values()[k] != 0)
            matrix.insert(i, pattern.columns[k]) = A.values()[k];
      matrix.makeCompressed();
      return matrix;
    }

    /** Right sides solved for at once: enough for the solver's dense blocks. */
    constexpr std::size_t block = 64;
  } // namespace

  SectorUnknowns::SectorUnknowns(const FemSystem &sector)
  {
    const FemSpace       &space       = sector.space();
    const FemConstraints &constraints = sector.constraints();
    hubs                              = constraints.hub_angles();
    std::set<unsigned int> known(hubs.begin(), hubs.end());
    const auto add_point = [&](const unsigned int point, std::vector<unsigned int> &to) {
      std::set<unsigned int> own;
      for (unsigned int c = 0; c < 3; ++c)
        for (const auto &term : constraints.line(3 * std::size_t(point) + c))
          if (known.count(term.first) == 0)
            own.insert(term.first);
      to.insert(to.end(), own.begin(), own.end());
      known.insert(own.begin(), own.end());
    };
    for (const auto &[image, original] : space.images())
      // A point that hangs moves with others of its border.
      for (const auto &[point, side] : {std::pair(original, 0), std::pair(image, 1)})
        if (space.hanging().count(point) == 0)
          add_point(point, borders[side]);
    const BearingRings rings(space);
    for (const BearingRing &ring : rings.list())
      for (const unsigned int point : ring.points)
        add_point(point, seats);
  }

  std::vector<unsigned int> SectorUnknowns::kept() const
  {
    std::vector<unsigned int> all;
    for (const auto *const some : {&borders[0], &borders[1], &seats, &hubs})
      all.insert(all.end(), some->begin(), some->end());
    return all;
  }

  CyclicSector::CyclicSector(const CyclicBody             &body,
                             const double                  cutoff,
                             const std::vector<SectorRow> &rows)
    : body_(body)
    , cutoff_(cutoff)
    , system_(body.sector(), open_borders(body.rotation()), body.communicator())
    , matrices_(system_, body.options().mass, body.options().strain)
    , unknowns_(system_)
    , stiffness_(body.stiffness(matrices_))
    , K_(make_sector_matrix(stiffness_))
    , condensed_(stiffness_, unknowns_.kept())
    , n_rows_(rows.size())
  {
    if (condensed_.n_negative() > 0 || condensed_.n_zero() > 0)
      throw NumericalError("body \"" + body.body().name() +
                           "\" is not stable: the speed is too high");
    const FemMatrix M = matrices_.mass();
    M_                = make_sector_matrix(M);
    condense_at_cutoff(stiffness_, M);
    add_rows(rows);
    condense_rows();
    memory_ += condensed_.memory();
  }

  void CyclicSector::condense_at_cutoff(const FemMatrix &K, const FemMatrix &M)
  {
    const Condensation shifted(add_scaled(K, -cutoff_ * cutoff_, M), unknowns_.kept());
    at_cutoff_    = shifted.border_matrix();
    n_held_modes_ = shifted.n_negative();
    memory_       = 8e-6 * at_cutoff_.size();
  }

  SectorMatrix CyclicSector::coriolis() const
  {
    return make_sector_matrix(matrices_.gyroscopic(constant_rate(1.)));
  }

  SectorMatrix CyclicSector::spin_stiffness(const std::vector<double> &equilibrium,
                                            const double               rate) const
  {
    const double factor = 1. / (rate * rate - body_.rate() * body_.rate());
    FemMatrix    change =
      add_scaled(matrices_.spinning_stiffness(equilibrium, constant_rate(rate)), -1., stiffness_);
    return make_sector_matrix(change *= factor);
  }

  void CyclicSector::add_rows(const std::vector<SectorRow> &rows)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        std::map<unsigned int, unsigned int> part_of; // sector
        for (const SectorTerm &term : rows[i])
          {
            const auto [found, is_new] = part_of.emplace(term.sector, parts_.size());
            if (is_new)
              parts_.push_back({i, term.sector});
            for (unsigned int c = 0; c < 3; ++c)
              for (const auto &[unknown, coefficient] :
                   system_.constraints().line(3 * std::size_t(term.point) + c))
                entries.emplace_back(found->second, unknown, term.weight[c] * coefficient);
          }
      }
    reads_ = SectorMatrix(parts_.size(), system_.constraints().n());
    reads_.setFromTriplets(entries.begin(), entries.end());
  }

  void CyclicSector::condense_rows()
  {
    const Eigen::SparseMatrix<double> forces = reads_.transpose();
    part_loads_.resize(condensed_.border_matrix().rows(), parts_.size());
    part_flexibility_.resize(parts_.size(), parts_.size());
    for (std::size_t first = 0; first < parts_.size(); first += block)
      {
        const std::size_t n = std::min(block, parts_.size() - first);
        Eigen::MatrixXd   x = forces.middleCols(first, n);
        condensed_.solve(x, [&](const Eigen::MatrixXd &on_borders) -> Eigen::MatrixXd {
          part_loads_.middleCols(first, n) = on_borders;
          return Eigen::MatrixXd::Zero(on_borders.rows(), on_borders.cols());
        });
        part_flexibility_.middleCols(first, n) = reads_ * x;
      }
  }
} // namespace vfife
