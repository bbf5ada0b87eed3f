// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/fem/pressure/pair_pressure.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/study/conventional/loaded_contact_tables.h>
#include <vfife/study/conventional/loaded_fillets.h>

namespace vfife
{
  LoadedFillets::LoadedFillets(const Model                         &model,
                               const FilletOptions                 &options,
                               std::unique_ptr<const RootSubmodels> submodels,
                               const bool                           spins)
    : model_(model)
    , stress_columns_(list_root_stress_columns())
    , gauge_columns_(list_gauge_columns())
    , submodels_(std::move(submodels))
    , spins_(spins)
    , stress_(submodels_ ? submodels_->fine() : model, options)
    , stresses_(make_loaded_root_stress_table())
    , gauges_(make_loaded_gauge_table())
  {
  }

  FilletStrains LoadedFillets::follow(const FemSpace                   &space,
                                      const PairEquilibrium            &equilibrium,
                                      const PairEquilibriumResult      &result,
                                      const std::vector<ToothPressure> &pressures) const
  {
    const ContactPair                        &contact = model_.contacts.front();
    std::array<RootSubmodels::MemberState, 2> states;
    for (unsigned int b = 0; b < states.size(); ++b)
      {
        const Body                 &body    = model_.bodies[b];
        const auto                 &parts   = submodels_->of_body(b);
        const SectorSubmodel       &teeth   = parts.front();
        const Matrix3               to_body = body.placement.rotation.transpose();
        const unsigned int          first   = space.find_part(b)->first_point;
        RootSubmodels::MemberState &state   = states[b];
        state.rate                          = spins_ ? body.rate : 0.;
        state.followed = [&, to_body, first](const std::size_t k, const unsigned int sector) {
          return parts[k].follow(sector, [&](const unsigned int node) -> Vector3 {
            return to_body * Eigen::Map<const Vector3>(result.displacements.data() +
                                                       3 * std::size_t(first + node));
          });
        };
        if (pressures.empty())
          for (const NodalForce &nodal : result.contact_forces)
            if (nodal.body == b)
              teeth.add_nodal_force(nodal.node, to_body * nodal.force, state.forces);
        // Normals are out of the master, at the position.
        const bool    is_slave = contact.slave_body == b;
        const Matrix3 back     = to_body * equilibrium.rotation(b).transpose();
        for (const ToothPressure &pressure : pressures)
          for (std::size_t i = 0; i < pressure.grid.cells.size(); ++i)
            teeth.add_force(is_slave ? contact.slave_surface : contact.master_surface,
                            is_slave ? pressure.slave_group : pressure.master_group,
                            pressure.places[is_slave ? 0 : 1][i],
                            (is_slave ? 1. : -1.) * pressure.grid.force_of(i) *
                              (back * pressure.grid.cells[i].normal),
                            state.forces);
      }
    return submodels_->of(std::move(states));
  }

  void LoadedFillets::add_position(const FemSpace                   &space,
                                   const double                      position,
                                   const PairEquilibrium            &equilibrium,
                                   const PairEquilibriumResult      &result,
                                   const std::vector<ToothPressure> &pressures)
  {
    // Bodies stay in the axes of time zero; turned teeth are their copies.
    if (!faces_ && !submodels_)
      faces_ = std::make_unique<FilletFaces>(space, stress_.fillets());
    const FilletStrains strains =
      submodels_ ? follow(space, equilibrium, result, pressures) : faces_->of(result.displacements);
    for (const RootStressSample &sample : stress_.measure(position, result.teeth, strains))
      {
        stresses_.add_row(stress_columns_.make_row(position, sample));
        if (RootExtreme &largest = largest_[sample.body];
            !Fillet::is_at_hub(sample.fillet) && sample.tension.stress > largest.stress)
          largest = sample.tension;
      }
    for (const GaugeSample &sample : stress_.read_gauges(position, true, strains))
      gauges_.add_row(gauge_columns_.make_row(position, sample));
  }

  void LoadedFillets::write(const OutputFolder &folder, Log &log) const
  {
    if (stresses_.n_rows() > 0)
      {
        write_csv(folder, "root_stress.csv", stresses_);
        write_csv(folder, "fillet_envelope.csv", stress_.envelope());
        write_csv(folder, "root_sections.csv", stress_.sections());
        for (const auto &[name, figure] : list_figures())
          log.line(name, " ", figure.value, " ", figure.unit);
      }
    if (gauges_.n_rows() > 0)
      write_csv(folder, "gauges.csv", gauges_);
  }

  NamedFigures LoadedFillets::list_figures() const
  {
    if (stresses_.n_rows() == 0)
      return {};
    NamedFigures figures = list_root_figures(stress_);
    if (submodels_)
      for (const auto &[body, extreme] : largest_)
        figures.push_back({body + " traction left at the root tension", {extreme.traction, "MPa"}});
    return figures;
  }
} // namespace vfife
