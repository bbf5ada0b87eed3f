// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/types.h>
#include <vfife/element/stress.h>
#include <vfife/study/cases/probe_copies.h>
#include <vfife/study/stress_waves/stress_wave_places.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    /** Parts of a wave's period at which its stress is looked at. */
    constexpr unsigned int n_phases = 128;

    /** Of a measure of what stresses @p amplitudes are at the parts of a period. */
    template <std::size_t n, typename Measure>
    double find_largest_of(const std::array<Complex, n> &amplitudes, const Measure &measure)
    {
      double largest = 0;
      for (unsigned int k = 0; k < n_phases; ++k)
        {
          std::array<double, n> parts;
          for (std::size_t c = 0; c < n; ++c)
            parts[c] = (amplitudes[c] * std::polar(1., 2. * pi * k / n_phases)).real();
          largest = std::max(largest, measure(parts));
        }
      return largest;
    }

    /** Tension at a facet with a strain [MPa]. */
    double find_tension(const SurfaceTensor &strain, const Material &material)
    {
      return compute_principal_stresses(compute_surface_stress(strain, material)).first;
    }

    std::size_t count_facets(const Fillet &fillet)
    {
      return std::size_t(fillet.n_columns()) * (fillet.end_row() - Fillet::first_row);
    }

    template <std::size_t n>
    void
    add_to(std::array<Complex, n> &sum, const std::array<Complex, n> &other, const Complex &factor)
    {
      for (std::size_t c = 0; c < n; ++c)
        sum[c] += factor * other[c];
    }
  } // namespace

  void StressWaves::add(const StressWaves &other, const Complex &factor)
  {
    for (std::size_t p = 0; p < probes.size(); ++p)
      add_to(probes[p], other.probes[p], factor);
    for (std::size_t f = 0; f < fillets.size(); ++f)
      for (std::size_t facet = 0; facet < fillets[f].size(); ++facet)
        add_to(fillets[f][facet], other.fillets[f][facet], factor);
  }

  StressWavePlaces::StressWavePlaces(const Model &model, const RootStress *const roots)
    : driven_(model.only_transmission()->driven)
    , structure_(model.bodies[driven_].structure())
  {
    for (const Probe &probe : model.probes)
      if (probe.body == driven_)
        {
          names_.push_back(probe.name);
          copies_.push_back(list_copies(model, probe));
        }
    if (roots == nullptr)
      return;
    for (const MemberFillet &member : roots->fillets())
      if (member.body == driven_)
        {
          names_.push_back(member.fillet.side() + " fillet");
          fillets_.push_back(&member);
        }
  }

  void StressWavePlaces::for_each_facet(const MemberFillet  &member,
                                        const FilletStrains &strains,
                                        const TakeFacet     &take)
  {
    const Fillet &fillet = member.fillet;
    std::size_t   facet  = 0;
    for (unsigned int column = 0; column < fillet.n_columns(); ++column)
      for (unsigned int row = Fillet::first_row; row < fillet.end_row(); ++row, ++facet)
        for (unsigned int tooth = 0; tooth < fillet.n_teeth(); ++tooth)
          take(facet, tooth, strains.facet(member, column, row, tooth));
  }

  StressWaves StressWavePlaces::none() const
  {
    StressWaves none;
    none.probes.resize(copies_.size());
    for (const MemberFillet *member : fillets_)
      none.fillets.emplace_back(count_facets(member->fillet));
    return none;
  }

  StressWaves StressWavePlaces::measure(const unsigned int         n,
                                        const ProbeMeasure        &probes,
                                        const FilletStrains *const strains) const
  {
    StressWaves waves = none();
    // Re(w exp(i n alpha)) is in w and its conjugate, but where all sectors have the same.
    const auto phase = [&](const unsigned int sector) {
      return std::polar((n == 0 ? 1. : 2.) / structure_.n_sectors(), -structure_.angle(n * sector));
    };
    for (std::size_t p = 0; probes && p < copies_.size(); ++p)
      {
        const std::vector<ProbeValue> values = probes(copies_[p]);
        for (std::size_t m = 0; m < values.size(); ++m)
          for (std::size_t c = 0; c < 6; ++c)
            waves.probes[p][c] +=
              phase(structure_.sector_of(copies_[p][m].node)) * values[m].stress[c];
      }
    for (std::size_t f = 0; strains != nullptr && f < fillets_.size(); ++f)
      for_each_facet(*fillets_[f],
                     *strains,
                     [&](const std::size_t    facet,
                         const unsigned int   tooth,
                         const SurfaceTensor &strain) {
                       for (std::size_t c = 0; c < 3; ++c)
                         waves.fillets[f][facet][c] += phase(tooth) * strain[c];
                     });
    return waves;
  }

  std::vector<double> StressWavePlaces::measure_tensions(const std::size_t    fillet,
                                                         const FilletStrains &strains) const
  {
    std::vector<double> tensions(count_facets(fillets_[fillet]->fillet), 0.);
    for_each_facet(*fillets_[fillet],
                   strains,
                   [&](const std::size_t facet, unsigned int, const SurfaceTensor &strain) {
                     tensions[facet] =
                       std::max(tensions[facet],
                                find_tension(strain, fillets_[fillet]->fillet.material()));
                   });
    return tensions;
  }

  std::vector<double> StressWavePlaces::measure_probes(const ProbeMeasure &probes) const
  {
    std::vector<double> stresses;
    for (const std::vector<Probe> &copies : copies_)
      {
        stresses.push_back(0);
        for (const ProbeValue &value : probes(copies))
          stresses.back() = std::max(stresses.back(), value.von_mises);
      }
    return stresses;
  }

  Eigen::MatrixXd StressWavePlaces::read(const ProbeMeasure        &probes,
                                         const FilletStrains *const strains) const
  {
    std::size_t n_columns = 6 * copies_.size();
    for (const MemberFillet *member : fillets_)
      n_columns += 3 * count_facets(member->fillet);
    Eigen::MatrixXd read   = Eigen::MatrixXd::Zero(structure_.n_sectors(), n_columns);
    std::size_t     column = 0;
    for (const std::vector<Probe> &copies : copies_)
      {
        const std::vector<ProbeValue> values = probes(copies);
        for (std::size_t m = 0; m < values.size(); ++m)
          read.block<1, 6>(structure_.sector_of(copies[m].node), column) =
            Eigen::Map<const Eigen::Matrix<double, 1, 6>>(values[m].stress.data());
        column += 6;
      }
    for (std::size_t f = 0; strains != nullptr && f < fillets_.size(); ++f)
      {
        for_each_facet(*fillets_[f],
                       *strains,
                       [&](const std::size_t    facet,
                           const unsigned int   tooth,
                           const SurfaceTensor &strain) {
                         read.block<1, 3>(tooth, column + 3 * facet) = strain.transpose();
                       });
        column += 3 * count_facets(fillets_[f]->fillet);
      }
    return read;
  }

  std::vector<double> StressWavePlaces::find_largest(const Eigen::MatrixXd &read) const
  {
    std::vector<double> largest;
    Eigen::Index        column = 0;
    for (std::size_t p = 0; p < copies_.size(); ++p, column += 6)
      {
        largest.push_back(0);
        for (Eigen::Index sector = 0; sector < read.rows(); ++sector)
          largest.back() =
            std::max(largest.back(),
                     von_mises(Stress(read.block<1, 6>(sector, column).transpose())));
      }
    for (const MemberFillet *member : fillets_)
      {
        largest.push_back(0);
        const Eigen::Index end = column + 3 * count_facets(member->fillet);
        for (; column < end; column += 3)
          for (Eigen::Index tooth = 0; tooth < read.rows(); ++tooth)
            largest.back() =
              std::max(largest.back(),
                       find_tension(SurfaceTensor(read.block<1, 3>(tooth, column).transpose()),
                                    member->fillet.material()));
      }
    return largest;
  }

  std::vector<double> StressWavePlaces::find_largest(const StressWaves &waves) const
  {
    std::vector<double> largest;
    for (const StressWaves::OfProbe &probe : waves.probes)
      largest.push_back(find_largest_of(probe, [](const std::array<double, 6> &parts) {
        return von_mises(Eigen::Map<const Stress>(parts.data()));
      }));
    for (std::size_t f = 0; f < waves.fillets.size(); ++f)
      {
        largest.push_back(0);
        for (const StressWaves::OfFacet &facet : waves.fillets[f])
          largest.back() =
            std::max(largest.back(),
                     find_largest_of(facet, [&](const std::array<double, 3> &parts) {
                       return find_tension(SurfaceTensor(parts[0], parts[1], parts[2]),
                                           fillets_[f]->fillet.material());
                     }));
      }
    return largest;
  }
} // namespace vfife
