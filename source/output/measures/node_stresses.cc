// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/element/stress.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/measures/node_stresses.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace vfife
{
  namespace
  {
    /** Six sums of stresses and the number of elements in them. */
    constexpr unsigned int n_records = 7;

    /** Whether the nodes of an element are where @p expected says, to round-off. */
    bool agrees(const HexahedronNodes &expected, const HexahedronNodes &X)
    {
      constexpr double tolerance = 1e-10;
      return (expected - X).cwiseAbs().maxCoeff() <= tolerance * (X.col(7) - X.col(0)).norm();
    }

    /**
     * Adds the nodal stresses [MPa] of @p elements of the body, in the axes of the body frame, to
     * the records of their nodes.
     */
    void add_body_stresses(const Body               &body,
                           std::vector<unsigned int> elements,
                           const State              &state,
                           const StiffnessKind       kind,
                           const FrameKind           frame,
                           std::vector<double>      &records)
    {
      // The same element of all sectors one after the other: they are turned copies, and what their
      // undeformed shape tells is found once.
      const BodyStructure &structure = body.structure();
      std::sort(elements.begin(), elements.end(), [&](const unsigned int a, const unsigned int b) {
        return std::make_pair(structure.first_copy_of_element(a), a) <
               std::make_pair(structure.first_copy_of_element(b), b);
      });
      std::vector<Matrix3> turns;
      for (unsigned int k = 0; k < structure.n_sectors(); ++k)
        turns.push_back(rotation_about(Vector3::UnitZ(), structure.angle(k)));

      std::optional<StressRecovery> recovery; // of the element that is `first` of the copies
      HexahedronNodes               first_X;
      unsigned int                  first = 0;
      for (const unsigned int element : elements)
        {
          const HexahedronNodes X = body.stress_free_nodes(element);
          bool                  is_copy =
            recovery &&
            structure.first_copy_of_element(element) == structure.first_copy_of_element(first) &&
            &body.material(element) == &body.material(first);
          const Matrix3 turn = turns[is_copy ? structure.sector_of_element(element) -
                                                 structure.sector_of_element(first)
                                             : 0];
          is_copy            = is_copy && agrees(turn * first_X, X);
          if (!is_copy)
            {
              recovery.emplace(X, body.material(element), kind, frame);
              first_X = X;
              first   = element;
            }
          // In the axes of the first copy, of which the body's are turned back.
          const Matrix3   axes  = is_copy ? Matrix3(turn.transpose()) : turns[0];
          const auto     &nodes = body.elements()[element];
          HexahedronNodes x;
          for (unsigned int i = 0; i < 8; ++i)
            x.col(i) = state.node_position(state.partition->local_node[body.first_node + nodes[i]]);
          const Eigen::Matrix<double, 6, 8> stresses = recovery->compute(x);
          for (unsigned int i = 0; i < 8; ++i)
            {
              double *record = &records[n_records * (body.first_node + nodes[i])];
              Eigen::Map<Stress>{record} += turn_stress(stresses.col(i), axes);
              record[6] += 1;
            }
        }
    }
  } // namespace

  std::vector<std::array<double, 6>> compute_node_stresses(const Model        &model,
                                                           const State        &state,
                                                           const StiffnessKind kind,
                                                           const FrameKind     frame,
                                                           const Communicator &communicator)
  {
    std::vector<double> records(n_records * static_cast<std::size_t>(model.n_nodes()), 0.);
    // The partition's elements ascend, and so do their bodies.
    auto next = state.partition->elements.begin();
    for (const Body &body : model.bodies)
      {
        std::vector<unsigned int> elements;
        for (; next != state.partition->elements.end() &&
               *next < body.first_element + body.n_elements();
             ++next)
          elements.push_back(*next - body.first_element);
        add_body_stresses(body, std::move(elements), state, kind, frame, records);
      }
    // Nodes between ranks have elements on several of them: sums and counts first, means then.
    communicator.sum(records);

    std::vector<std::array<double, 6>> averages(model.n_nodes());
    for (const Body &body : model.bodies)
      for (unsigned int i = 0; i < body.n_nodes(); ++i)
        {
          const double *record = &records[n_records * (body.first_node + i)];
          if (record[6] == 0)
            continue;
          // Averaged along the axes of the body frame, then turned once for each node.
          const Stress turned =
            turn_stress(Eigen::Map<const Stress>(record) / record[6],
                        compute_cylindrical_axes(body, body.node_positions()[i]));
          for (unsigned int c = 0; c < 6; ++c)
            averages[body.first_node + i][c] = turned[c];
        }
    return averages;
  }
} // namespace vfife
