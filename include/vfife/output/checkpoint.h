// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_checkpoint_h
#define vfife_output_checkpoint_h

#include <vfife/model/observer.h>

#include <chrono>
#include <cstdint>
#include <string>

namespace vfife
{
  class Communicator;
  class OutputFolder;

  /**
   * Writes checkpoint.bin: time, step, step size, energy ledger, motions of the bodies, and
   * positions and velocities by node of the model, so that another number of ranks can read it
   * (collective; State::measured must be of this instant for its energies). The mesh is not in it:
   * it is made again from the parameters.
   */
  void write_checkpoint(const OutputFolder &folder, const Model &model, const State &state);

  /**
   * Fills time, step, dt, positions, velocities, body motions and State::measured.energy from a
   * checkpoint file (on all ranks; the state's partition and masses must be set up). Throws
   * InputError when there is no such file or it is of another model (bodies, mesh, masses).
   */
  void read_checkpoint(const std::string &path, const Model &model, State &state);

  /** Writes a checkpoint whenever so much wall time has passed. */
  class CheckpointWriter : public Observer
  {
  public:
    /** @p wall_time > 0 [s], looked at every @p steps_between steps. */
    CheckpointWriter(const OutputFolder &folder, double wall_time, std::uint64_t steps_between);

    bool due(const State &state) const override;
    void observe(const Model &model, const State &state) override;

  private:
    const OutputFolder                   &folder_;
    double                                wall_time_;
    std::uint64_t                         steps_between_;
    std::chrono::steady_clock::time_point last_;
  };
} // namespace vfife

#endif
