// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/mesh/mesh_size.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

#include <sys/resource.h>
#include <unistd.h>

namespace vfife
{
  namespace
  {
    /** Of triangulation, body and operator for each hexahedron [bytes]: blocks of 0.2 and 0.6
     * million take 0.88 kB in the check of a run. */
    constexpr double bytes_per_cell = 0.9e3;
    /** deal.II and the arrays here number nodes, faces and edges by 32 bits; there are some three
     * edges to a cell. */
    constexpr double most_cells = 5e8;

    /** First number in a file of the kernel; infinite where there is none ("max"). */
    double read_limit(const std::string &path)
    {
      std::ifstream file(path);
      double        bytes = 0.;
      return file >> bytes ? bytes : std::numeric_limits<double>::infinity();
    }

    /** MemAvailable of the machine. */
    double machine_memory()
    {
      std::ifstream file("/proc/meminfo");
      std::string   name, unit;
      double        kilobytes = 0.;
      while (file >> name >> kilobytes)
        {
          if (name == "MemAvailable:")
            return 1024. * kilobytes;
          std::getline(file, unit);
        }
      return std::numeric_limits<double>::infinity();
    }

    /** What the control groups of both versions leave. */
    double group_memory()
    {
      const std::string groups = "/sys/fs/cgroup/";
      const double two = read_limit(groups + "memory.max") - read_limit(groups + "memory.current");
      const double one = read_limit(groups + "memory/memory.limit_in_bytes") -
                         read_limit(groups + "memory/memory.usage_in_bytes");
      // Without a limit, or without the files, the difference is infinite or no number.
      double left = std::numeric_limits<double>::infinity();
      for (const double found : {two, one})
        if (found > 0.)
          left = std::min(left, found);
      return left;
    }

    /** What the limit of the address space (ulimit -v) leaves. */
    double process_memory()
    {
      rlimit limit{};
      if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return std::numeric_limits<double>::infinity();
      const double used =
        read_limit("/proc/self/statm") * static_cast<double>(sysconf(_SC_PAGESIZE));
      return std::max(0., static_cast<double>(limit.rlim_cur) - used);
    }
  } // namespace

  void check_mesh_size(const std::string &place, const double n_cells)
  {
    const double available = std::min({machine_memory(), group_memory(), process_memory()});
    const double needed    = n_cells * bytes_per_cell;
    if (n_cells <= most_cells && needed <= available)
      return;
    std::ostringstream message;
    set_figure_digits(message, 3);
    message << "a mesh of " << n_cells << " elements ";
    if (n_cells > most_cells)
      message << "is too large: at most " << most_cells << " can be numbered";
    else
      message << "needs about " << 1e-9 * needed << " GB of memory, " << 1e-9 * available
              << " GB are free";
    throw InputError(place, message.str());
  }
} // namespace vfife
