// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/failure.h>

#include <deal.II/base/exceptions.h>

#include <new>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** The words of @p text with single blanks between them. */
    std::string on_one_line(const std::string &text)
    {
      std::istringstream words(text);
      std::string        line, word;
      while (words >> word)
        line += (line.empty() ? "" : " ") + word;
      return line;
    }
  } // namespace

  std::string short_message(const std::exception &exception)
  {
    const auto *const deal_exception = dynamic_cast<const dealii::ExceptionBase *>(&exception);
    if (deal_exception == nullptr)
      return exception.what();

    std::ostringstream text;
    deal_exception->print_info(text);
    const std::string message = on_one_line(text.str());
    // deal.II explains its internal errors at length and others not at all: then the name says more
    const std::size_t longest = 400;
    if (!message.empty() && message != "(none)" && message.size() <= longest)
      return message;
    const char *const name = deal_exception->get_exc_name();
    return name == nullptr || *name == '\0' ? "an error inside deal.II"
                                            : "deal.II reports " + on_one_line(name);
  }

  Failure describe_failure(const std::exception_ptr &exception)
  {
    // Exit codes: 1 what the user can mend, 2 what the computation or the machine could not do, 3 a
    // stop that was asked for.
    // The order is from the special to the general, for all are std::exceptions.
    if (!exception)
      return {};
    try
      {
        std::rethrow_exception(exception);
      }
    catch (const InputError &error)
      {
        return {1, error.what()};
      }
    catch (const Interrupted &interruption)
      {
        return {3, interruption.what()};
      }
    catch (const NumericalError &error)
      {
        return {2, error.what()};
      }
    // Of a model too large for the machine; the exception's own text would not say so.
    catch (const std::bad_alloc &)
      {
        return {2, "not enough memory"};
      }
    catch (const std::exception &error)
      {
        return {2, short_message(error)};
      }
    catch (...)
      {
        return {2, "an error of unknown kind"};
      }
  }
} // namespace vfife
