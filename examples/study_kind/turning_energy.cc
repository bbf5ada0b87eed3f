// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "turning_energy.h"

#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/table.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/study/cases/case.h>
#include <vfife/study/cases/case_kinds.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>

using namespace vfife;

namespace
{
  class TurningEnergy : public StudyKind
  {
  public:
    void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
    {
      // The sections of the case, be it a gear pair or a general model ...
      case_ = make_case(file);
      case_->declare(prm, file);
      // ... and those of this kind: value, unit, meaning and range in one place.
      const Subsection section(prm, "Turning energy");
      declare_quantity(prm,
                       "overspeed",
                       overspeed_,
                       "-",
                       "Speed over that of the case, at which the energy is stated",
                       Range::positive());
    }

    void check() const override
    {
      case_->check();
    }

    void inspect(Communicator &, Log &log) override
    {
      case_->make_model(log);
    }

    void run(OutputFolder &folder, Log &log) override
    {
      Table table;
      table.add_text_column("body");
      table.add_column("mass", "kg");
      table.add_column("polar inertia", "kg mm^2");
      table.add_column("speed", "rpm");
      table.add_column("energy", "J");
      const Model model = case_->make_model(log);
      for (const Body &body : model.bodies)
        {
          // Inside the units are mm, s, t, N, MPa: energies in mJ.
          const double rate   = overspeed_ * std::abs(body.rate);
          const double energy = 1e-3 * 0.5 * body.axial_inertia() * rate * rate;
          table.add_row(
            {body.name(), 1e3 * body.mass(), 1e3 * body.axial_inertia(), rate * 30. / pi, energy});
          log.line(
            body.name(), ": ", std::round(energy), " J at ", std::round(rate * 30. / pi), " rpm");
        }
      write_tables(folder, "bodies", table);
    }

  private:
    std::unique_ptr<Case> case_;
    double                overspeed_ = 1.2;
  };
} // namespace

std::unique_ptr<StudyKind> make_turning_energy()
{
  return std::make_unique<TurningEnergy>();
}
