// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_files_output_folder_h
#define vfife_output_files_output_folder_h

#include <vfife/base/parameter_handler.h>

#include <fstream>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  class Communicator;
  class FileList;
  class Log;
  class Table;

  /** Takes results in the place of a folder. */
  class ResultKeeper
  {
  public:
    virtual ~ResultKeeper() = default;

    /** A table that a folder would have as the file @p name ("path.csv"). */
    virtual void keep_table(const std::string &name, const Table &table) = 0;

    /** Any other file with its content. */
    virtual void keep_text(const std::string &name, const std::string &text) = 0;
  };

  /**
   * The folder of one run's results, on a file system that all ranks see. Whole files are written
   * under a temporary name and renamed, so that a reader (or a run that is killed) never meets half
   * a file.
   */
  class OutputFolder
  {
  public:
    /**
     * Creates the folder where it does not exist (collective). Throws on all ranks: InputError when
     * it cannot be created or written to, std::runtime_error when the disk is full or fails.
     */
    OutputFolder(std::string path, const Communicator &communicator);
    /** No folder: @p keeper, which must outlive this, takes all files, and nothing is written. What
     * files on a disk are needed for throws std::logic_error: path(), file(), copy_file(),
     * attach_log(). */
    OutputFolder(ResultKeeper &keeper, const Communicator &communicator);
    ~OutputFolder();
    OutputFolder(const OutputFolder &)            = delete;
    OutputFolder &operator=(const OutputFolder &) = delete;

    /** Whether there is a folder. */
    bool                is_on_disk() const;
    const std::string  &path() const;
    const Communicator &communicator() const;
    /** Path of a file of the folder. */
    std::string file(const std::string &name) const;
    /** Whether this rank writes the text files. */
    bool is_writer() const;

    /** From now on all files that are written are listed in files.txt (FileList). */
    void keep_list();

    /** Lists a file, or a folder below by a name that ends in "/", that others write; on the
     * writing rank, once keep_list() has been called. */
    void list_file(const std::string &name) const;

    /** Collective; throws on all ranks. */
    void make_subfolder(const std::string &name) const;

    /**
     * Lets @p write fill a file and puts it in place; on the calling rank only. Throws
     * std::runtime_error when the file cannot be opened or the disk does not take it.
     */
    void write_file(const std::string                         &name,
                    const std::function<void(std::ostream &)> &write) const;

    /** Writes a table as the file @p name, as write_file(), and finishes it. */
    void write_table(const std::string &name, const Table &table) const;

    /** All tables pass here when they have their last row: those of write_table(), and those whose
     * file has grown row by row (CsvStream). On the calling rank only. */
    void finish_table(const std::string &name, const Table &table) const;

    /**
     * Puts a copy of the file @p from into the folder; on the calling rank only. Throws
     * std::runtime_error where it cannot be read or the disk does not take it.
     */
    void copy_file(const std::string &from, const std::string &name) const;

    /** Removes a file of the folder if it is there; only the writing rank does. */
    void remove_file(const std::string &name) const;

    /**
     * parameters.prm: the parameters in force, readable again; parameters.json: the same for other
     * programs, by path ("A/B/name") value and default as texts and the unit in which a bare number
     * is meant ("" for words); of an entry that names a file also the digest of its content.
     * @p parameter_file: where they were read. Only the writing rank writes.
     */
    void write_parameters(dealii::ParameterHandler &prm, const std::string &parameter_file);

    /** What write_parameters() has written: paths ("A/B/name") and values. */
    const std::vector<std::pair<std::string, std::string>> &parameters() const
    {
      return parameters_;
    }

    /** Paths of those that are not at their defaults. */
    const std::vector<std::string> &set_parameters() const
    {
      return set_parameters_;
    }
    /** Digests of the files that they name (list_digests()). */
    const std::vector<std::pair<std::string, std::string>> &input_digests() const
    {
      return input_digests_;
    }
    /** The file that they were read from, as the command line named it. */
    const std::string &parameter_file() const
    {
      return parameter_file_;
    }

    /**
     * run.log: what @p log said so far and will say; @p log must not outlive the folder. With
     * @p kept the first so many bytes of the file there is are kept in front of it.
     */
    void attach_log(Log &log, std::optional<std::size_t> kept = {});

    /** Bytes of run.log so far; 0 on ranks that do not write. */
    std::size_t log_size() const;

  private:
    void require_disk() const;

    std::string                    path_;
    ResultKeeper                  *keeper_ = nullptr; ///< in the place of a folder
    const Communicator            &communicator_;
    std::unique_ptr<FileList>      list_; ///< on the writing rank, where one is kept
    std::unique_ptr<std::ofstream> log_file_;
    Log                           *log_ = nullptr;

    std::vector<std::pair<std::string, std::string>> parameters_;
    std::vector<std::pair<std::string, std::string>> input_digests_;
    std::vector<std::string>                         set_parameters_;
    std::string                                      parameter_file_;
  };

  /** An entry in force, of parameters.json. */
  struct KeptEntry
  {
    std::string value;
    std::string unit;   ///< of a bare number
    std::string digest; ///< of the content of the file that it names; empty where it names none
  };

  /** Those of a folder of results by their paths ("A/B/name"); empty where it has none. */
  std::map<std::string, KeptEntry> read_kept_entries(const std::string &folder);

  /** The digests of files that OutputFolder::write_parameters() has kept in @p folder, by entry;
   * none where earlier versions of the program have written there. */
  std::map<std::string, std::string> read_input_digests(const std::string &folder);
} // namespace vfife

#endif
