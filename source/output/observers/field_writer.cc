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
#include <vfife/output/formats/hdf5_fields.h>
#include <vfife/output/formats/vtu_writer.h>
#include <vfife/output/measures/body_motion.h>
#include <vfife/output/measures/node_stresses.h>
#include <vfife/output/observers/field_writer.h>

#include <deal.II/base/data_out_base.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <sstream>

namespace vfife
{
  namespace
  {
    constexpr char hdf5_name[] = "fields.h5";

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

    /** A rank's elements, and the model's numbers of their nodes in the order of the points. */
    struct GridPart
    {
      VtuGrid                    grid = make_grid();
      std::vector<std::uint32_t> nodes;
    };

    /**
     * This rank's elements, which share their points, with what nodes show; @p stresses and @p
     * contact_areas are those of the model's nodes.
     */
    GridPart fill_part(const Model                              &model,
                       const State                              &state,
                       const std::vector<BodyMotion>            &motions,
                       const std::vector<std::array<double, 6>> &stresses,
                       const std::vector<double>                &contact_areas)
    {
      const Partition           &partition = *state.partition;
      GridPart                   part;
      VtuGrid                   &grid = part.grid;
      constexpr std::uint32_t    none = -1;
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
        part.nodes.push_back(global);
        point_of[local] = n_points++;
      };
      for (const std::uint32_t number : partition.elements)
        {
          while (number >= model.bodies[b].first_element + model.bodies[b].n_elements())
            ++b;
          const Body        &body    = model.bodies[b];
          const unsigned int element = number - body.first_element;
          for (unsigned int i = 0; i < 8; ++i)
            {
              const std::uint32_t global = body.first_node + body.elements()[element][i],
                                  local  = partition.local_node[global];
              if (point_of[local] == none)
                add_node(global, local);
              grid.cells.push_back(point_of[local]);
            }
          grid.cell_data[0].values.push_back(static_cast<float>(b));
          grid.cell_data[1].values.push_back(
            static_cast<float>(body.structure().sector_of_element(element)));
        }
      return part;
    }

    /** Values of all ranks, @p n_components at each of their @p places. Collective. */
    template <typename Number>
    std::vector<Number> gather(const std::vector<Number>        &values,
                               const unsigned int                n_components,
                               const std::vector<std::uint32_t> &places,
                               const Communicator               &communicator)
    {
      const std::vector<Number> all = communicator.all_gather(values);
      std::vector<Number>       placed(all.size());
      std::uint32_t             n_places = 0;
      for (std::size_t i = 0; i < places.size(); ++i)
        {
          std::copy_n(&all[n_components * i], n_components, &placed[n_components * places[i]]);
          n_places = std::max(n_places, places[i] + 1);
        }
      placed.resize(n_components * std::size_t(n_places));
      return placed;
    }

    /** The parts of all ranks as one: points and cells are nodes and elements of the model, however
     * many ranks there are. Collective. */
    VtuGrid join_parts(const GridPart                   &part,
                       const std::vector<std::uint32_t> &elements,
                       const Communicator               &communicator)
    {
      const auto nodes = communicator.all_gather(part.nodes),
                 cells = communicator.all_gather(elements);
      VtuGrid grid     = make_grid();
      grid.points      = gather(part.grid.points, 3, nodes, communicator);
      for (std::size_t i = 0; i < grid.point_data.size(); ++i)
        grid.point_data[i].values = gather(part.grid.point_data[i].values,
                                           grid.point_data[i].n_components,
                                           nodes,
                                           communicator);
      for (std::size_t i = 0; i < grid.cell_data.size(); ++i)
        grid.cell_data[i].values = gather(part.grid.cell_data[i].values, 1, cells, communicator);
      std::vector<unsigned int> corners = part.grid.cells;
      for (unsigned int &corner : corners)
        corner = part.nodes[corner];
      grid.cells = gather(corners, grid.points_per_cell(), cells, communicator);
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
                           const FieldFormat   format,
                           const std::uint64_t steps_between,
                           const StiffnessKind kind,
                           const FrameKind     frame)
    : FieldWriter(folder, model, format)
  {
    steps_between_ = steps_between;
    kind_          = kind;
    frame_         = frame;
  }

  FieldWriter::FieldWriter(const OutputFolder &folder, const Model &model, const FieldFormat format)
    : folder_(folder)
    , format_(format)
    , n_nodes_(model.n_nodes())
    , n_elements_(model.n_elements())
    , contact_areas_(compute_contact_areas(model))
  {
    if (format == FieldFormat::hdf5 && !folder.is_on_disk())
      throw InputError("Output/field format",
                       "expected vtu for a study in memory, got hdf5. Set vtu");
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
    if (stream.reads())
      resume();
  }

  void FieldWriter::resume()
  {
    // Those of the other format stay as they are.
    instants_.erase(std::remove_if(instants_.begin(),
                                   instants_.end(),
                                   [this](const auto &instant) {
                                     return (instant.second == hdf5_name) !=
                                            (format_ == FieldFormat::hdf5);
                                   }),
                    instants_.end());
    if (format_ == FieldFormat::hdf5)
      {
        // The file may have been removed: then a new one begins.
        const bool is_gone =
          folder_.is_writer() && !std::filesystem::exists(folder_.file(hdf5_name));
        if (folder_.communicator().any(is_gone))
          instants_.clear();
        else if (folder_.is_writer() && !instants_.empty())
          remove_hdf5_instants(folder_.file(hdf5_name), instants_.size());
      }
    if (instants_.empty())
      return;
    if (format_ == FieldFormat::vtu)
      folder_.make_subfolder("fields"); // it may have been removed
    write_list();
  }

  void FieldWriter::write_list() const
  {
    if (!folder_.is_writer())
      return;
    switch (format_)
      {
      case FieldFormat::vtu:
        return folder_.write_file("fields.pvd", [&](std::ostream &out) {
          dealii::DataOutBase::write_pvd_record(out, instants_);
        });
      case FieldFormat::hdf5:
        std::vector<double> times;
        for (const auto &instant : instants_)
          times.push_back(instant.first);
        return folder_.write_file("fields.xdmf", [&](std::ostream &out) {
          out.precision(12);
          write_xdmf(out, hdf5_name, make_grid(), n_nodes_, n_elements_, times);
        });
      }
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
    // What all ranks find together, then this rank's part of the mesh.
    const Communicator &communicator = folder_.communicator();
    const auto          motions      = compute_body_motions(model, state, communicator);
    const GridPart      part         = fill_part(model, state, motions, stresses, contact_areas_);
    switch (format_)
      {
      case FieldFormat::vtu:
        instants_.emplace_back(state.time, write_vtu_files(part.grid, state.time));
        break;
      case FieldFormat::hdf5:
        const VtuGrid grid = join_parts(part, state.partition->elements, communicator);
        if (folder_.is_writer())
          {
            folder_.list_file(hdf5_name);
            write_hdf5_instant(folder_.file(hdf5_name), grid, instants_.size(), state.time);
          }
        instants_.emplace_back(state.time, hdf5_name);
        break;
      }
    write_list();
  }

  std::string FieldWriter::write_vtu_files(const VtuGrid &grid, const double time) const
  {
    if (instants_.empty())
      folder_.make_subfolder("fields");
    const Communicator &communicator = folder_.communicator();
    // One rank: 00003.vtu. Several: a piece a rank, 00003.0.vtu..., and 00003.pvtu over them.
    std::ostringstream instant;
    instant << std::setw(5) << std::setfill('0') << instants_.size();
    const auto piece = [&](const unsigned int rank) {
      return instant.str() + (communicator.size() > 1 ? "." + std::to_string(rank) : "") + ".vtu";
    };

    // Every rank writes its own piece; the first joins them by a .pvtu and lists the
    // instant in fields.pvd.
    folder_.write_file("fields/" + piece(communicator.rank()),
                       [&](std::ostream &out) { write_vtu(out, grid, time); });
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
    return "fields/" + file;
  }
} // namespace vfife
