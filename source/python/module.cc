// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/process/failure.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/base/text/table.h>
#include <vfife/gear/flank_points.h>
#include <vfife/gear/spiral_bevel/gear_pair.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/study/study.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <map>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>

#include <unistd.h>

// Python's module _vfife, on which source/report/vfife/gear.py builds: studies computed inside
// Python's process, without files. The functions release Python's lock while they compute.
namespace
{
  namespace py = pybind11;
  using namespace vfife;

  /** A parameter file of Python's: a path, or a text that stands for a file of that path. */
  struct Source
  {
    std::string                path;
    std::optional<std::string> text;
    std::vector<std::string>   settings; ///< "Section/Sub/name=value"

    ParameterFile read() const
    {
      return text ? ParameterFile::of_text(*text, path, settings) : ParameterFile(path, settings);
    }
  };

  /** Leads through pybind11 to the exceptions of vfife.errors. */
  struct Refusal
  {
    Failure failure;
  };

  class KeptResults : public ResultKeeper
  {
  public:
    void keep_table(const std::string &name, const Table &table) override
    {
      tables.insert_or_assign(name, table);
    }

    void keep_text(const std::string &name, const std::string &text) override
    {
      texts.insert_or_assign(name, text);
    }

    std::map<std::string, Table>       tables;
    std::map<std::string, std::string> texts;
  };

  /** This process alone, whatever other ranks there may be. MPI is started with the first analysis,
   * where nobody else has, and ended with Python by end(). */
  class OwnProcess
  {
  public:
    Communicator &communicator()
    {
      if (!alone_)
        start();
      // MPI knows nothing of a copy of the process.
      if (process_ != getpid())
        throw std::runtime_error("this process was forked after a computation. Start it in "
                                 "multiprocessing by the method \"spawn\"");
      return *alone_;
    }

    void end()
    {
      if (process_ == getpid())
        session_.reset();
    }

  private:
    void start()
    {
      int started = 0;
      MPI_Initialized(&started);
      if (started == 0)
        {
          if (const Failure obstacle = find_start_obstacle(); obstacle.exit_code != 0)
            throw std::runtime_error(obstacle.message);
          static char  name[]      = "vfife";
          static char *arguments[] = {name, nullptr};
          int          n           = 1;
          char       **argv        = arguments;
          session_.emplace(n, argv);
        }
      alone_.emplace(MPI_COMM_SELF);
      process_ = getpid();
    }

    std::optional<MpiSession>   session_;
    std::optional<Communicator> alone_;
    pid_t                       process_ = 0;
  };

  OwnProcess &own_process()
  {
    static OwnProcess process;
    return process;
  }

  /** Computes without Python's lock, one thread at a time: below are libraries that know of no
   * threads. */
  template <typename What>
  auto compute(const What &what)
  {
    static std::mutex                 one_at_a_time;
    const py::gil_scoped_release      released;
    const std::lock_guard<std::mutex> alone(one_at_a_time);
    try
      {
        return what();
      }
    catch (...)
      {
        throw Refusal{describe_failure(std::current_exception())};
      }
  }

  /** ({column: array or list of texts}, {column: unit}) */
  py::tuple tuple_of(const Table &table)
  {
    py::dict columns, units;
    for (const Table::Column &column : table.columns())
      {
        const py::str name(column.name);
        if (column.is_text)
          columns[name] = py::cast(column.texts);
        else
          columns[name] =
            py::array_t<double>(py::ssize_t(column.numbers.size()), column.numbers.data());
        units[name] = column.unit;
      }
    return py::make_tuple(columns, units);
  }

  /** ({name of file: table}, {name of file: text}, log) */
  py::tuple analyse(const Source &source)
  {
    KeptResults        kept;
    std::ostringstream said;
    compute([&] {
      Log log(said, true);
      compute_study(source.read(), kept, own_process().communicator(), log);
    });
    py::dict tables;
    for (const auto &[name, table] : kept.tables)
      tables[py::str(name)] = tuple_of(table);
    return py::make_tuple(tables, kept.texts, said.str());
  }

  py::tuple find_flank_points(const Source      &source,
                              const bool         of_pinion,
                              const unsigned int lengthwise,
                              const unsigned int profile)
  {
    return tuple_of(compute([&] {
      const GearPair pair = read_gear_pair(source.read());
      return compute_flank_points(of_pinion ? pair.pinion() : pair.gear(), lengthwise, profile);
    }));
  }

  void raise_in_python(const std::exception_ptr exception)
  {
    try
      {
        if (exception)
          std::rethrow_exception(exception);
      }
    catch (const Refusal &refusal)
      {
        const char *const name =
          refusal.failure.exit_code == 1 ? "InputError" : "ComputationFailed";
        const py::object kind = py::module_::import("vfife.errors").attr(name);
        PyErr_SetObject(kind.ptr(), py::str(refusal.failure.message).ptr());
      }
  }
} // namespace

PYBIND11_MODULE(_vfife, module)
{
  py::register_local_exception_translator(raise_in_python);
  py::class_<Source>(module, "Source")
    .def(py::init<std::string, std::optional<std::string>, std::vector<std::string>>());
  module.def("analyse", analyse);
  module.def("flank_points", find_flank_points);
  py::module_::import("atexit").attr("register")(py::cpp_function([] { own_process().end(); }));
}
