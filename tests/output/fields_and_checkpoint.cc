// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Fields and checkpoints of a turning ring and a stretched block, on one rank and on two.
#include "../refusal.h"
#include "../tests.h"
#include "ring_askew.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/model/state.h>
#include <vfife/output/files/checkpoint.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/measures/body_motion.h>
#include <vfife/output/measures/node_stresses.h>
#include <vfife/output/observers/field_writer.h>
#include <vfife/output/pictures.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <filesystem>

using namespace vfife;

const std::string folder_name = "fields_results";
constexpr double  angle = 2.5, rate = 2000, strain = 1e-4;

/** A ring that turns about an axis askew, and a block that is pulled along x. */
Model make_model(const double block_size = 4)
{
  Material material;
  material.poissons_ratio = 0; // so that a pulled block has stress along x only
  return ring_and_block(material, rate, block_size);
}

/** Elements dealt to ranks in blocks; a shared node is owned by the lowest rank that holds it. */
Partition make_partition(const Model &model, const unsigned int rank, const unsigned int size)
{
  Partition                 partition;
  std::vector<unsigned int> owner(model.n_nodes(), size);
  std::vector<bool>         held(model.n_nodes(), false);
  for (const Body &body : model.bodies)
    for (unsigned int e = 0; e < body.n_elements(); ++e)
      {
        const unsigned int global = body.first_element + e;
        const unsigned int holder = global * size / model.n_elements();
        if (holder == rank)
          partition.elements.push_back(global);
        for (const std::uint32_t node : body.elements()[e])
          {
            owner[body.first_node + node] = std::min(owner[body.first_node + node], holder);
            if (holder == rank)
              held[body.first_node + node] = true;
          }
      }
  partition.local_node.assign(model.n_nodes(), Partition::absent);
  for (const Body &body : model.bodies)
    {
      partition.first_local_node.push_back(partition.n_local());
      for (unsigned int i = body.first_node; i < body.first_node + body.n_nodes(); ++i)
        if (held[i])
          {
            partition.local_node[i] = partition.n_local();
            partition.global_node.push_back(i);
            partition.owned.push_back(owner[i] == rank);
          }
    }
  partition.first_local_node.push_back(partition.n_local());
  return partition;
}

State make_state(const Model &model, const unsigned int rank, const unsigned int size)
{
  State state;
  state.partition = std::make_shared<const Partition>(make_partition(model, rank, size));
  state.position = state.velocity = state.contact_force = NodeField(state.partition->n_local());
  for (std::size_t i = 0; i < state.partition->n_local(); ++i)
    {
      const unsigned int node = state.partition->global_node[i];
      const bool         ring = node < model.bodies[1].first_node;
      const Body        &body = model.bodies[ring ? 0 : 1];
      const Vector3      X    = body.placement(body.node_positions()[node - body.first_node]);
      Vector3            x = X, v = Vector3::Zero();
      if (ring)
        {
          x = body.axis.point + rotation_about(body.axis.direction, angle) * (X - body.axis.point);
          v = rate * body.axis.direction.cross(x - body.axis.point);
        }
      else
        x[0] *= 1 + strain;
      state.position.set(i, x);
      state.velocity.set(i, v);
    }
  state.time = 1e-3;
  state.step = 100;
  state.dt   = 1e-5;
  return state;
}

void check_motion_and_stress(const Model        &model,
                             const State        &state,
                             const Communicator &communicator,
                             const bool          speaks)
{
  const auto motions  = compute_body_motions(model, state, communicator);
  const auto stresses = compute_node_stresses(
    model, state, StiffnessKind::incompatible_modes, FrameKind::polar, communicator);
  double       ring_stress = 0, block_error = 0;
  const double sigma = 206000 * strain;
  for (unsigned int i = 0; i < model.n_nodes(); ++i)
    if (i < model.bodies[1].first_node)
      raise_to(ring_stress, largest_size(stresses[i]));
    else
      {
        // The block's cylindrical axes turn with the node: the trace and z are what stays.
        const auto &s = stresses[i];
        raise_to(block_error, std::abs(s[0] + s[1] - sigma) + std::abs(s[2]));
      }
  if (!speaks)
    return;
  const Vector3 &a = model.bodies[0].axis.direction;
  check_below("rotation of the ring",
              (motions[0].rotation - rotation_about(a, angle)).norm(),
              1e-13);
  check_below("rate of the ring", (motions[0].rate - rate * a).norm() / rate, 1e-13);
  check("block is not turned",
        motions[1].rotation == Matrix3::Identity() && motions[1].rate.norm() == 0);
  // Round-off of coordinates of 30 mm in cells of about 3 mm times E: 206000 * 10 * 2e-16 times a
  // few.
  check_below("rigid turning has no stress [MPa]", ring_stress, 1e-8);
  check_below("uniform stress of the block [MPa]", block_error, 1e-8);
}

void check_fields(const Model &model, State state, const OutputFolder &folder)
{
  for (std::size_t i = 0; i < state.partition->n_local(); ++i)
    state.contact_force.set(i, Vector3::UnitX());
  FieldWriter writer(
    folder, model, FieldFormat::vtu, 50, StiffnessKind::incompatible_modes, FrameKind::polar);
  check("fields: due", writer.due(state) || !folder.is_writer());
  writer.observe(model, state);
  state.time += 1e-3;
  writer.observe(model, state);
  folder.communicator().barrier();
  if (!folder.is_writer())
    return;

  namespace pt = boost::property_tree;
  pt::ptree pvd;
  pt::read_xml(folder.file("fields.pvd"), pvd);
  unsigned int n_instants = 0, n_cells = 0, n_points = 0, n_arrays = 0;
  for (const auto &entry : pvd.get_child("VTKFile.Collection"))
    if (entry.first == "DataSet")
      {
        ++n_instants;
        check("fields: named file exists",
              std::filesystem::exists(
                folder.file(entry.second.get<std::string>("<xmlattr>.file"))));
      }
  for (const auto &file : std::filesystem::directory_iterator(folder.file("fields")))
    {
      const std::string name = file.path().filename();
      if (name.rfind("00001", 0) != 0 || file.path().extension() != ".vtu")
        continue;
      pt::ptree vtu;
      pt::read_xml(file.path(), vtu);
      const auto &piece = vtu.get_child("VTKFile.UnstructuredGrid.Piece");
      n_cells += piece.get<unsigned int>("<xmlattr>.NumberOfCells");
      n_points += piece.get<unsigned int>("<xmlattr>.NumberOfPoints");
      n_arrays = 0;
      for (const auto &array : piece.get_child("PointData"))
        n_arrays += array.first == "DataArray";
    }
  check("fields: two instants", n_instants == 2);
  check("fields: every cell once", n_cells == model.n_elements());
  // Those of a node on the border of two ranks are in both pieces.
  check("fields: cells share their points",
        folder.communicator().size() == 1
          ? n_points == model.n_nodes()
          : n_points > model.n_nodes() && n_points < 2 * model.n_nodes());
  check("fields: eleven scalars, two vectors and a tensor", n_arrays == 14);
}

void show_refusal(const std::string &path, const Communicator &communicator, Log &log)
{
  print_refusal([&] { read_checkpoint(path, communicator, log); });
}

void check_checkpoint(OutputFolder &folder)
{
  namespace fs                     = std::filesystem;
  const Communicator &communicator = folder.communicator();
  const auto          own = [](const unsigned int rank) { return "rank " + std::to_string(rank); };
  std::ostringstream  text;
  Log                 log(text, folder.is_writer());
  // The first of a run removes what an earlier one has left.
  write_checkpoint(folder, "zero", own(communicator.rank()), false);
  write_checkpoint(folder, "first", own(communicator.rank()), false);
  check("checkpoint: of another run", !fs::exists(folder.file("checkpoint.previous.bin")));
  write_checkpoint(folder, "second", own(communicator.rank()), true);
  Checkpoint last = read_checkpoint(folder.path(), communicator, log);
  bool       same = last.own.size() == communicator.size();
  for (unsigned int rank = 0; same && rank < communicator.size(); ++rank)
    same = last.own[rank] == own(rank);
  check("checkpoint: last one", last.common == "second");
  check("checkpoint: of all ranks", same);

  communicator.barrier();
  if (folder.is_writer())
    {
      std::fstream file(folder.file("checkpoint.bin"));
      file.seekp(60);
      file.put('#');
    }
  communicator.barrier();
  last = read_checkpoint(folder.path(), communicator, log);
  check("checkpoint: the one before", last.common == "first");
  std::cout << text.str();
  communicator.barrier();
  if (folder.is_writer())
    {
      fs::resize_file(folder.file("checkpoint.bin"), 20);
      std::ofstream(folder.file("checkpoint.previous.bin"))
        << "something else that is long enough to be a header";
    }
  communicator.barrier();
  show_refusal(folder.path(), communicator, log);
  show_refusal("nowhere", communicator, log);
}

void check_model_mark()
{
  Model      model = make_model();
  ByteStream written;
  model.probes.push_back({"p", 1, 7});
  serialize_model(written, model);
  model.probes[0].node = 3;
  ByteStream again(written.bytes());
  serialize_model(again, model);
  check("probes stay where they were", model.probes[0].node == 7);
  Model other = make_model(4.001);
  print_refusal([&] {
    ByteStream third(written.bytes());
    serialize_model(third, other);
  });
  // Two blocks of the same nodes but for their places: mass and sum of coordinates are equal.
  const auto block_model = [](const Vector3 &size) {
    Model of_block;
    of_block.add_body({"block", make_block(size, {{1, 1, 1}}), Material()});
    return of_block;
  };
  Model      lying = block_model(Vector3(2., 3., 4.)), standing = block_model(Vector3(3., 2., 4.));
  ByteStream first;
  serialize_model(first, lying);
  print_refusal([&] {
    ByteStream second(first.bytes());
    serialize_model(second, standing);
  });
}

/** The scripts read what the writers wrote; without numpy and matplotlib the log says so. */
void check_pictures(const OutputFolder &folder)
{
  folder.communicator().barrier(); // all pieces are written
  std::ostringstream text;
  Log                log(text, folder.is_writer());
  draw_pictures(folder, log);
  if (!folder.is_writer())
    return;
  const bool cannot = text.str().rfind("no pictures: python3", 0) == 0;
  check("one line", text.str().find('\n') == text.str().size() - 1);
  check("picture of the bodies",
        cannot || (text.str().rfind("1 picture in ", 0) == 0 &&
                   std::filesystem::file_size(folder.file("pictures/bodies.png")) > 10000));
}

int main(int argc, char **argv)
{
  MpiSession          session(argc, argv);
  const Communicator &communicator = session.world();
  if (communicator.is_root())
    std::filesystem::remove_all(folder_name);
  communicator.barrier();
  // Only one rank may write to the compared output.
  if (!communicator.is_root())
    std::cout.setstate(std::ios::failbit);

  OutputFolder folder(folder_name, communicator);
  const Model  model = make_model();
  const State  state = make_state(model, communicator.rank(), communicator.size());
  check_motion_and_stress(model, state, communicator, communicator.is_root());
  check_fields(model, state, folder);
  check_pictures(folder);
  check_checkpoint(folder);
  check_model_mark();
  return 0;
}
