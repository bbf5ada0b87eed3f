// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/model/constraints/supports.h>
#include <vfife/output/observers/history_writer.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    using Now            = const Measurements &;
    using HistoryColumns = SampleColumns<Measurements>;

    // Measurements are in the units inside (rad, mm, N mm); columns are in those of a reader.
    void add_energies(const bool is_pair, HistoryColumns &columns)
    {
      const auto add = [&columns](const char *name, double EnergyLedger::*energy) {
        columns.add(name, "mJ", [energy](Now now) { return now.energy.*energy; });
      };
      add("kinetic energy", &EnergyLedger::kinetic);
      add("relative kinetic energy", &EnergyLedger::kinetic_relative);
      add("strain energy", &EnergyLedger::strain);
      add("contact energy", &EnergyLedger::contact);
      add("work of the drive", &EnergyLedger::drive_work);
      add(is_pair ? "work of the torques" : "work of the loads", &EnergyLedger::torque_work);
      add("damping loss", &EnergyLedger::damping_loss);
      add("removed by the driven speed damping", &EnergyLedger::mesh_damping_uptake);
      add("contact loss", &EnergyLedger::contact_loss);
      columns.add(column::energy_error, "-", [](Now now) { return now.energy.error(); });
    }

    /** Quantities of probe number @p p of the model, under its name. */
    void add_probe(const Probe &probe, const std::size_t p, HistoryColumns &columns)
    {
      std::vector<ProbeQuantity> quantities =
        list_probe_quantities(probe.fixed_axes ? column::fixed_axes : column::cylindrical_axes);
      // Equivalent stresses stand behind all components.
      std::stable_partition(quantities.begin(),
                            quantities.end(),
                            [](const ProbeQuantity &quantity) {
                              return quantity.kind != ProbeQuantityKind::equivalent_stress;
                            });
      for (const ProbeQuantity &quantity : quantities)
        columns.add(probe.name + " " + quantity.name,
                    quantity.unit,
                    [p, value = quantity.value](Now now) { return value(now.probes.at(p)); });
    }

    /** Force and moment of support number @p s of the model, under its name. */
    void add_reaction(const std::string &support, const std::size_t s, HistoryColumns &columns)
    {
      for (unsigned int c = 0; c < 3; ++c)
        columns.add(support + " reaction force " + column::fixed_axes[c], "N", [s, c](Now now) {
          return now.reactions.at(s).force[c];
        });
      for (unsigned int c = 0; c < 3; ++c)
        columns.add(support + " reaction moment " + column::fixed_axes[c], "N mm", [s, c](Now now) {
          return now.reactions.at(s).moment[c];
        });
    }

    /** Force of each contact on its slave or on the body at its wall. */
    void add_contacts(const Model &model, HistoryColumns &columns)
    {
      std::vector<std::string> names;
      for (const ContactPair &pair : model.contacts)
        names.push_back(pair.side);
      for (const RigidWall &wall : model.walls)
        names.push_back(wall.name);
      for (std::size_t i = 0; i < names.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          columns.add(names[i] + " contact force " + column::fixed_axes[c], "N", [i, c](Now now) {
            return now.contact_forces.at(i)[c];
          });
    }

    /** What gear pairs have files and figures of their own for. */
    void add_motion(const Model &model, HistoryColumns &columns)
    {
      for (unsigned int c = 0; c < 3; ++c)
        columns.add(std::string("momentum ") + column::fixed_axes[c], "N s", [c](Now now) {
          return now.momentum[c];
        });
      for (unsigned int c = 0; c < 3; ++c)
        columns.add(std::string("angular momentum ") + column::fixed_axes[c],
                    "N mm s",
                    [c](Now now) { return now.angular_momentum[c]; });
      for (std::size_t p = 0; p < model.probes.size(); ++p)
        add_probe(model.probes[p], p, columns);
      const std::vector<Support> supports = list_supports(model);
      for (std::size_t s = 0; s < supports.size(); ++s)
        add_reaction(supports[s].name, s, columns);
    }

    /** Integrals over all steps, between the samples too. */
    void add_impulses(const std::string                  &torque,
                      const HistoryWriter::ImpulseReader &impulse,
                      HistoryColumns                     &columns)
    {
      if (!impulse)
        return;
      columns.add(ContactImpulse::column_of(column::contact_force_total), "N s", [impulse](Now) {
        return impulse().force;
      });
      columns.add(ContactImpulse::column_of(torque), "N m s", [impulse](Now) {
        return 1e-3 * impulse().torque;
      });
    }

    /** All columns in the order of the file. */
    HistoryColumns list_columns(const Model &model, const HistoryWriter::ImpulseReader &impulse)
    {
      HistoryColumns    columns;
      const auto *const pair   = model.only_transmission();
      const std::string driver = pair ? model.bodies[pair->driver].name() : "";
      const std::string driven = pair ? model.bodies[pair->driven].name() : "";
      if (pair)
        {
          columns.add(column::angle_of(driver), "deg", [](Now now) {
            return now.driver_angle / degree;
          });
          columns.add(column::angle_of(driven), "deg", [](Now now) {
            return now.driven_angle / degree;
          });
          // As the drive prescribes them.
          const double speed = pair->driver_rate, mesh = pair->mesh_frequency();
          columns.add(column::speed, "rpm", [speed](Now now) {
            return speed * now.rate_factor * 30 / pi;
          });
          columns.add(column::mesh_frequency, "Hz", [mesh](Now now) {
            return mesh * now.rate_factor;
          });
          columns.add(column::dte, "arcsec", [](Now now) {
            return now.transmission_error / arcsecond;
          });
          columns.add(column::rim_dte, "arcsec", [](Now now) {
            return now.rim_transmission_error / arcsecond;
          });
        }
      columns.add(column::contact_force_total, "N", [](Now now) { return now.contact_force; });
      if (pair)
        {
          columns.add(column::contact_torque_on(driven), "N m", [](Now now) {
            return 1e-3 * now.contact_torque;
          });
          columns.add(column::teeth_in_contact, "-", [](Now now) { return now.teeth_in_contact; });
          add_impulses(column::contact_torque_on(driven), impulse, columns);
        }
      columns.add("largest penetration", "um", [](Now now) {
        return 1e3 * now.largest_penetration;
      });
      add_energies(pair != nullptr, columns);
      if (!pair)
        {
          add_contacts(model, columns);
          add_motion(model, columns);
        }
      return columns;
    }
  } // namespace

  HistoryWriter::HistoryWriter(const OutputFolder  &folder,
                               const Model         &model,
                               const std::uint64_t  steps_between,
                               const ImpulseReader &impulse)
    : SampledTable(folder, "history.csv", list_columns(model, impulse), steps_between)
  {
  }

  void HistoryWriter::add_rows(const Model &, const State &state)
  {
    add_row(state, state.measured);
  }
} // namespace vfife
