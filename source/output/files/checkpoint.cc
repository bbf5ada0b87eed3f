// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/revision.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/model/model.h>
#include <vfife/output/files/checkpoint.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/sealed_file.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace vfife
{
  namespace
  {
    namespace fs = std::filesystem;

    const char last_name[] = "checkpoint.bin", previous_name[] = "checkpoint.previous.bin";

    /** Raised where runs cannot go on from what earlier programs wrote: parts and entries are found
     * by their names (ByteStream::pass_part()), so that new ones do not raise it, but another
     * meaning of a default does. */
    const SealedFile seal = {"vfife-run-state", "checkpoint", 6};

    /** Both directions. */
    void serialize(ByteStream &stream, Checkpoint &checkpoint)
    {
      stream.pass_required_part("origin", [&](ByteStream &part) {
        part.pass(checkpoint.version, checkpoint.parameters, checkpoint.log_size);
      });
      const bool knows_defaults = stream.pass_part("set parameters", [&](ByteStream &part) {
        part.pass(checkpoint.set_parameters);
      });
      // Where nothing is known of defaults, any parameter may have been set.
      if (!knows_defaults)
        for (const auto &[path, value] : checkpoint.parameters)
          checkpoint.set_parameters.push_back(path);
      stream.pass_part("input digests",
                       [&](ByteStream &part) { part.pass(checkpoint.input_digests); });
      stream.pass_required_part("run", [&](ByteStream &part) {
        part.pass(checkpoint.common, checkpoint.own);
      });
    }

    /** What tells one body from another: counts, and sums that any change of the mesh moves. */
    struct BodyMark
    {
      std::string  name;
      unsigned int n_nodes = 0, n_elements = 0;
      double       mass = 0, coordinate_sum = 0;

      explicit BodyMark(const Body &body)
        : name(body.name())
        , n_nodes(body.n_nodes())
        , n_elements(body.n_elements())
        , mass(body.mass())
      {
        // Weights by node so that another numbering of the same nodes is another model.
        for (unsigned int i = 0; i < body.n_nodes(); ++i)
          coordinate_sum += (1. + i % 7) * body.node_positions()[i].cwiseAbs().sum();
      }

      bool is_same(const BodyMark &other) const
      {
        // The same computation on another machine or instruction set may round otherwise.
        const auto close = [](const double a, const double b) {
          return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
        };
        return name == other.name && n_nodes == other.n_nodes && n_elements == other.n_elements &&
               close(mass, other.mass) && close(coordinate_sum, other.coordinate_sum);
      }

      void serialize(ByteStream &stream)
      {
        stream.pass(name, n_nodes, n_elements, mass, coordinate_sum);
      }
    };
  } // namespace

  std::string present_version()
  {
    return std::string(program_version()) + " (" + program_revision() + ")";
  }

  std::string data_of(const Checkpoint &checkpoint)
  {
    return "the data in \"" + checkpoint.file + "\"";
  }

  void write_checkpoint(const OutputFolder &folder,
                        const std::string  &common,
                        const std::string  &own,
                        const bool          keeps_previous)
  {
    // One file, which the writing rank fills with what all ranks know.
    Checkpoint checkpoint;
    // What only a rank knows, in the order of the ranks: it serves as many ranks again,
    // "common" any number.
    checkpoint.own = folder.communicator().all_gather(own);
    if (!folder.is_writer())
      return;
    checkpoint.version        = present_version();
    checkpoint.parameters     = folder.parameters();
    checkpoint.set_parameters = folder.set_parameters();
    checkpoint.input_digests  = folder.input_digests();
    checkpoint.log_size       = folder.log_size();
    checkpoint.common         = common;
    ByteStream stream;
    serialize(stream, checkpoint);

    // The new file is complete before the old ones are touched.
    const std::string fresh = "checkpoint.new.bin";
    folder.write_file(fresh, [&](std::ostream &out) { seal.write(stream.bytes(), out); });
    // Between two of these renames a kill leaves the last file or the one before.
    std::error_code error;
    if (keeps_previous)
      // The first checkpoint has no file before it: that error is none.
      fs::rename(folder.file(last_name), folder.file(previous_name), error);
    else
      fs::remove(folder.file(previous_name), error);
    fs::rename(folder.file(fresh), folder.file(last_name), error);
    if (error)
      throw std::runtime_error("cannot write \"" + folder.file(last_name) +
                               "\": " + error.message());
  }

  Checkpoint read_checkpoint(const std::string &folder, const Communicator &communicator, Log &log)
  {
    // One rank reads; all get the same bytes or the same complaint, so that all throw.
    std::string file, bytes, complaint;
    if (communicator.is_root())
      {
        file      = folder + "/" + last_name;
        complaint = seal.read(file, bytes);
        if (!complaint.empty())
          {
            const std::string last = complaint;
            file                   = folder + "/" + previous_name;
            complaint              = seal.read(file, bytes);
            if (complaint.empty())
              log.line(last, "; the program uses the previous checkpoint");
            else
              complaint = "no valid checkpoint: " + last + "; " + complaint +
                          ". Remove --restart to start the run from the beginning";
          }
      }
    complaint = communicator.broadcast(complaint);
    if (!complaint.empty())
      throw InputError(complaint);
    // The bytes go to all ranks, each of which takes its own part later.
    Checkpoint checkpoint;
    checkpoint.file = communicator.broadcast(file);
    ByteStream stream(communicator.broadcast(bytes), data_of(checkpoint));
    serialize(stream, checkpoint);
    stream.finish();
    return checkpoint;
  }

  void serialize_model(ByteStream &stream, Model &model)
  {
    // The marks are those of the writer when reading, which are compared with the present ones;
    // when writing both are the same.
    std::size_t n    = model.bodies.size();
    bool        same = true;
    stream.pass(n);
    same = n == model.bodies.size();
    for (std::size_t b = 0; same && b < n; ++b)
      {
        // When reading, "mark" becomes what is stored; when writing it stays what is now.
        const BodyMark now(model.bodies[b]);
        BodyMark       mark = now;
        mark.serialize(stream);
        same = mark.is_same(now);
      }
    if (!same)
      throw InputError("the checkpoint belongs to another model. Use the bodies, mesh and material "
                       "of the run that wrote it");
    // Which copies the probes are depends on the length of the run, which may have changed.
    for (Probe &probe : model.probes)
      {
        stream.pass(probe.node);
        stream.require(probe.node < model.bodies[probe.body].n_nodes(),
                       "the node of a probe does not exist");
      }
  }
} // namespace vfife
