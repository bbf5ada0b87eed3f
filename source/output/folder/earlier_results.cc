// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/output/folder/earlier_results.h>
#include <vfife/output/folder/file_list.h>
#include <vfife/output/folder/folder_lock.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <stdexcept>

namespace vfife
{
  namespace
  {
    namespace fs = std::filesystem;

    // Folders within that of the results: of the study before, of that before it until the new one
    // has begun, what is thrown away, and copies for a study that goes on.
    const char previous[] = "previous", older[] = "previous.old", waste[] = "previous.waste",
               copies[] = "before_restart";

    /** Files that other programs than the study write, or under other names. */
    const std::set<std::string> &unlisted_names()
    {
      static const std::set<std::string> names = {"report.html",
                                                  "pictures/",
                                                  "checkpoint.bin",
                                                  "checkpoint.previous.bin"};
      return names;
    }

    /** A folder below with results of a study of its own, as those of the cases of a sweep. */
    bool is_study(const fs::path &folder)
    {
      return fs::exists(folder / "parameters.prm");
    }

    void move(const fs::path &from, const fs::path &to)
    {
      fs::create_directories(to.parent_path());
      std::error_code error;
      fs::rename(from, to, error);
      if (!error)
        return;
      // another file system, or a folder that is there already
      fs::copy(from,
               to,
               fs::copy_options::recursive | fs::copy_options::overwrite_existing |
                 fs::copy_options::copy_symlinks);
      fs::remove_all(from);
    }

    using Choice = bool (*)(const std::string &file);

    bool is_any(const std::string &)
    {
      return true;
    }

    /** Moves files of a folder and of those below, by default the results among them. */
    void move_below(const fs::path &from,
                    const fs::path &to,
                    const Choice    is_meant = &FileList::has_result_ending)
    {
      std::vector<fs::path> found;
      for (const auto &entry : fs::directory_iterator(from))
        found.push_back(entry.path());
      for (const fs::path &path : found)
        if (fs::is_directory(path))
          move_below(path, to / path.filename(), is_meant);
        else if (is_meant(path.filename().string()))
          move(path, to / path.filename());
      if (fs::is_empty(from))
        fs::remove(from);
    }

    using Names = std::set<std::string>;

    /** All that studies have written into a folder; none in one without results: what is in that
     * one is the user's. */
    Names list_results(const fs::path &folder)
    {
      Names names = FileList(folder.string()).names();
      if (!names.empty())
        names.insert(unlisted_names().begin(), unlisted_names().end());
      return names;
    }

    /** Moves what there is of these names, and with @p with_cases cases too. Returns whether there
     * is anything. */
    bool move_results(const Names    &names,
                      const fs::path &from,
                      const fs::path &to,
                      const bool      with_cases = true)
    {
      bool       any      = false;
      const auto move_one = [&](const std::string &name) {
        const fs::path path = from / name;
        if (!fs::exists(fs::symlink_status(path)))
          return;
        const bool is_folder = fs::is_directory(path), is_case = is_folder && is_study(path);
        if (is_case && !with_cases)
          return;
        any = true;
        if (is_folder && !is_case)
          move_below(path, to / name);
        else
          move(path, to / name);
      };
      for (const std::string &name : names)
        if (name != FileList::file_name)
          move_one(name.substr(0, name.find('/')));
      // Until all others are moved the list says which they are, also when the program is killed.
      if (names.count(FileList::file_name) > 0)
        move_one(FileList::file_name);
      return any;
    }

    bool move_all_results(const fs::path &from, const fs::path &to)
    {
      return move_results(list_results(from), from, to);
    }

    void remove_if_empty(const fs::path &folder)
    {
      std::error_code error;
      if (fs::is_directory(folder, error) && fs::is_empty(folder, error))
        fs::remove(folder, error);
    }

    /** Whether a study has come to its end, which all kinds say by a .json file, or can go on. */
    bool has_end(const fs::path &folder)
    {
      const std::set<std::string> names = FileList(folder.string()).names();
      return fs::exists(folder / "checkpoint.bin") ||
             std::any_of(names.begin(), names.end(), [&folder](const std::string &name) {
               return fs::path(name).extension() == ".json" && name != "parameters.json" &&
                      name != "geometry.json" && fs::exists(folder / name);
             });
    }

    /** What went wrong, or nothing. */
    std::string try_to(const std::function<void()> &what)
    {
      try
        {
          what();
        }
      catch (const std::exception &error)
        {
          return error.what();
        }
      return "";
    }
  } // namespace

  EarlierResults::EarlierResults(std::string folder, const Communicator &communicator)
    : folder_(std::move(folder))
    , communicator_(communicator)
  {
  }

  EarlierResults::~EarlierResults()
  {
    // Whatever cannot be removed is looked at by the next study.
    if (has_begun_ && communicator_.is_root())
      try_to([this] { settle(); });
  }

  void EarlierResults::settle() const
  {
    const fs::path folder(folder_);
    fs::remove_all(folder / copies);
    if (!fs::exists(folder / older))
      return;
    if (!has_end(folder / previous))
      {
        move_all_results(folder / previous, folder / waste);
        move_all_results(folder / older, folder / previous);
      }
    fs::remove_all(folder / older);
    fs::remove_all(folder / waste);
  }

  bool EarlierResults::move_away(const std::set<std::string> &staying) const
  {
    settle(); // what a killed study has left
    const fs::path folder(folder_);
    Names          names;
    for (const std::string &name : list_results(folder))
      if (staying.count(name.substr(0, name.find('/'))) == 0)
        names.insert(name);
    const Names former = list_results(folder / previous);
    bool        any    = false;
    try
      {
        move_results(former, folder / previous, folder / older);
        any = move_results(names, folder, folder / previous);
      }
    catch (...)
      {
        move_results(names, folder / previous, folder);
        move_results(former, folder / older, folder / previous);
        throw;
      }
    if (!any) // the one before stays the one before
      move_results(former, folder / older, folder / previous);
    remove_if_empty(folder / older);
    return any;
  }

  void EarlierResults::refuse_running_cases(const std::set<std::string> &staying) const
  {
    std::string refusal;
    if (communicator_.is_root())
      for (const std::string &name : std::set<std::string>(FileList(folder_).names()))
        {
          const std::string plain = name.substr(0, name.find('/'));
          const fs::path    path  = fs::path(folder_) / plain;
          if (name.back() == '/' && staying.count(plain) == 0 && is_study(path) &&
              is_in_use(path.string()))
            refusal = "expected a folder in which no study runs, got \"" + folder_ + "\": \"" +
                      path.string() +
                      "\" is in use. Wait until that study ends, or name another "
                      "folder by -o.";
        }
    refusal = communicator_.broadcast(refusal);
    if (!refusal.empty())
      throw InputError("Study/output folder", refusal);
  }

  bool EarlierResults::put_away(const std::set<std::string> &staying)
  {
    refuse_running_cases(staying);
    std::string failure =
      communicator_.is_root() ? try_to([&] { has_moved_ = move_away(staying); }) : "";
    failure = communicator_.broadcast(failure);
    if (!failure.empty())
      throw std::runtime_error("earlier results in \"" + folder_ +
                               "\" cannot be moved to previous/: " + failure);
    has_begun_ = true;
    has_moved_ = communicator_.any(has_moved_);
    return has_moved_;
  }

  void EarlierResults::copy() const
  {
    settle();
    const fs::path folder(folder_), to = folder / copies;
    fs::create_directories(to);
    for (const std::string &name : std::set<std::string>(FileList(folder_).names()))
      // Checkpoints are replaced only when the study goes on.
      if (fs::is_regular_file(folder / name) && fs::path(name).extension() != ".bin")
        fs::copy_file(folder / name, to / name, fs::copy_options::overwrite_existing);
    if (fs::exists(folder / "report.html"))
      move(folder / "report.html", to / "report.html");
    if (fs::is_directory(folder / "pictures"))
      move_below(folder / "pictures", to / "pictures");
  }

  void EarlierResults::keep_copies()
  {
    has_begun_ = has_copies_ = true;
    std::string failure      = communicator_.is_root() ? try_to([this] { copy(); }) : "";
    failure                  = communicator_.broadcast(failure);
    if (!failure.empty())
      {
        restore();
        throw std::runtime_error("results in \"" + folder_ + "\" cannot be copied: " + failure);
      }
  }

  void EarlierResults::bring_back() const
  {
    const fs::path folder(folder_);
    if (has_copies_)
      {
        move_below(folder / copies, folder, &is_any);
        return;
      }
    // What the new study has written goes, but not its cases: they are results by themselves.
    move_results(list_results(folder), folder, folder / waste, false);
    fs::remove_all(folder / waste);
    if (!has_moved_)
      return;
    const Names earlier = list_results(folder / previous);
    for (const std::string &name : earlier)
      if (name.back() == '/' && is_study(folder / previous / name))
        fs::remove_all(folder / name.substr(0, name.size() - 1));
    move_results(earlier, folder / previous, folder);
    move_all_results(folder / older, folder / previous);
    remove_if_empty(folder / previous);
    fs::remove_all(folder / older);
  }

  std::string EarlierResults::restore()
  {
    if (!has_begun_ || !communicator_.is_root())
      return "";
    has_begun_ = false;
    return try_to([this] { bring_back(); });
  }
} // namespace vfife
