// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/number_list.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/quantity.h>
#include <vfife/model/transmission.h>
#include <vfife/output/output_options.h>

#include <deal.II/base/config.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    const Choices<Verbosity> &verbosities()
    {
      static const Choices<Verbosity> choices = {{"quiet", Verbosity::quiet},
                                                 {"normal", Verbosity::normal},
                                                 {"detailed", Verbosity::detailed}};
      return choices;
    }

    const Choices<FieldFormat> &field_formats()
    {
      static const Choices<FieldFormat> choices = {{"vtu", FieldFormat::vtu},
                                                   {"hdf5", FieldFormat::hdf5}};
      return choices;
    }

    /** Steps of @p dt in one mesh cycle, at the largest speed of a run, not rounded. */
    double steps_per_mesh(const Transmission &transmission, const double dt)
    {
      return 1. / (transmission.largest_mesh_frequency() * dt);
    }
  } // namespace

  std::vector<unsigned int> parse_diameters(const std::vector<std::string> &texts)
  {
    std::vector<unsigned int> numbers;
    for (const std::string &text : texts)
      {
        const double value = parse_quantity(text, "-");
        if (!(value >= 0 && value <= 1000) || value != std::floor(value))
          throw InputError("expected a number of nodal diameters (0, 1, 2, 3 ...), got \"" + text +
                           "\"");
        if (std::find(numbers.begin(), numbers.end(), value) != numbers.end())
          throw InputError("duplicate number of nodal diameters \"" + text + "\"");
        numbers.push_back(static_cast<unsigned int>(value));
      }
    return numbers;
  }

  void OutputOptions::declare(dealii::ParameterHandler &prm)
  {
    Subsection section(prm, "Output");
    declare_integer(prm,
                    history_entry(),
                    history_every,
                    of_model ? "Time steps per sample of the histories"
                             : "Samples of the histories per mesh cycle",
                    1);
    declare_number(prm,
                   "field output interval",
                   fields_every,
                   std::string("Interval between field files, in ") +
                     (of_model ? "samples of the histories" : "mesh cycles, such as 0.25") +
                     "; none: no field files",
                   Range::positive().or_word("none"));
    declare_choice(prm,
                   "field format",
                   field_format,
                   field_formats(),
                   "Files of the fields: vtu: fields.pvd with one .vtu file per time; hdf5: "
                   "fields.xdmf with all times in fields.h5, the elements once");
    declare_integer(prm,
                    "tracked mesh harmonics",
                    mesh_orders,
                    "Number of mesh harmonics whose amplitudes are tracked over speed in a run "
                    "with changing speed (orders.csv); at most a quarter of the samples per mesh "
                    "cycle; 0: none");
    declare_integer(prm,
                    "order window",
                    order_window,
                    "Length of the window for tracked mesh harmonics, in mesh cycles; windows "
                    "overlap by half",
                    2);
    declare_number_list(
      prm,
      "stress wave diameters",
      stress_waves,
      "Nodal diameters of stress waves around the driven member that are extracted "
      "at its probes (probe_waves.csv) and fillets (fillet_waves.csv, with "
      "Fillets/teeth), at the start and over the last mesh cycle; for gear pairs",
      ListNumbers::whole);
    declare_quantity(prm,
                     "checkpoint interval",
                     checkpoint_every,
                     "s",
                     "Wall time between checkpoints; one follows the static equilibrium at the "
                     "start and one ends the run; none: no checkpoints",
                     Range::positive().or_word("none"));
    declare_switch(prm,
                   "report",
                   pictures,
                   "Writes the report with plots and pictures into the folder of the results");
    declare_choice(prm,
                   "verbosity",
                   verbosity,
                   verbosities(),
                   "Messages on the screen: quiet: warnings only; normal: progress; detailed: "
                   "everything");
  }

  std::string OutputOptions::history_entry() const
  {
    return of_model ? "steps per sample" : "samples per mesh cycle";
  }

  void OutputOptions::check(const std::string &section) const
  {
    if (history_every == 0)
      throw InputError(section + "/" + history_entry(), "must be at least 1");
    if (!(fields_every >= 0) || !std::isfinite(fields_every))
      throw InputError(section + "/field output interval",
                       "must be a number of mesh cycles or samples, 0 for none");
#ifndef DEAL_II_WITH_HDF5
    if (field_format == FieldFormat::hdf5)
      throw InputError(section + "/field format",
                       "expected vtu, got hdf5, which requires a deal.II with HDF5. Set vtu");
#endif
    if (!(checkpoint_every >= 0) || !std::isfinite(checkpoint_every))
      throw InputError(section + "/checkpoint interval",
                       "must be a wall time in seconds, 0 for none");
    for_entry(section + "/stress wave diameters", [this] { parse_diameters(stress_waves); });
  }

  void OutputOptions::refuse_stress_waves(const std::string &section) const
  {
    if (!stress_waves.empty())
      throw InputError(section + "/stress wave diameters", "requires a gear pair with sectors");
  }

  unsigned int OutputOptions::count_tracked_orders() const
  {
    return std::min(mesh_orders, history_every / 4);
  }

  std::uint64_t OutputOptions::compute_history_steps(const Transmission *transmission,
                                                     const double        dt) const
  {
    if (transmission == nullptr)
      return history_every;
    if (!(dt > 0) || !(transmission->mesh_frequency() > 0))
      throw InputError("Output/samples per mesh cycle",
                       "samples per mesh cycle require a rotating gear pair and a time step");
    // The small addition keeps 49.999999 steps, which are 50 but for round-off, from becoming 49.
    const double steps = std::floor(steps_per_mesh(*transmission, dt) / history_every + 1e-6);
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(steps));
  }

  std::uint64_t OutputOptions::compute_field_steps(const Transmission *transmission,
                                                   const double        dt) const
  {
    if (fields_every == 0)
      return 0;
    // Fields at samples: their multiples in steps nearest to the mesh cycles asked for.
    const std::uint64_t sample = compute_history_steps(transmission, dt);
    if (transmission == nullptr)
      {
        if (fields_every != std::floor(fields_every))
          throw InputError("Output/field output interval",
                           "expected a whole number of samples for a model without a gear pair");
        return static_cast<std::uint64_t>(fields_every) * sample;
      }
    const double samples = std::round(fields_every * steps_per_mesh(*transmission, dt) / sample);
    return sample * std::max<std::uint64_t>(1, static_cast<std::uint64_t>(samples));
  }
} // namespace vfife
