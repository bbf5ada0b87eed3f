// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/element/stress.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/measures/body_motion.h>
#include <vfife/output/measures/node_stresses.h>
#include <vfife/output/observers/field_writer.h>

#include <deal.II/base/data_out_base.h>

#include <fstream>
#include <iomanip>
#include <sstream>

namespace vfife
{
  namespace
  {
    using Patch     = dealii::DataOutBase::Patch<3, 3>;
    using VectorRow = std::tuple<unsigned int,
                                 unsigned int,
                                 std::string,
                                 dealii::DataComponentInterpretation::DataComponentInterpretation>;

    /** Rows of the data of a patch. */
    enum Row
    {
      displacement = 0,
      velocity     = 3,
      stress       = 6,
      equivalent   = 12,
      pressure     = 13,
      body_index   = 14,
      tooth        = 15,
      n_rows       = 16
    };

    /** In the order of Row; components of a vector share its name. */
    const std::vector<std::string> &row_names()
    {
      static const std::vector<std::string> names = {"displacement",
                                                     "displacement",
                                                     "displacement",
                                                     "relative velocity",
                                                     "relative velocity",
                                                     "relative velocity",
                                                     "stress r",
                                                     "stress theta",
                                                     "stress z",
                                                     "stress r theta",
                                                     "stress theta z",
                                                     "stress z r",
                                                     "von mises",
                                                     "contact pressure",
                                                     "body",
                                                     "tooth"};
      return names;
    }

    const std::vector<VectorRow> &vector_rows()
    {
      constexpr auto vector = dealii::DataComponentInterpretation::component_is_part_of_vector;
      static const std::vector<VectorRow> ranges = {
        VectorRow(displacement, displacement + 2, "displacement", vector),
        VectorRow(velocity, velocity + 2, "relative velocity", vector)};
      return ranges;
    }

    dealii::DataOutBase::VtkFlags make_flags(const State &state)
    {
      dealii::DataOutBase::VtkFlags flags(state.time,
                                          static_cast<unsigned int>(state.step),
                                          false,
                                          dealii::DataOutBase::VtkFlags::best_speed);
      flags.physical_units["displacement"]      = "mm";
      flags.physical_units["relative velocity"] = "m/s";
      for (unsigned int row = stress; row <= pressure; ++row)
        flags.physical_units[row_names()[row]] = "MPa";
      return flags;
    }

    /** What is drawn at one node: the rows up to the pressure. */
    using NodeRecord = std::array<float, body_index>;

    NodeRecord compute_node_record(const Body                  &body,
                                   const BodyMotion            &motion,
                                   const unsigned int           node,
                                   const Vector3               &x,
                                   const Vector3               &v,
                                   const std::array<double, 6> &node_stress)
    {
      // Drawn along the turned axes, R times what is left in the body: the mesh is shown
      // where it is now.
      NodeRecord    record;
      const Vector3 now = x - body.axis.point;
      const Vector3 u   = motion.rotation * compute_displacement(body, node, x, motion.rotation);
      // v - omega x (x - c): what is left when the body's turning is taken out.
      const Vector3 w = 1e-3 * (v - motion.rate.cross(now)); // mm/s to m/s
      for (unsigned int c = 0; c < 3; ++c)
        {
          record[displacement + c] = static_cast<float>(u[c]);
          record[velocity + c]     = static_cast<float>(w[c]);
        }
      for (unsigned int c = 0; c < 6; ++c)
        record[stress + c] = static_cast<float>(node_stress[c]);
      record[equivalent] =
        static_cast<float>(von_mises(Eigen::Map<const Stress>(node_stress.data())));
      record[pressure] = 0;
      return record;
    }

    /** Of all local nodes; @p stresses and @p contact_areas are those of the model's nodes. */
    std::vector<NodeRecord> compute_node_records(const Model                              &model,
                                                 const State                              &state,
                                                 const std::vector<BodyMotion>            &motions,
                                                 const std::vector<std::array<double, 6>> &stresses,
                                                 const std::vector<double> &contact_areas)
    {
      const Partition        &partition = *state.partition;
      std::vector<NodeRecord> records(partition.n_local());
      for (std::size_t b = 0; b < model.bodies.size(); ++b)
        for (const std::uint32_t i : partition.nodes(b))
          {
            const std::uint32_t node = partition.global_node[i];
            records[i]               = compute_node_record(model.bodies[b],
                                             motions[b],
                                             node - model.bodies[b].first_node,
                                             state.node_position(i),
                                             state.node_velocity(i),
                                             stresses[node]);
            // The nodal force over the node's area: a mean pressure, without regard to the normal.
            if (contact_areas[node] > 0 && !state.contact_force.empty())
              records[i][pressure] =
                static_cast<float>(state.contact_force.value(i).norm() / contact_areas[node]);
          }
      return records;
    }

    /** This rank's elements with their fields. */
    std::vector<Patch>
    make_patches(const Model &model, const State &state, const std::vector<NodeRecord> &records)
    {
      const Partition   &partition = *state.partition;
      std::vector<Patch> patches(partition.elements.size());
      std::size_t        b = 0;
      for (std::size_t p = 0; p < patches.size(); ++p)
        {
          while (partition.elements[p] >=
                 model.bodies[b].first_element + model.bodies[b].n_elements())
            ++b;
          const Body        &body    = model.bodies[b];
          const unsigned int element = partition.elements[p] - body.first_element;
          const auto        &sector  = body.mesh().sector;
          // A patch is one element with its eight corners, in deal.II's order as the body's
          // elements have them.
          Patch &patch         = patches[p];
          patch.patch_index    = p;
          patch.reference_cell = dealii::ReferenceCells::Hexahedron;
          patch.data.reinit(n_rows, 8);
          // Corners where they are now, with what their nodes show.
          for (unsigned int i = 0; i < 8; ++i)
            {
              const std::uint32_t local =
                partition.local_node[body.first_node + body.elements()[element][i]];
              const Vector3 x = state.node_position(local);
              for (unsigned int c = 0; c < 3; ++c)
                patch.vertices[i][c] = x[c];
              for (unsigned int row = 0; row < body_index; ++row)
                patch.data(row, i) = records[local][row];
              patch.data(body_index, i) = static_cast<float>(b);
              patch.data(tooth, i) = sector.empty() ? 0.F : static_cast<float>(sector[element]);
            }
        }
      return patches;
    }

    /** By node of the model, zero off the surfaces of contact pairs [mm^2]. */
    std::vector<double> compute_contact_areas(const Model &model)
    {
      std::vector<double> areas(model.n_nodes(), 0.);
      // Areas by node of the model; a node of two surfaces has that of the last one.
      const auto add_surface = [&](const unsigned int b, const std::string &name) {
        const Body &body    = model.bodies[b];
        const auto  surface = body.mesh().surfaces.find(name);
        if (surface == body.mesh().surfaces.end())
          throw InputError("body \"" + body.name() + "\" has no surface \"" + name + "\"");
        const auto &nodes      = surface->second.nodes;
        const auto  node_areas = compute_nodal_areas(body, nodes);
        for (std::size_t i = 0; i < nodes.size(); ++i)
          areas[body.first_node + nodes[i]] = node_areas[i];
      };
      for (const ContactPair &pair : model.contacts)
        {
          add_surface(pair.slave_body, pair.slave_surface);
          add_surface(pair.master_body, pair.master_surface);
        }
      return areas;
    }
  } // namespace

  FieldWriter::FieldWriter(const OutputFolder &folder,
                           const Model        &model,
                           const std::uint64_t steps_between,
                           const StiffnessKind kind,
                           const FrameKind     frame)
    : folder_(folder)
    , steps_between_(steps_between)
    , kind_(kind)
    , frame_(frame)
    , contact_areas_(compute_contact_areas(model))
  {
  }

  bool FieldWriter::due(const State &state) const
  {
    // A signal asks for a field file besides those that are due.
    return is_requested_ || (steps_between_ > 0 && state.step % steps_between_ == 0);
  }

  void FieldWriter::request()
  {
    is_requested_ = true;
  }

  std::string FieldWriter::part_name() const
  {
    return "fields";
  }

  void FieldWriter::serialize(ByteStream &stream)
  {
    // A resumed run goes on with the numbering, and its list names no file written after
    // the checkpoint.
    stream.pass(instants_);
    if (stream.reads() && !instants_.empty())
      {
        folder_.make_subfolder("fields"); // it may have been removed
        write_pvd();
      }
  }

  void FieldWriter::write_pvd() const
  {
    if (folder_.is_writer())
      folder_.write_file("fields.pvd", [&](std::ostream &out) {
        dealii::DataOutBase::write_pvd_record(out, instants_);
      });
  }

  void FieldWriter::observe(const Model &model, const State &state)
  {
    // The last state of a run is shown in any case.
    if (steps_between_ == 0 && !is_requested_)
      return;
    is_requested_ = false;
    if (instants_.empty())
      folder_.make_subfolder("fields");
    // What all ranks find together, then this rank's part of the mesh.
    const Communicator &communicator = folder_.communicator();
    const auto          motions      = compute_body_motions(model, state, communicator);
    const auto          stresses = compute_node_stresses(model, state, kind_, frame_, communicator);
    const auto records = compute_node_records(model, state, motions, stresses, contact_areas_);
    const auto patches = make_patches(model, state, records);
    const auto flags   = make_flags(state);

    // One rank: 00003.vtu. Several: a piece a rank, 00003.0.vtu..., and 00003.pvtu over them.
    std::ostringstream instant;
    instant << std::setw(5) << std::setfill('0') << instants_.size();
    const auto piece = [&](const unsigned int rank) {
      return instant.str() + (communicator.size() > 1 ? "." + std::to_string(rank) : "") + ".vtu";
    };

    // Every rank writes its own piece; the first joins them by a .pvtu and lists the
    // instant in fields.pvd.
    folder_.write_file("fields/" + piece(communicator.rank()), [&](std::ostream &out) {
      dealii::DataOutBase::write_vtu(patches, row_names(), vector_rows(), flags, out);
    });
    std::string file = piece(0);
    if (communicator.size() > 1)
      {
        file = instant.str() + ".pvtu";
        if (folder_.is_writer())
          folder_.write_file("fields/" + file, [&](std::ostream &out) {
            std::vector<std::string> pieces;
            for (unsigned int r = 0; r < communicator.size(); ++r)
              pieces.push_back(piece(r));
            dealii::DataOutBase::write_pvtu_record(out, pieces, row_names(), vector_rows(), flags);
          });
      }
    instants_.emplace_back(state.time, "fields/" + file);
    write_pvd();
  }
} // namespace vfife
