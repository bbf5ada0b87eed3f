// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_folder_folder_lock_h
#define vfife_output_folder_folder_lock_h

#include <string>
#include <vector>

namespace vfife
{
  class Communicator;
  class Log;

  /**
   * One study at a time in a folder of results. As long as the object lives no other one gets the
   * lock of the same folder, whatever path leads there. The operating system drops the lock when
   * the process ends in any way. The file vfife.lock in the folder names host, process, start and
   * parameter file of the holder. Rank 0 holds the lock.
   */
  class FolderLock
  {
  public:
    /**
     * Makes the folder where it is missing and locks it (collective). @p study is what others read
     * of the holder: its parameter file. Throws InputError on all ranks when another study has the
     * lock; then nothing has been changed. A file system without locks is said in a warning. A
     * folder that cannot be made, or is a file, is left to OutputFolder, which says why.
     */
    FolderLock(const std::string  &folder,
               const std::string  &study,
               const Communicator &communicator,
               Log                &log);
    /** Removes the file, and folders that the constructor has made if they are empty. */
    ~FolderLock();
    FolderLock(const FolderLock &)            = delete;
    FolderLock &operator=(const FolderLock &) = delete;

  private:
    void make_folder(const std::string &folder);

    std::string              path_; ///< of the file
    int                      descriptor_ = -1;
    std::vector<std::string> made_; ///< folders, the outermost first
  };

  /** Whether another process, or another part of this one, has the lock of a folder. For one rank.
   */
  bool is_in_use(const std::string &folder);
} // namespace vfife

#endif
