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
#include <vfife/output/files/vtu_writer.h>
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
    /** What a node shows: a row for each array of list_arrays(). */
    struct NodeValues
    {
      Vector3 displacement, velocity;
      Stress  cylindrical, fixed;
      double  pressure = 0;
    };

    /** The arrays of a field file, without values. */
    VtuGrid make_grid()
    {
      VtuGrid grid;
      grid.point_data = {{"displacement", "mm", 3}, {"relative velocity", "m/s", 3}};
      for (const VtuArray &array : make_stress_arrays())
        grid.point_data.push_back(array);
      grid.point_data.push_back({"contact pressure", "MPa"});
      grid.cell_data = {{"body", ""}, {"tooth", ""}};
      return grid;
    }

    /** Appends what a node shows, in the order of make_grid(). */
    void add_values(const NodeValues &values, std::vector<VtuArray> &arrays)
    {
      auto       array = arrays.begin();
      const auto add   = [&array](const auto &numbers) {
        for (Eigen::Index i = 0; i < numbers.size(); ++i)
          array->values.push_back(static_cast<float>(numbers[i]));
        ++array;
      };
      add(values.displacement);
      add(values.velocity);
      array = add_stress(values.cylindrical, values.fixed, array);
      array->values.push_back(static_cast<float>(values.pressure));
    }

    NodeValues compute_node_values(const Body                  &body,
                                   const BodyMotion            &motion,
                                   const unsigned int           node,
                                   const Vector3               &x,
                                   const Vector3               &v,
                                   const std::array<double, 6> &node_stress)
    {
      NodeValues    values;
      const Vector3 now = x - body.axis.point;
      // Drawn along the turned axes, R times what is left in the body: the mesh is shown
      // where it is now.
      values.displacement = motion.rotation * compute_displacement(body, node, x, motion.rotation);
      // v - omega x (x - c): what is left when the body's turning is taken out.
      values.velocity    = 1e-3 * (v - motion.rate.cross(now)); // mm/s to m/s
      values.cylindrical = Eigen::Map<const Stress>(node_stress.data());
      // The axes r, theta, z where they are now, as columns.
      const Matrix3 axes = motion.rotation * body.placement.rotation *
                           compute_cylindrical_axes(body, body.node_positions()[node]);
      values.fixed = turn_stress(values.cylindrical, axes.transpose());
      return values;
    }

    /**
     * This rank's elements, which share their points, with what nodes show; @p stresses and @p
     * contact_areas are those of the model's nodes.
     */
    VtuGrid fill_grid(const Model                              &model,
                      const State                              &state,
                      const std::vector<BodyMotion>            &motions,
                      const std::vector<std::array<double, 6>> &stresses,
                      const std::vector<double>                &contact_areas)
    {
      const Partition           &partition = *state.partition;
      VtuGrid                    grid      = make_grid();
      constexpr std::uint32_t    none      = -1;
      std::vector<std::uint32_t> point_of(partition.n_local(), none);
      std::uint32_t              n_points = 0;
      std::size_t                b        = 0;
      const auto add_node = [&](const std::uint32_t global, const std::uint32_t local) {
        grid.add_point(state.node_position(local));
        NodeValues values = compute_node_values(model.bodies[b],
                                                motions[b],
                                                global - model.bodies[b].first_node,
                                                state.node_position(local),
                                                state.node_velocity(local),
                                                stresses[global]);
        // The nodal force over the node's area: a mean pressure, without regard to the normal.
        if (contact_areas[global] > 0 && !state.contact_force.empty())
          values.pressure = state.contact_force.value(local).norm() / contact_areas[global];
        add_values(values, grid.point_data);
        point_of[local] = n_points++;
      };
      for (const std::uint32_t number : partition.elements)
        {
          while (number >= model.bodies[b].first_element + model.bodies[b].n_elements())
            ++b;
          const Body        &body    = model.bodies[b];
          const unsigned int element = number - body.first_element;
          CellNodes          cell;
          for (unsigned int i = 0; i < 8; ++i)
            {
              const std::uint32_t global = body.first_node + body.elements()[element][i],
                                  local  = partition.local_node[global];
              if (point_of[local] == none)
                add_node(global, local);
              cell[i] = point_of[local];
            }
          grid.cells.push_back(cell);
          grid.cell_data[0].values.push_back(static_cast<float>(b));
          grid.cell_data[1].values.push_back(
            static_cast<float>(body.structure().sector_of_element(element)));
        }
      return grid;
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
        const auto  node_areas = compute_nodal_areas(body, nodes, faces_of(surface->second));
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

  FieldWriter::FieldWriter(const OutputFolder &folder, const Model &model)
    : folder_(folder)
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
    write(model, state, compute_node_stresses(model, state, kind_, frame_, folder_.communicator()));
  }

  void FieldWriter::write(const Model                              &model,
                          const State                              &state,
                          const std::vector<std::array<double, 6>> &stresses)
  {
    if (instants_.empty())
      folder_.make_subfolder("fields");
    // What all ranks find together, then this rank's part of the mesh.
    const Communicator &communicator = folder_.communicator();
    const auto          motions      = compute_body_motions(model, state, communicator);
    const VtuGrid       grid         = fill_grid(model, state, motions, stresses, contact_areas_);

    // One rank: 00003.vtu. Several: a piece a rank, 00003.0.vtu..., and 00003.pvtu over them.
    std::ostringstream instant;
    instant << std::setw(5) << std::setfill('0') << instants_.size();
    const auto piece = [&](const unsigned int rank) {
      return instant.str() + (communicator.size() > 1 ? "." + std::to_string(rank) : "") + ".vtu";
    };

    // Every rank writes its own piece; the first joins them by a .pvtu and lists the
    // instant in fields.pvd.
    folder_.write_file("fields/" + piece(communicator.rank()),
                       [&](std::ostream &out) { write_vtu(out, grid, state.time); });
    std::string file = piece(0);
    if (communicator.size() > 1)
      {
        file = instant.str() + ".pvtu";
        if (folder_.is_writer())
          folder_.write_file("fields/" + file, [&](std::ostream &out) {
            std::vector<std::string> pieces;
            for (unsigned int r = 0; r < communicator.size(); ++r)
              pieces.push_back(piece(r));
            write_pvtu(out, grid, pieces);
          });
      }
    instants_.emplace_back(state.time, "fields/" + file);
    write_pvd();
  }
} // namespace vfife
