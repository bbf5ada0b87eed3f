// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_continuation_h
#define vfife_study_continuation_h

#include <string>
#include <vector>

namespace vfife
{
  class Communicator;
  class Log;
  struct Checkpoint;
  struct DeclaredSection;

  /** How the content of the file that an entry names differs from that with the digest
   * @p digest_before (digest_of_file()); empty where it does not, whatever the names are. */
  std::string find_other_content(const std::string &name_before,
                                 const std::string &digest_before,
                                 const std::string &name_now);

  /** Entries on which the past of a run does not depend; @p longer: among them those of its end. */
  std::vector<std::string> list_changeable(bool longer);

  /**
   * The last usable checkpoint in @p folder, of a run with the parameters @p now but for
   * @p changeable ones. Files that they name are compared by their content. An entry that either
   * has alone, since the run was begun by another version of the program, passes at its default and
   * is among the remarks. Throws InputError when there is no checkpoint, and InputErrors naming
   * every other entry that has changed, with both values. Collective.
   */
  Checkpoint find_checkpoint(const std::string              &folder,
                             const DeclaredSection          &now,
                             const std::vector<std::string> &changeable,
                             const Communicator             &communicator,
                             Log                            &log);
} // namespace vfife

#endif
