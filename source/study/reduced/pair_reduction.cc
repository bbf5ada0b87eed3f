// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/model/model.h>
#include <vfife/output/files/matrix_writer.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/sealed_file.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/output/observers/rim_writer.h>
#include <vfife/reduced/body_reduction.h>
#include <vfife/reduced/pair_readings.h>
#include <vfife/reduced/real_body.h>
#include <vfife/reduced/reduced_pair.h>
#include <vfife/reduced/reduction_source.h>
#include <vfife/study/reduced/pair_reduction.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>

namespace vfife
{
  namespace
  {
    const SealedFile seal    = {"vfife-reduction", "reduced body", 3};
    const char       entry[] = "Reduced/store";

    /** "Pinion" is kept in pinion.reduction. */
    std::string file_name(std::string name)
    {
      std::transform(name.begin(), name.end(), name.begin(), [](const unsigned char c) {
        return std::isalnum(c) ? static_cast<char>(std::tolower(c)) : '_';
      });
      return name + ".reduction";
    }

    /** What there is less of than is asked for (a sentence's end), or nothing. */
    std::string find_lack(const ReducedBody &body, const ReductionOptions &least)
    {
      constexpr double   same = 1. - 1e-9;
      std::ostringstream text;
      if (std::abs(body.rate) < same * std::abs(least.rate))
        text << "is for its speeds up to " << std::abs(body.rate) * 30. / pi << " rpm";
      else if (body.cutoff < same * least.cutoff)
        text << "has modes below " << .5 / pi * body.cutoff << " Hz";
      else if (body.reach < std::min(least.reach, body.n_sectors / 2))
        text << "reaches over " << body.reach << " sectors";
      return text.str();
    }

    /** Reduced bodies in files of a folder, with what they were made of. All functions are
     * collective. */
    class ReductionStore
    {
    public:
      /** @p folder: without a name nothing is kept. Everything given must outlive the object. */
      ReductionStore(std::string folder, const Communicator &communicator, Log &log)
        : folder_(std::move(folder))
        , communicator_(communicator)
        , log_(log)
      {
      }

      /**
       * The body kept as @p name, if there is one for rate, cut-off and reach of @p least or more.
       * Throws InputError where it is of another source, which it names, or the file is damaged or
       * of another version.
       */
      std::optional<ReducedBody> find(const std::string      &name,
                                      const ReductionSource  &source,
                                      const ReductionOptions &least) const
      {
        if (folder_.empty())
          return {};
        // One rank reads; all get the same bytes or the same complaint.
        const std::string path = folder_ + "/" + file_name(name);
        std::string       bytes, complaint;
        if (communicator_.is_root() && std::filesystem::exists(path))
          complaint = seal.read(path, bytes);
        complaint = communicator_.broadcast(complaint);
        bytes     = communicator_.broadcast(bytes);
        if (!complaint.empty())
          throw InputError(entry, complaint + ". Remove it, or name another folder");
        if (bytes.empty())
          return {};

        ByteStream      stream(bytes, "\"" + path + "\"");
        ReductionSource stored;
        ReducedBody     body;
        stored.serialize(stream);
        const std::string difference = source.find_difference(stored);
        if (!difference.empty())
          throw InputError(entry,
                           "\"" + path + "\" belongs to another body: its " + difference +
                             " differs. Remove it, or name another folder");
        serialize(body, stream);
        stream.finish();
        const std::string lack = find_lack(body, least);
        if (!lack.empty())
          {
            log_.line("\"", path, "\" ", lack, ": the body is reduced again");
            return {};
          }
        return body;
      }

      /** Throws InputError where the folder cannot be made or written to: before a body is reduced,
       * which takes long. */
      void require_writable() const
      {
        if (!folder_.empty())
          make_folder();
      }

      /** Keeps it. Throws std::runtime_error where the disk does not take it. */
      void keep(const std::string &name, ReductionSource source, ReducedBody &body) const
      {
        if (folder_.empty())
          return;
        const OutputFolder folder = make_folder();
        if (!folder.is_writer())
          return;
        ByteStream stream;
        source.serialize(stream);
        serialize(body, stream);
        folder.write_file(file_name(name),
                          [&](std::ostream &out) { seal.write(stream.bytes(), out); });
      }

    private:
      OutputFolder make_folder() const
      {
        return for_entry(entry, [this] { return OutputFolder(folder_, communicator_); });
      }

      std::string         folder_;
      const Communicator &communicator_;
      Log                &log_;
    };

    void
    log_body(const std::string &name, const ReducedBody &body, const std::string &origin, Log &log)
    {
      log.line(name,
               ": ",
               body.n_modes(),
               " modes below ",
               .5 / pi * body.cutoff,
               " Hz (pairs with nodal diameters count once), ",
               body.touch_nodes.size(),
               " nodes per sector that may be in contact, residual flexibility beyond ",
               body.reach,
               " sectors at most ",
               100. * body.residual_left,
               " % of the largest, ",
               origin);
    }
  } // namespace

  std::vector<ReducedBody> reduce_pair(const Model                &model,
                                       const PairReductionOptions &options,
                                       const Communicator         &communicator,
                                       Log                        &log)
  {
    require_reducible(model);
    const ReductionStore     store(options.store, communicator, log);
    std::vector<ReducedBody> bodies;
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        const auto       start = WallClock::now();
        const Body      &body  = model.bodies[b];
        ReductionOptions of_body{
          list_touch_nodes(model, b),
          list_readings(model, b, options.fem, RimWriter::count_diameters(model)),
          options.fem,
          options.faster * body.rate,
          2. * pi * options.cutoff,
          options.reach};
        if (options.more)
          for (SectorReading &reading : options.more(b))
            of_body.readings.push_back(std::move(reading));
        const ReductionSource source(model, b, of_body);
        if (auto kept = store.find(body.name(), source, of_body))
          {
            log_body(body.name(), *kept, "from \"" + options.store + "\"", log);
            bodies.push_back(std::move(*kept));
            continue;
          }
        store.require_writable();
        bodies.push_back(reduce_body(model, b, of_body, communicator));
        log_body(body.name(), bodies.back(), duration_text(seconds_since(start)), log);
        store.keep(body.name(), source, bodies.back());
      }
    return bodies;
  }

  double find_kept_cutoff(const std::vector<ReducedBody> &bodies)
  {
    double cutoff = 0;
    for (const ReducedBody &body : bodies)
      cutoff = std::max(cutoff, .5 / pi * body.cutoff);
    return cutoff;
  }

  void export_bodies(const std::vector<ReducedBody> &bodies,
                     const Model                    &model,
                     const OutputFolder             &folder)
  {
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const std::string name = model.bodies[b].name() + "_";
        const RealBody    real = make_real_body(bodies[b], model, b);
        const auto        write =
          [&](const char *const what, const Eigen::MatrixXd &matrix, const std::string &meaning) {
            write_matrix_market(folder, name + what + ".mtx", matrix, meaning);
          };
        std::ostringstream rate;
        rate << bodies[b].rate;
        write("mass", real.mass, "M of M x'' + 2 Omega G x' + (K + (Omega^2 - Omega_0^2) D) x = f");
        write("stiffness", real.stiffness, "K at Omega_0 = " + rate.str() + " rad/s");
        write("coriolis", real.coriolis, "G, antisymmetric");
        write("spin_stiffness", real.spin_stiffness, "D");
        write("shapes", real.shapes, "values of " + name + "rows.csv from x");
        write("residual",
              real.residual,
              "mm/N: flank nodes, residual displacement under forces on them");
        write("torque", real.torque, "f of a torque of 1 N mm about the axis of rotation");
        if (real.seats.size() > 0)
          write("seat_stiffness",
                real.seats,
                "springs of the bearings' seats that " + name + "stiffness.mtx contains");
        write_csv(folder, name + "coordinates.csv", real.coordinates);
        write_csv(folder, name + "rows.csv", real.rows);
      }
  }
} // namespace vfife
