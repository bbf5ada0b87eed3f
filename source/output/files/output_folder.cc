// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/declared_section.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/json.h>
#include <vfife/base/text/table.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/folder/file_list.h>
#include <vfife/output/folder/input_files.h>

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace vfife
{
  namespace
  {
    namespace fs = std::filesystem;

    /** Why a folder cannot be used. */
    struct FolderFault
    {
      std::string reason;          ///< empty: it can
      bool        is_disk = false; ///< that is full or fails, not the user's to mend

      /** What the system says. */
      static FolderFault of(const std::error_code &error)
      {
        const int code = error.value();
        return {error.message(), code == ENOSPC || code == EDQUOT || code == EIO};
      }
    };

    FolderFault create(const std::string &path)
    {
      if (path.empty())
        return {"it has no name"};
      std::error_code error;
      if (fs::exists(path, error) && !fs::is_directory(path, error))
        return {"it is a file"};
      fs::create_directories(path, error);
      if (error)
        return FolderFault::of(error);

      // Permissions say less than trying: read-only file systems, full disks.
      const std::string probe = path + "/.vfife_is_writable";
      {
        std::ofstream file(probe);
        file << "x" << std::flush;
        if (!file)
          return FolderFault::of({errno, std::generic_category()});
      }
      fs::remove(probe, error);
      return {};
    }

    [[noreturn]] void refuse(const std::string &path)
    {
      throw std::runtime_error("cannot write \"" + path + "\": " + std::strerror(errno));
    }

    /** Makes a folder on one rank; what all ranks return. */
    FolderFault create_on_root(const std::string &path, const Communicator &communicator)
    {
      const FolderFault fault = communicator.is_root() ? create(path) : FolderFault();
      return {communicator.broadcast(fault.reason), communicator.any(fault.is_disk)};
    }

    [[noreturn]] void refuse_folder(const std::string &path, const FolderFault &fault)
    {
      throw std::runtime_error("cannot write to the folder \"" + path + "\": " + fault.reason);
    }

    /** All entries at or below @p section by path, "A/B/name"; @p before leads here, "A/". */
    void add_entries(const DeclaredSection &section, const std::string &before, Json &entries)
    {
      for (const DeclaredSection::Entry &entry : section.entries)
        entries[before + entry.name] =
          Json{{"value", entry.value}, {"unit", entry.unit()}, {"default", entry.default_value}};
      for (const DeclaredSection &below : section.sections)
        add_entries(below, before + below.name + "/", entries);
    }
  } // namespace

  OutputFolder::OutputFolder(std::string path, const Communicator &communicator)
    : path_(std::move(path))
    , communicator_(communicator)
  {
    const FolderFault fault = create_on_root(path_, communicator_);
    if (fault.is_disk)
      refuse_folder(path_, fault);
    if (!fault.reason.empty())
      throw InputError("Study/output folder",
                       "expected a folder that can be written to, got \"" + path_ +
                         "\": " + fault.reason + ". Name another folder.");
  }

  OutputFolder::OutputFolder(ResultKeeper &keeper, const Communicator &communicator)
    : keeper_(&keeper)
    , communicator_(communicator)
  {
  }

  OutputFolder::~OutputFolder()
  {
    if (log_ != nullptr)
      log_->stop_file();
  }

  bool OutputFolder::is_on_disk() const
  {
    return keeper_ == nullptr;
  }

  void OutputFolder::require_disk() const
  {
    if (!is_on_disk())
      throw std::logic_error("these results need a folder: they cannot be kept in memory");
  }

  const std::string &OutputFolder::path() const
  {
    require_disk();
    return path_;
  }

  const Communicator &OutputFolder::communicator() const
  {
    return communicator_;
  }

  std::string OutputFolder::file(const std::string &name) const
  {
    return path() + "/" + name;
  }

  bool OutputFolder::is_writer() const
  {
    return communicator_.is_root();
  }

  void OutputFolder::keep_list()
  {
    if (is_writer())
      list_ = std::make_unique<FileList>(path());
  }

  void OutputFolder::list_file(const std::string &name) const
  {
    if (list_)
      list_->add(name);
  }

  void OutputFolder::make_subfolder(const std::string &name) const
  {
    list_file(name + "/");
    if (!is_on_disk())
      return;
    const FolderFault fault = create_on_root(file(name), communicator_);
    if (!fault.reason.empty())
      refuse_folder(file(name), fault);
  }

  void OutputFolder::write_file(const std::string                         &name,
                                const std::function<void(std::ostream &)> &write) const
  {
    if (keeper_ != nullptr)
      {
        std::ostringstream text;
        write(text);
        keeper_->keep_text(name, text.str());
        return;
      }
    list_file(name);
    // Closed before it is renamed: a full disk shows at the latest when the last bytes go out.
    const std::string path      = file(name);
    const std::string temporary = path + ".part";
    {
      // What the disk does not take shows when the file is closed, at the latest.
      std::ofstream out(temporary, std::ios::binary);
      try
        {
          if (out)
            write(out);
        }
      catch (...)
        {
          // deal.II's writers throw when the stream fails, and do not know the file.
          if (out)
            throw;
        }
      out.close();
      if (!out)
        refuse(path);
    }
    // Readers see the old file or the new one.
    std::error_code error;
    fs::rename(temporary, path, error);
    if (error)
      throw std::runtime_error("cannot write \"" + path + "\": " + error.message());
  }

  void OutputFolder::write_table(const std::string &name, const Table &table) const
  {
    if (is_on_disk())
      write_file(name, [&table](std::ostream &out) { table.write_csv(out); });
    finish_table(name, table);
  }

  void OutputFolder::finish_table(const std::string &name, const Table &table) const
  {
    // A format beside .csv is written here.
    if (keeper_ != nullptr)
      keeper_->keep_table(name, table);
  }

  void OutputFolder::copy_file(const std::string &from, const std::string &name) const
  {
    list_file(name);
    const std::string temporary = file(name) + ".part";
    std::error_code   error;
    fs::copy_file(from, temporary, fs::copy_options::overwrite_existing, error);
    if (!error)
      fs::rename(temporary, file(name), error);
    if (error)
      throw std::runtime_error("cannot copy \"" + from + "\" to \"" + file(name) +
                               "\": " + error.message());
  }

  void OutputFolder::remove_file(const std::string &name) const
  {
    std::error_code error;
    if (is_writer() && is_on_disk())
      fs::remove(file(name), error);
  }

  void OutputFolder::write_parameters(dealii::ParameterHandler &prm,
                                      const std::string        &parameter_file)
  {
    const DeclaredSection declared = find_declared(prm);
    parameters_                    = declared.list_texts(&DeclaredSection::Entry::value);
    input_digests_                 = list_digests(declared);
    parameter_file_                = parameter_file;
    const auto defaults            = declared.list_texts(&DeclaredSection::Entry::default_value);
    set_parameters_.clear();
    for (std::size_t i = 0; i < defaults.size(); ++i)
      if (parameters_[i] != defaults[i])
        set_parameters_.push_back(defaults[i].first);
    if (!is_writer())
      return;
    write_file("parameters.prm", [&prm](std::ostream &out) { print_parameters(out, prm); });
    Json entries = Json::object();
    add_entries(declared, "", entries);
    for (const auto &[path, digest] : input_digests_)
      entries[path]["digest"] = digest;
    write_file("parameters.json", [&entries](std::ostream &out) {
      out << entries.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    });
  }

  void OutputFolder::attach_log(Log &log, const std::optional<std::size_t> kept)
  {
    require_disk();
    log_ = &log;
    if (!is_writer())
      return;
    const std::string path = file("run.log");
    list_file("run.log");
    std::error_code error;
    const auto      size = fs::file_size(path, error);
    // What the run said after the checkpoint it goes on from, it will say again.
    if (kept && !error && size > *kept)
      fs::resize_file(path, *kept, error);
    log_file_ = std::make_unique<std::ofstream>(path, kept ? std::ios::app : std::ios::trunc);
    if (!*log_file_)
      refuse(path);
    // Only then tellp() says how long the file is (log_size()).
    log_file_->seekp(0, std::ios::end);
    log.write_to(*log_file_);
  }

  std::size_t OutputFolder::log_size() const
  {
    // What a checkpoint notes: a run that goes on from it cuts the log there.
    return log_file_ ? static_cast<std::size_t>(log_file_->tellp()) : 0;
  }

  std::map<std::string, KeptEntry> read_kept_entries(const std::string &folder)
  {
    std::map<std::string, KeptEntry> kept;
    std::ifstream                    file(folder + "/parameters.json");
    const Json                       entries = Json::parse(file, nullptr, false);
    const auto                       text = [](const Json &entry, const char *name) -> std::string {
      return entry.contains(name) && entry[name].is_string() ? entry[name].get<std::string>() : "";
    };
    if (entries.is_object())
      for (const auto &[path, entry] : entries.items())
        if (entry.is_object())
          kept[path] = {text(entry, "value"), text(entry, "unit"), text(entry, "digest")};
    return kept;
  }

  std::map<std::string, std::string> read_input_digests(const std::string &folder)
  {
    std::map<std::string, std::string> digests;
    for (const auto &[path, entry] : read_kept_entries(folder))
      if (!entry.digest.empty())
        digests[path] = entry.digest;
    return digests;
  }
} // namespace vfife
