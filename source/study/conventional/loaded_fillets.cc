// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/study/conventional/loaded_contact_tables.h>
#include <vfife/study/conventional/loaded_fillets.h>

namespace vfife
{
  namespace
  {
    template <typename Sample>
    void add_rows(const SampleColumns<Sample> &columns,
                  const double                 position,
                  const std::vector<Sample>   &samples,
                  Table                       &table)
    {
      for (const Sample &sample : samples)
        {
          std::vector<Table::Cell> row = columns.cells_of(sample);
          row.insert(row.begin(), position);
          table.add_row(row);
        }
    }
  } // namespace

  LoadedFillets::LoadedFillets(const Model &model, const FilletOptions &options)
    : model_(model)
    , stress_columns_(list_root_stress_columns())
    , gauge_columns_(list_gauge_columns())
    , stress_(model, options)
    , stresses_(make_loaded_root_stress_table())
    , gauges_(make_loaded_gauge_table())
  {
  }

  void LoadedFillets::add_position(const FemSpace              &space,
                                   const double                 position,
                                   const PairEquilibriumResult &result)
  {
    // Bodies stay in the axes of time zero; turned teeth are their copies.
    if (!faces_)
      faces_ = std::make_unique<FilletFaces>(space, stress_.fillets());
    const FilletStrains strains = faces_->of(result.displacements);
    add_rows(stress_columns_,
             position,
             stress_.measure(position, result.teeth, strains),
             stresses_);
    add_rows(gauge_columns_, position, stress_.read_gauges(position, true, strains), gauges_);
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
    return stresses_.n_rows() > 0 ? list_root_figures(stress_) : NamedFigures();
  }
} // namespace vfife
