// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_output_folder_h
#define vfife_output_output_folder_h

#include <fstream>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace vfife
{
  class Communicator;
  class Log;

  /**
   * The folder of one run's results, on a file system that all ranks see. Whole files are written
   * under a temporary name and renamed, so that a reader (or a run that is killed) never meets half
   * a file.
   */
  class OutputFolder
  {
  public:
    /**
     * Creates the folder where it does not exist (collective). Throws InputError on all ranks when
     * the path is a file, cannot be created, or cannot be written to.
     */
    OutputFolder(std::string path, const Communicator &communicator);
    ~OutputFolder();
    OutputFolder(const OutputFolder &)            = delete;
    OutputFolder &operator=(const OutputFolder &) = delete;

    const std::string  &path() const;
    const Communicator &communicator() const;
    /** Path of a file of the folder. */
    std::string file(const std::string &name) const;
    /** Whether this rank writes the text files. */
    bool is_writer() const;

    /** Collective; throws InputError on all ranks. */
    void make_subfolder(const std::string &name) const;

    /**
     * Lets @p write fill a file and puts it in place; on the calling rank only. Throws InputError
     * when the file cannot be opened, std::runtime_error when the disk does not take it.
     */
    void write_file(const std::string                         &name,
                    const std::function<void(std::ostream &)> &write) const;

    /** parameters.prm: the parameters in force, readable again. Only the writing rank writes. */
    void write_parameters(dealii::ParameterHandler &prm) const;

    /** run.log: what @p log said so far and will say; @p log must not outlive the folder. */
    void attach_log(Log &log);

  private:
    std::string                    path_;
    const Communicator            &communicator_;
    std::unique_ptr<std::ofstream> log_file_;
    Log                           *log_ = nullptr;
  };
} // namespace vfife

#endif
