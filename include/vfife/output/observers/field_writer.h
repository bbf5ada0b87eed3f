// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_field_writer_h
#define vfife_output_observers_field_writer_h

#include <vfife/element/frame_kind.h>
#include <vfife/element/stiffness.h>
#include <vfife/model/observer.h>
#include <vfife/output/output_options.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  class OutputFolder;
  struct VtuGrid;

  /**
   * Writes fields for ParaView: fields.pvd and, in the folder "fields", one .vtu a rank and instant
   * (and a .pvtu over them on several ranks), compressed; as hdf5 instead fields.xdmf and fields.h5
   * (write_hdf5_instant()), nodes in the order of the model. The mesh is in its current place in
   * the fixed frame [mm], so that gears turn.
   *
   * Point data:
   * - displacement [mm]: R^T (x - c) - (X - c), drawn along the turned axes (R times it), R being
   * the body's own rotation about its axis, X where the undeformed node was at time zero; bodies
   * without bearings: R = 1;
   * - relative velocity [m/s]: v - omega x r, omega of the momentum; half a step before the
   * positions;
   * - von mises [MPa] and stress r, theta, z, r theta, theta z, z r [MPa] in the cylindrical axes
   * of the body (its axis of rotation, undeformed positions): element values averaged to nodes, von
   * Mises of the average;
   * - contact pressure [MPa]: nodal contact force over the node's area on the surfaces of the
   * contact pairs;
   * - body (index) and tooth (sector of the body, constant in a cell).
   */
  class FieldWriter : public Observer
  {
  public:
    /**
     * A file every @p steps_between steps (0: on request only); @p kind and @p frame as in the run,
     * for stresses. Throws InputError where a contact pair names a surface that its body has not,
     * and for hdf5 without a folder on disk. Collective.
     */
    FieldWriter(const OutputFolder &folder,
                const Model        &model,
                FieldFormat         format,
                std::uint64_t       steps_between,
                StiffnessKind       kind,
                FrameKind           frame);

    /** For write() alone. */
    FieldWriter(const OutputFolder &folder, const Model &model, FieldFormat format);

    bool        due(const State &state) const override;
    void        observe(const Model &model, const State &state) override;
    std::string part_name() const override;
    void        serialize(ByteStream &stream) override;

    /**
     * Writes a file of the state; @p stresses by node of the model in the cylindrical axes of its
     * body. Collective.
     */
    void write(const Model                              &model,
               const State                              &state,
               const std::vector<std::array<double, 6>> &stresses);

    /** Asks for a file at the next step, whatever its number. On all ranks. */
    void request();

  private:
    /** fields.pvd or fields.xdmf. */
    void write_list() const;
    /** The name in the list of the .vtu files of @p grid, this rank's part. */
    std::string write_vtu_files(const VtuGrid &grid, double time) const;
    /** Leaves of an earlier run the instants that a resumed one goes on with. Collective. */
    void resume();

    const OutputFolder &folder_;
    FieldFormat         format_;
    std::size_t         n_nodes_, n_elements_; ///< of the model
    std::uint64_t       steps_between_ = 0;
    bool                is_requested_  = false;
    StiffnessKind       kind_          = {};
    FrameKind           frame_         = {};
    std::vector<double> contact_areas_; ///< of each node of the model, 0 off the surfaces [mm^2]
    std::vector<std::pair<double, std::string>> instants_; ///< time [s] and file
  };
} // namespace vfife

#endif
