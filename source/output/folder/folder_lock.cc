// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/output/folder/folder_lock.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vfife
{
  namespace
  {
    namespace fs = std::filesystem;

    const char lock_name[] = "vfife.lock";

    /** What has become of an attempt to get the lock. */
    struct Attempt
    {
      int         descriptor = -1;    ///< of the open file, with the lock or without any
      bool        is_refused = false; ///< another process has the lock
      int         error      = 0;     ///< of a file system that has no locks
      std::string holder;             ///< what the file says
    };

    std::string read_line(const int descriptor)
    {
      std::array<char, 4096> text;
      const ssize_t          n = pread(descriptor, text.data(), text.size(), 0);
      const std::string      all(text.data(), n > 0 ? n : 0);
      return all.substr(0, all.find('\n'));
    }

    /** Whether the open file is that of the path. */
    bool is_same_file(const int descriptor, const std::string &path)
    {
      struct stat own, there;
      return fstat(descriptor, &own) == 0 && stat(path.c_str(), &there) == 0 &&
             own.st_dev == there.st_dev && own.st_ino == there.st_ino;
    }

    Attempt try_to_lock(const std::string &path)
    {
      for (;;)
        {
          Attempt attempt;
          // Programs that this one starts, as that of the report, do not inherit the lock.
          attempt.descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
          if (attempt.descriptor < 0)
            return attempt;
          attempt.holder = read_line(attempt.descriptor);
          if (flock(attempt.descriptor, LOCK_EX | LOCK_NB) != 0)
            {
              attempt.is_refused = errno == EWOULDBLOCK;
              attempt.error      = attempt.is_refused ? 0 : errno;
            }
          // The holder removes the file at its end: what was opened just before that is no lock of
          // the folder any more.
          else if (!is_same_file(attempt.descriptor, path))
            {
              close(attempt.descriptor);
              continue;
            }
          if (attempt.is_refused)
            close(attempt.descriptor);
          return attempt;
        }
    }

    /** "process 4242 on HOST since 2026-11-26 13:45:10, STUDY" */
    std::string describe_this_process(const std::string &study)
    {
      std::array<char, 256> host = {};
      gethostname(host.data(), host.size() - 1);
      std::array<char, 64> now  = {};
      const std::time_t    time = std::time(nullptr);
      std::tm              local;
      if (localtime_r(&time, &local) != nullptr)
        std::strftime(now.data(), now.size(), "%Y-%m-%d %H:%M:%S", &local);
      return "process " + std::to_string(getpid()) + " on " + host.data() + " since " + now.data() +
             ", " + study;
    }
  } // namespace

  FolderLock::FolderLock(const std::string  &folder,
                         const std::string  &study,
                         const Communicator &communicator,
                         Log                &log)
    : path_((fs::path(folder) / lock_name).string())
  {
    std::string refusal;
    if (communicator.is_root())
      {
        make_folder(folder);
        const Attempt attempt = try_to_lock(path_);
        if (attempt.is_refused)
          refusal = "expected a folder in which no other study runs, got \"" + folder +
                    "\", which is in use" +
                    (attempt.holder.empty() ? "" : " (" + attempt.holder + ")") +
                    ". Wait until that study ends, or name another folder by -o.";
        else
          descriptor_ = attempt.descriptor;
        if (attempt.error != 0)
          log.warning("the file system of \"",
                      folder,
                      "\" has no locks (",
                      std::strerror(attempt.error),
                      "). Do not start another study there");
        else if (descriptor_ >= 0 && !attempt.holder.empty())
          log.line("found the lock of a killed study (",
                   attempt.holder,
                   "); this study takes the lock");
      }
    refusal = communicator.broadcast(refusal);
    if (!refusal.empty())
      throw InputError("Study/output folder", refusal);
    if (descriptor_ < 0)
      return;
    // The text is for people; a full disk takes nothing from the lock.
    const std::string text = describe_this_process(study) + "\n";
    if (ftruncate(descriptor_, 0) != 0 || pwrite(descriptor_, text.data(), text.size(), 0) < 0)
      log.detail("\"", path_, "\" cannot be written: ", std::strerror(errno));
  }

  void FolderLock::make_folder(const std::string &folder)
  {
    // One by one, from the outermost missing one on, to know which to remove again.
    std::error_code       error;
    std::vector<fs::path> missing;
    for (fs::path path = fs::absolute(folder, error).lexically_normal();
         !error && !path.empty() && !fs::exists(path, error) && path != path.parent_path();
         path = path.parent_path())
      if (!path.filename().empty())
        missing.push_back(path);
    for (auto path = missing.rbegin(); path != missing.rend(); ++path)
      if (fs::create_directory(*path, error))
        made_.push_back(path->string());
  }

  FolderLock::~FolderLock()
  {
    if (descriptor_ >= 0)
      {
        unlink(path_.c_str());
        close(descriptor_);
      }
    std::error_code error;
    for (auto path = made_.rbegin(); path != made_.rend(); ++path)
      if (fs::is_empty(*path, error))
        fs::remove(*path, error);
  }

  bool is_in_use(const std::string &folder)
  {
    const int descriptor = open((fs::path(folder) / lock_name).c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor < 0)
      return false;
    const bool is_held = flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    close(descriptor);
    return is_held;
  }
} // namespace vfife
