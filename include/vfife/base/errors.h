// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_errors_h
#define vfife_base_errors_h

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  /**
   * The user's input cannot be used: exit code 1. The entry is a path such as
   * "Gear pair/Gear/Body/web thickness", by which the driver finds file and line; it may be empty.
   */
  class InputError : public std::runtime_error
  {
  public:
    explicit InputError(const std::string &message)
      : std::runtime_error(message)
    {
    }

    InputError(const std::string &entry, const std::string &message)
      : std::runtime_error(message)
      , entry_(entry)
    {
    }

    const std::string &entry() const
    {
      return entry_;
    }

  private:
    std::string entry_;
  };

  /** Several things are wrong with the input at once; entry() is that of the first. */
  class InputErrors : public InputError
  {
  public:
    /** @p errors must not be empty. */
    explicit InputErrors(std::vector<InputError> errors)
      : InputError(errors.front().entry(), joined(errors))
      , errors_(std::move(errors))
    {
    }

    const std::vector<InputError> &errors() const
    {
      return errors_;
    }

  private:
    static std::string joined(const std::vector<InputError> &errors)
    {
      std::string text;
      for (const InputError &error : errors)
        text += (text.empty() ? "" : "\n") + std::string(error.what());
      return text;
    }

    std::vector<InputError> errors_;
  };

  /** What @p read returns; its InputError is one about the @p entry. */
  template <typename Read>
  auto for_entry(const std::string &entry, const Read &read)
  {
    try
      {
        return read();
      }
    catch (const InputError &error)
      {
        throw InputError(entry, error.what());
      }
  }

  /** What @p read returns; the message of its InputError is put behind the @p place. */
  template <typename Read>
  auto for_place(const std::string &place, const Read &read)
  {
    try
      {
        return read();
      }
    catch (const InputError &error)
      {
        throw InputError(place + ": " + error.what());
      }
  }

  /**
   * A signal has asked the program to stop, and what is needed to go on is on disk: exit code 3.
   * The message says how.
   */
  class Interrupted : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * The computation failed (energy, NaN, inverted element, runaway penetration, no convergence):
   * exit code 2. The message names time, step, element or node, and cause.
   */
  class NumericalError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace vfife

#endif
