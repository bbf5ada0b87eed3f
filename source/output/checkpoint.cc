// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/communicator.h>
#include <vfife/base/errors.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/checkpoint.h>
#include <vfife/output/output_folder.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <fstream>

namespace vfife
{
  namespace
  {
    constexpr unsigned int format_version = 1;

    /** Writes or reads all @p parts in order. */
    template <typename Archive, typename... Parts>
    void pass(Archive &archive, Parts &...parts)
    {
      (archive & ... & parts);
    }

    /** What tells one model from another: names, counts, and sums that any change of the mesh
     * moves. */
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
      BodyMark() = default;

      bool is_same(const BodyMark &other) const
      {
        // The same computation on another machine or instruction set may round otherwise.
        const auto close = [](const double a, const double b) {
          return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
        };
        return name == other.name && n_nodes == other.n_nodes && n_elements == other.n_elements &&
               close(mass, other.mass) && close(coordinate_sum, other.coordinate_sum);
      }

      template <typename Archive>
      void serialize(Archive &archive, unsigned int)
      {
        pass(archive, name, n_nodes, n_elements, mass, coordinate_sum);
      }
    };

    struct Checkpoint
    {
      std::vector<BodyMark> bodies;
      double                time = 0, dt = 0;
      std::uint64_t         step = 0;
      EnergyLedger          energy;
      std::vector<double>   position, velocity; ///< three a node of the model
      std::vector<double>   body_motion; ///< rotation (column by column), translation of each body

      template <typename Archive>
      void serialize(Archive &archive, unsigned int)
      {
        pass(archive, bodies, time, dt, step);
        pass(archive, energy.kinetic, energy.kinetic_relative, energy.strain, energy.contact);
        pass(archive, energy.drive_work, energy.torque_work, energy.damping_loss);
        pass(archive, energy.mesh_damping_loss, energy.contact_loss, energy.start, energy.scale);
        pass(archive, position, velocity, body_motion);
      }
    };

    /** Three numbers a node of the model from the ranks' records of four: complete on every rank.
     */
    std::vector<double> gather(const Model               &model,
                               const Partition           &partition,
                               const std::vector<double> &records,
                               const Communicator        &communicator)
    {
      std::vector<double> all(3 * static_cast<std::size_t>(model.n_nodes()), 0.);
      for (std::size_t i = 0; i < partition.n_local(); ++i)
        if (partition.owned[i])
          for (unsigned int c = 0; c < 3; ++c)
            all[3 * static_cast<std::size_t>(partition.global_node[i]) + c] = records[4 * i + c];
      communicator.sum(all); // one owner a node: adding the others' zeros changes no digit
      return all;
    }

    void scatter(const std::vector<double> &all,
                 const Partition           &partition,
                 std::vector<double>       &records)
    {
      for (std::size_t i = 0; i < partition.n_local(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          records[4 * i + c] = all[3 * static_cast<std::size_t>(partition.global_node[i]) + c];
    }

    Checkpoint load(const std::string &path)
    {
      std::ifstream file(path, std::ios::binary);
      if (!file)
        throw InputError("cannot read the checkpoint \"" + path + "\"");
      Checkpoint checkpoint;
      try
        {
          boost::archive::binary_iarchive archive(file);
          std::string                     mark;
          unsigned int                    version = 0;
          pass(archive, mark, version);
          if (mark != "vfife checkpoint" || version != format_version)
            throw InputError("\"" + path + "\" is no checkpoint of this version of vfife");
          pass(archive, checkpoint);
        }
      catch (const boost::archive::archive_exception &)
        {
          throw InputError("\"" + path + "\" is no checkpoint of vfife, or is damaged");
        }
      catch (const std::length_error &) // a damaged length of a vector
        {
          throw InputError("\"" + path + "\" is no checkpoint of vfife, or is damaged");
        }
      return checkpoint;
    }
  } // namespace

  void write_checkpoint(const OutputFolder &folder, const Model &model, const State &state)
  {
    const Communicator &communicator = folder.communicator();
    Checkpoint          checkpoint;
    for (const Body &body : model.bodies)
      checkpoint.bodies.emplace_back(body);
    checkpoint.time     = state.time;
    checkpoint.dt       = state.dt;
    checkpoint.step     = state.step;
    checkpoint.energy   = state.measured.energy;
    checkpoint.position = gather(model, state.partition, state.position, communicator);
    checkpoint.velocity = gather(model, state.partition, state.velocity, communicator);
    for (const RigidMotion &motion : state.body_motion)
      {
        const auto &r = motion.rotation;
        const auto &t = motion.translation;
        checkpoint.body_motion.insert(checkpoint.body_motion.end(), r.data(), r.data() + 9);
        checkpoint.body_motion.insert(checkpoint.body_motion.end(), t.data(), t.data() + 3);
      }
    if (folder.is_writer())
      folder.write_file("checkpoint.bin", [&](std::ostream &out) {
        boost::archive::binary_oarchive archive(out);
        std::string                     mark    = "vfife checkpoint";
        unsigned int                    version = format_version;
        pass(archive, mark, version, checkpoint);
      });
  }

  void read_checkpoint(const std::string &path, const Model &model, State &state)
  {
    const Checkpoint checkpoint = load(path);
    bool             same       = checkpoint.bodies.size() == model.bodies.size();
    for (std::size_t b = 0; same && b < model.bodies.size(); ++b)
      same = checkpoint.bodies[b].is_same(BodyMark(model.bodies[b]));
    const std::size_t n = 3 * static_cast<std::size_t>(model.n_nodes());
    if (!same || checkpoint.position.size() != n || checkpoint.velocity.size() != n)
      throw InputError(
        "the checkpoint \"" + path +
        "\" is of another model: bodies, mesh and material must be those of the run that wrote it");

    state.time            = checkpoint.time;
    state.dt              = checkpoint.dt;
    state.step            = checkpoint.step;
    state.measured.energy = checkpoint.energy;
    // Never shortened: a solver may keep records of its own behind the nodes.
    const std::size_t length = 4 * state.partition.n_local();
    state.position.resize(std::max(length, state.position.size()), 0.);
    state.velocity.resize(std::max(length, state.velocity.size()), 0.);
    scatter(checkpoint.position, state.partition, state.position);
    scatter(checkpoint.velocity, state.partition, state.velocity);
    state.body_motion.resize(checkpoint.body_motion.size() / 12);
    for (std::size_t b = 0; b < state.body_motion.size(); ++b)
      {
        const double *motion             = &checkpoint.body_motion[12 * b];
        state.body_motion[b].rotation    = Eigen::Map<const Matrix3>(motion);
        state.body_motion[b].translation = Eigen::Map<const Vector3>(motion + 9);
      }
  }

  CheckpointWriter::CheckpointWriter(const OutputFolder &folder,
                                     const double        wall_time,
                                     const std::uint64_t steps_between)
    : folder_(folder)
    , wall_time_(wall_time)
    , steps_between_(steps_between)
    , last_(std::chrono::steady_clock::now())
  {
  }

  bool CheckpointWriter::due(const State &state) const
  {
    return state.step % steps_between_ == 0;
  }

  void CheckpointWriter::observe(const Model &model, const State &state)
  {
    // Clocks differ: rank 0's decides for all.
    const auto now  = std::chrono::steady_clock::now();
    double     want = 0;
    if (folder_.is_writer() && std::chrono::duration<double>(now - last_).count() >= wall_time_)
      want = 1;
    if (folder_.communicator().sum(want) == 0)
      return;
    write_checkpoint(folder_, model, state);
    last_ = std::chrono::steady_clock::now();
  }
} // namespace vfife
