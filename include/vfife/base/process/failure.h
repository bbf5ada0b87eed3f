// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_process_failure_h
#define vfife_base_process_failure_h

#include <exception>
#include <string>

namespace vfife
{
  /** What an exception means to the user and to the shell. */
  struct Failure
  {
    /** 0: none, 1: the input cannot be used, 2: the computation failed, 3: stopped by a signal, to
     * go on later. */
    int         exit_code = 0;
    std::string message; ///< one line, without the name of the program
  };

  /** The message of any exception on one line; of deal.II's exceptions only what they have to say,
   * no frame. */
  std::string short_message(const std::exception &exception);

  /** The failure that a caught exception stands for: InputError 1, Interrupted 3, everything
   * else 2.
   */
  Failure describe_failure(const std::exception_ptr &exception);
} // namespace vfife

#endif
