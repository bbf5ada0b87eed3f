// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_continuation_h
#define vfife_study_continuation_h

#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  class Communicator;
  class Log;
  struct Checkpoint;

  /** Entries by path ("A/B/name") with their values as texts. */
  using EntryValues = std::vector<std::pair<std::string, std::string>>;

  /**
   * Throws InputErrors naming every entry whose value differs from the one the run was begun with,
   * with both values, but for those that are @p changeable.
   */
  void refuse_changes(const EntryValues              &before,
                      const EntryValues              &now,
                      const std::vector<std::string> &changeable = {});

  /** The last usable checkpoint in @p folder, of a run with the parameters @p now but for
   * @p changeable ones. Throws InputError when there is none or other parameters have changed.
   * Collective. */
  Checkpoint find_checkpoint(const std::string              &folder,
                             const EntryValues              &now,
                             const std::vector<std::string> &changeable,
                             const Communicator             &communicator,
                             Log                            &log);
} // namespace vfife

#endif
