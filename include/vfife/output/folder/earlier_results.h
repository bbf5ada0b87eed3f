// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_folder_earlier_results_h
#define vfife_output_folder_earlier_results_h

#include <set>
#include <string>

namespace vfife
{
  class Communicator;

  /**
   * Results that a folder has when a study begins in it. They are put away into previous/, where
   * neither report nor Python reads them, and are brought back when the input of the new study
   * cannot be used. A user's own files stay where they are (FileList).
   *
   * previous/ has the results of one study. Those of a study that was broken off before its end and
   * its first checkpoint do not replace others in it.
   */
  class EarlierResults
  {
  public:
    EarlierResults(std::string folder, const Communicator &communicator);
    /** The study has begun, and its results stay, unless restore() was called. */
    ~EarlierResults();
    EarlierResults(const EarlierResults &)            = delete;
    EarlierResults &operator=(const EarlierResults &) = delete;

    /**
     * For a study that begins anew: moves all results but files and folders of the names @p staying
     * into previous/ and returns whether there are any. Throws on all ranks: InputError when a
     * study runs in the folder of an earlier case, std::runtime_error when the file system does not
     * move files; then all is as it was. Collective.
     */
    bool put_away(const std::set<std::string> &staying);

    /**
     * For a study that goes on: keeps copies of the text files, for restore(), and takes report and
     * pictures away, since they are of the state before. Throws std::runtime_error as put_away().
     * Collective.
     */
    void keep_copies();

    /** Brings all back as it was before put_away() or keep_copies(). Returns why it cannot, or
     * nothing; on the rank that writes. */
    std::string restore();

  private:
    void refuse_running_cases(const std::set<std::string> &staying) const;
    bool move_away(const std::set<std::string> &staying) const;
    void copy() const;
    void bring_back() const;
    void settle() const;

    std::string         folder_;
    const Communicator &communicator_;
    bool                has_begun_ = false, has_moved_ = false, has_copies_ = false;
  };
} // namespace vfife

#endif
