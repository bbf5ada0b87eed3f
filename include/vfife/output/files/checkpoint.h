// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_files_checkpoint_h
#define vfife_output_files_checkpoint_h

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  class ByteStream;
  class Communicator;
  class Log;
  class OutputFolder;
  struct Model;

  /** What a run needs to go on. */
  struct Checkpoint
  {
    std::string                                      file;       ///< read from; not stored
    std::string                                      version;    ///< of the program that wrote it
    std::vector<std::pair<std::string, std::string>> parameters; ///< in force, by path of the entry
    std::vector<std::string> remarks;        ///< of who read it, for the log; not stored
    std::vector<std::string> set_parameters; ///< paths of those that are not at their defaults
    std::vector<std::pair<std::string, std::string>> input_digests; ///< of files, by entry
    std::size_t                                      log_size = 0;  ///< bytes of run.log by then
    std::string                                      common;        ///< for any number of ranks
    std::vector<std::string>                         own;           ///< of each rank
  };

  /**
   * Writes checkpoint.bin beside the one before, which becomes checkpoint.previous.bin (without
   * @p keeps_previous it is removed: that of an earlier run). @p common must be equal on all ranks.
   * Collective; throws std::runtime_error on the writing rank when the disk does not take it.
   */
  void write_checkpoint(const OutputFolder &folder,
                        const std::string  &common,
                        const std::string  &own,
                        bool                keeps_previous);

  /** Checkpoint::version of what this program writes. */
  std::string present_version();

  /** What messages call the data of a checkpoint. */
  std::string data_of(const Checkpoint &checkpoint);

  /**
   * The last checkpoint in @p folder; the one before where the last is missing or damaged, with a
   * line of @p log. Throws InputError on all ranks when there is none that can be used. Collective.
   */
  Checkpoint read_checkpoint(const std::string &folder, const Communicator &communicator, Log &log);

  /**
   * Passes what tells @p model from another one, and its probes, which stay where they were
   * although the run may get longer. Throws InputError when reading of other bodies, meshes or
   * masses: the mesh is not stored but made again from the parameters.
   */
  void serialize_model(ByteStream &stream, Model &model);
} // namespace vfife

#endif
