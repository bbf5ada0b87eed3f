// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_reduction_store_h
#define vfife_study_reduced_reduction_store_h

#include <vfife/reduced/reduction_source.h>

#include <optional>
#include <string>

namespace vfife
{
  class Communicator;
  class Log;

  /** Reduced bodies in files of a folder, with what they were made of. All functions are
   * collective. */
  class ReductionStore
  {
  public:
    /** @p folder: without a name nothing is kept. Everything given must outlive the object. */
    ReductionStore(std::string folder, const Communicator &communicator, Log &log)
      : folder_(std::move(folder))
      , communicator_(communicator)
      , log_(log)
    {
    }

    /** The least of what a body is asked for. */
    struct Range
    {
      double       cutoff = 0; ///< [rad/s]
      double       rate   = 0; ///< the largest [rad/s]
      unsigned int reach  = 0;
    };

    /**
     * The body kept as @p name, if there is one for so much. Throws InputError where it is of
     * another source, which it names, or the file is damaged or of another version.
     */
    std::optional<ReducedBody>
    find(const std::string &name, const ReductionSource &source, const Range &range) const;

    /** Throws InputError where the folder cannot be made or written to: before a body is reduced,
     * which takes long. */
    void require_writable() const;

    /** Keeps it. Throws std::runtime_error where the disk does not take it. */
    void keep(const std::string &name, ReductionSource source, ReducedBody &body) const;

  private:
    std::string         folder_;
    const Communicator &communicator_;
    Log                &log_;
  };
} // namespace vfife

#endif
