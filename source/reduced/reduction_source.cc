// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/byte_stream.h>
#include <vfife/bearing/bearing_system.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/constraints/supports.h>
#include <vfife/model/model.h>
#include <vfife/reduced/body_reduction.h>
#include <vfife/reduced/reduction_source.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Placements of one gear differ by round-off [mm, -]. */
    constexpr double axis_tolerance = 1e-9;

    /** Checksum of what @p pass puts into a stream. */
    template <typename Pass>
    std::uint32_t checksum(const Pass &pass)
    {
      ByteStream stream;
      pass(stream);
      boost::crc_32_type crc;
      crc.process_bytes(stream.bytes().data(), stream.bytes().size());
      return crc.checksum();
    }

    void pass_mesh(const Body &body, ByteStream &stream)
    {
      unsigned int         n_sectors = body.structure().n_sectors();
      std::vector<Vector3> nodes     = body.node_positions();
      auto                 elements  = body.elements();
      stream.pass(n_sectors, nodes, elements);
    }

    void pass_material(const Body &body, ByteStream &stream)
    {
      double added = body.added_mass();
      for (Material material : body.materials())
        stream.pass(material.density, material.youngs_modulus, material.poissons_ratio);
      stream.pass(added);
      for (unsigned int e = 0; body.materials().size() > 1 && e < body.n_elements(); ++e)
        {
          ElementKind kind = body.kind_of(e);
          stream.pass(kind.material);
        }
    }

    void pass_temperature(const Body &body, ByteStream &stream)
    {
      for (unsigned int e = 0; e < body.n_elements(); ++e)
        {
          ElementKind kind = body.kind_of(e);
          stream.pass(kind.initial_strain);
        }
    }

    void pass_hub(const Model &model, const unsigned int body, ByteStream &stream)
    {
      for (Constraint constraint : model.constraints)
        if (constraint.body == body)
          stream.pass(constraint.kind,
                      constraint.nodes,
                      constraint.cylindrical,
                      constraint.prescribed);
    }

    /** Rings, and the linear laws that the body's stiffness has for them; a housing joins all. */
    void pass_seats(const Model &model, const unsigned int body, ByteStream &stream)
    {
      if (!model.bodies[body].floats)
        return;
      Eigen::MatrixXd     law = make_bearing_system(model).linearized().stiffness;
      std::vector<double> numbers(law.data(), law.data() + law.size());
      stream.pass(numbers);
      for (Bearing bearing : model.bearings)
        if (bearing.body == body)
          stream.pass(bearing.name, bearing.nodes);
      for (Coupling coupling : model.couplings)
        if (coupling.body == body)
          stream.pass(coupling.name, coupling.nodes, coupling.stiffness);
      for (Transmission t : model.transmissions)
        if (body == t.driver)
          stream.pass(t.driver_bore);
    }

    void pass_torque(const Model &model, const unsigned int body, ByteStream &stream)
    {
      for (Torque torque : model.torques)
        if (torque.body == body)
          stream.pass(torque.nodes, torque.areas);
    }
  } // namespace

  ReductionSource::ReductionSource(const Model            &model,
                                   const unsigned int      b,
                                   const ReductionOptions &options)
  {
    const Body &body = model.bodies[b];
    const auto  add  = [this](const char *const name, const auto &pass) {
      parts_.emplace_back(name, checksum(pass));
    };
    add("mesh", [&](ByteStream &stream) { pass_mesh(body, stream); });
    add("material", [&](ByteStream &stream) { pass_material(body, stream); });
    // Bodies without a temperature are known by the parts that they have always had.
    if (body.has_initial_strains())
      add("temperature", [&](ByteStream &stream) { pass_temperature(body, stream); });
    add("hold of the hub", [&](ByteStream &stream) { pass_hub(model, b, stream); });
    add("place of the torque", [&](ByteStream &stream) { pass_torque(model, b, stream); });
    add("list of bearings and couplings",
        [&](ByteStream &stream) { pass_seats(model, b, stream); });
    add("kind of elements", [&](ByteStream &stream) {
      FemOptions fem = options.fem;
      stream.pass(fem.element, fem.geometry, fem.mass, fem.strain);
    });
    add("list of contact nodes", [&](ByteStream &stream) {
      std::vector<unsigned int> nodes = options.touch_nodes;
      stream.pass(nodes);
    });
    add("list of probes, waves and fillets", [&](ByteStream &stream) {
      for (SectorReading reading : options.readings)
        stream.pass(reading.name, reading.weights);
    });
    const Matrix3 back      = body.placement.rotation.transpose();
    const Vector3 direction = back * body.axis.direction;
    Vector3       point     = back * (body.axis.point - body.placement.translation);
    point -= direction.dot(point) * direction; // any point of the axis will do
    for (const Vector3 &vector : {point, direction})
      axis_.insert(axis_.end(), vector.data(), vector.data() + 3);
  }

  std::string ReductionSource::find_difference(const ReductionSource &other) const
  {
    // A part may be there on one side alone.
    const auto find_missing = [](const auto &parts, const auto &others) {
      return std::find_if(parts.begin(), parts.end(), [&](const auto &part) {
        return std::find(others.begin(), others.end(), part) == others.end();
      });
    };
    if (const auto part = find_missing(parts_, other.parts_); part != parts_.end())
      return part->first;
    if (const auto part = find_missing(other.parts_, parts_); part != other.parts_.end())
      return part->first;
    for (std::size_t i = 0; i < axis_.size(); ++i)
      if (i >= other.axis_.size() || std::abs(axis_[i] - other.axis_[i]) > axis_tolerance)
        return "axis of rotation";
    return "";
  }

  void ReductionSource::serialize(ByteStream &stream)
  {
    stream.pass(parts_, axis_);
  }
} // namespace vfife
