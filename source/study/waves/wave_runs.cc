// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/types.h>
#include <vfife/model/model.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_reader.h>
#include <vfife/study/case_runner.h>
#include <vfife/study/stress_waves/stress_wave_places.h>
#include <vfife/study/stress_waves/stress_wave_writers.h>
#include <vfife/study/waves/wave_runs.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vfife
{
  namespace
  {
    /** probe_waves.csv or fillet_waves.csv: its rows at the start and of the last mesh cycle. */
    class WaveTable
    {
    public:
      /** @p turned: exp(-i omega t) at the samples of the run behind the start, equally spaced. */
      WaveTable(const std::string          &path,
                const std::vector<Complex> &turned,
                const WaveSchedule         &schedule,
                const double                mesh_time)
        : table_(read_result_table(path))
      {
        const std::vector<double> &time = table_.numbers(column::time);
        for (const double t : time)
          {
            const auto sample = std::size_t(std::lround(t * schedule.samples / mesh_time));
            weights_.push_back(sample == 0 ? 0. : turned.at(sample - 1) / double(schedule.samples));
          }
        const std::size_t at_start = std::count(weights_.begin(), weights_.end(), 0.);
        if (n_rows() != at_start * (schedule.samples + 1))
          throw InputError("\"" + path + "\" does not have the start and the last mesh cycle");
      }

      std::size_t n_rows() const
      {
        return table_.n_rows();
      }
      bool is_start(const std::size_t row) const
      {
        return weights_[row] == 0.;
      }
      const std::string &text(const std::string &name, const std::size_t row) const
      {
        return table_.column(name).texts[row];
      }
      double number(const std::string &name, const std::size_t row) const
      {
        return table_.numbers(name)[row];
      }
      /** What a row adds to the amplitude of a driven wave: columns "NAME cos", "NAME sin". */
      Complex part(const std::string &name, const std::size_t row) const
      {
        return weights_[row] * Complex(number(name + " cos", row), -number(name + " sin", row));
      }

    private:
      Table                table_;
      std::vector<Complex> weights_; ///< of the rows; zero at the start
    };

    /** @p n with that of the start. */
    void require_samples(const Table &table, const std::size_t n)
    {
      if (table.n_rows() != n)
        throw InputError("expected " + std::to_string(n) + " samples, got " +
                         std::to_string(table.n_rows()));
    }
  } // namespace

  WaveRuns::WaveRuns(const CaseRunner       &runner,
                     CommandLine             study,
                     const Model            &model,
                     const StressWavePlaces &places,
                     const OutputFolder     &folder,
                     Log                    &log,
                     const bool              resumes)
    : runner_(runner)
    , study_(std::move(study))
    , model_(model)
    , places_(places)
    , folder_(folder)
    , log_(log)
    , resumes_(resumes)
  {
  }

  CommandLine WaveRuns::command_line(CommandLine        study,
                                     const double       speed,
                                     const unsigned int n_meshes,
                                     const unsigned int diameters,
                                     const bool         fillets)
  {
    // They come last and win.
    for (const std::string &entry : {std::string("Study/kind=run"),
                                     "Operation/speed=" + number_text(speed * 30. / pi) + " rpm",
                                     "Operation/mesh cycles=" + std::to_string(n_meshes),
                                     std::string("Operation/end time=0 s"),
                                     "Output/stress wave diameters=" + std::to_string(diameters),
                                     // As the readings of the reduced pair beside them.
                                     std::string("Fillets/source=elements"),
                                     std::string("Fillets/teeth=") + (fillets ? "all" : "none"),
                                     std::string("Output/field output interval=0"),
                                     std::string("Output/report=no")})
      study.overrides.push_back(entry);
    return study;
  }

  WaveMotion WaveRuns::drive(const WaveMeeting  &meeting,
                             const WaveSchedule &schedule,
                             const std::string  &name) const
  {
    const Communicator &all = folder_.communicator();
    Communicator        ranks(all.mpi());
    CommandLine         line = command_line(study_,
                                    schedule.speed,
                                    schedule.n_meshes(),
                                    meeting.wave.diameters,
                                    !places_.fillets().empty());
    line.output_folder       = folder_.file(name);
    folder_.list_file(name + "/");
    log_.line(name,
              " begins: a run at ",
              schedule.speed * 30. / pi,
              " rpm, ",
              schedule.n_meshes(),
              " mesh cycles");
    const CaseReport report = runner_.do_case(line, resumes_, ranks);
    log_.line(name, " ", report.describe());
    if (report.outcome == Outcome::interrupted)
      throw Interrupted(
        "the study of waves is stopped. Run the same command with --restart to continue");
    if (report.outcome == Outcome::failed)
      throw NumericalError(name + " has failed: " + report.message);

    // One rank reads, files may appear on the others later; what it has read, or why it has not, is
    // told to all.
    std::string failure, bytes;
    if (all.is_root())
      try
        {
          ByteStream stream;
          read(meeting, schedule, line.output_folder).serialize(stream);
          bytes = stream.bytes();
        }
      catch (const InputError &error)
        {
          failure = error.what();
        }
      catch (const std::logic_error &error)
        {
          failure = error.what(); // columns that tables of runs have, but not these files
        }
    failure = all.broadcast(failure);
    if (!failure.empty())
      throw NumericalError(name + " cannot be read: " + failure);
    ByteStream stream(all.broadcast(bytes), name);
    WaveMotion motion;
    motion.serialize(stream);
    return motion;
  }

  WaveMotion WaveRuns::read(const WaveMeeting  &meeting,
                            const WaveSchedule &schedule,
                            const std::string  &path) const
  {
    const unsigned int n        = meeting.wave.diameters;
    const Table        rim      = read_result_table(path + "/rim.csv"),
                history         = read_result_table(path + "/history.csv");
    const std::size_t n_samples = std::size_t(schedule.n_meshes()) * schedule.samples;
    // The first one is that of the start.
    require_samples(rim, n_samples + 1);
    require_samples(history, n_samples + 1);

    WaveRecord           record(meeting, *model_.only_transmission(), schedule);
    std::vector<Complex> turned;
    for (std::size_t k = 1; k <= n_samples; ++k)
      {
        turned.push_back(record.turned());
        record.add({rim.numbers("z cos " + std::to_string(n))[k],
                    n == 0 ? 0. : -rim.numbers("z sin " + std::to_string(n))[k]},
                   history.numbers(column::dte)[k] * arcsecond,
                   history.numbers(column::contact_force_total)[k]);
      }
    WaveMotion motion = record.finish();
    motion.energy_error =
      std::abs(read_figure(path + "/summary.json", summary_place::energy_error));
    read_stresses(path, schedule, turned, motion);
    return motion;
  }

  void WaveRuns::read_stresses(const std::string          &path,
                               const WaveSchedule         &schedule,
                               const std::vector<Complex> &turned,
                               WaveMotion                 &motion) const
  {
    const auto &names = places_.names();
    const auto  place = [&names](const std::string &name) {
      return std::size_t(std::find(names.begin(), names.end(), name) - names.begin());
    };
    motion.static_stress  = std::vector<double>(names.size(), 0.);
    const auto add_static = [&](const std::size_t at, const double stress) {
      motion.static_stress.at(at) = std::max(motion.static_stress.at(at), stress);
    };
    StressWaves waves = places_.none();
    // A row is of one place and sample.
    const WaveTable probes(path + "/probe_waves.csv", turned, schedule, motion.mesh_time);
    const auto      stresses = column::stresses(column::cylindrical_axes);
    for (std::size_t row = 0; row < probes.n_rows(); ++row)
      {
        const std::size_t at = place(probes.text(column::probe, row));
        if (probes.is_start(row))
          add_static(at, probes.number("largest von mises", row));
        else
          for (std::size_t c = 0; c < stresses.size(); ++c)
            waves.probes.at(at)[c] += probes.part(stresses[c], row);
      }
    if (!places_.fillets().empty())
      {
        const WaveTable fillets(path + "/fillet_waves.csv", turned, schedule, motion.mesh_time);
        for (std::size_t row = 0; row < fillets.n_rows(); ++row)
          {
            const std::size_t at    = place(fillets.text("fillet", row)),
                              facet = std::size_t(fillets.number("facet", row));
            if (fillets.is_start(row))
              add_static(at, fillets.number("largest tension", row));
            else
              for (std::size_t c = 0; c < strain_wave_names.size(); ++c)
                waves.fillets.at(at - places_.n_probes()).at(facet)[c] +=
                  1e-6 * fillets.part(strain_wave_names[c], row);
          }
      }
    motion.wave_stress = places_.find_largest(waves);
  }
} // namespace vfife
