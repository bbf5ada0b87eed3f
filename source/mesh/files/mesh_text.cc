// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/shown_text.h>

#include "mesh_text.h"

#include <boost/algorithm/string/predicate.hpp>

#include <charconv>

namespace vfife
{
  MeshText::MeshText(const std::string &path, const char comment)
    : path_(path)
    , file_(path)
    , lines_(file_)
    , comment_(comment)
  {
  }

  void MeshText::refuse(const std::string &message) const
  {
    throw InputError(path_ + ":" + std::to_string(lines_.number()) + ": " + message);
  }

  unsigned int MeshText::line() const
  {
    return lines_.number();
  }

  std::string MeshText::next()
  {
    std::string found, line;
    if (!returned_.empty())
      {
        found.swap(returned_);
        return found;
      }
    while (!(words_ >> found))
      {
        if (!next_line(line))
          return "";
        words_.str(comment_ != '\0' && line[0] == comment_ ? "" : line);
      }
    return found;
  }

  void MeshText::put_back(const std::string &word)
  {
    returned_ = word;
  }

  bool MeshText::next_line(std::string &line)
  {
    words_.clear();
    words_.str("");
    try
      {
        return lines_.next(line);
      }
    catch (const InputError &error)
      {
        refuse(error.what());
      }
  }

  std::string MeshText::word(const std::string &what)
  {
    std::string found = next();
    if (found.empty())
      refuse("the file ends before " + what);
    return found;
  }

  void MeshText::expect(const std::string &expected)
  {
    const std::string found = word(expected);
    if (!boost::iequals(found, expected, std::locale::classic()))
      refuse("expected " + expected + ", got \"" + shown(found) + "\"");
  }

  double MeshText::number(const std::string &what)
  {
    const std::string found = word(what);
    std::string       rest;
    try
      {
        const double value = read_number(found, rest);
        if (rest.empty())
          return value;
      }
    catch (const InputError &)
      {
        // the place says more than the reason
      }
    refuse("expected a number (" + what + "), got \"" + shown(found) + "\"");
  }

  Vector3 MeshText::point()
  {
    Vector3 x;
    for (unsigned int c = 0; c < 3; ++c)
      x[c] = number("a coordinate");
    return x;
  }

  long MeshText::integer(const std::string &what, const long least)
  {
    const std::string found  = word(what);
    long              value  = 0;
    const auto        result = std::from_chars(found.data(), found.data() + found.size(), value);
    if (result.ec != std::errc() || result.ptr != found.data() + found.size())
      refuse("expected a whole number (" + what + "), got \"" + shown(found) + "\"");
    if (value < least)
      refuse(what + " must be at least " + std::to_string(least) + ", got " + found);
    return value;
  }

  std::string MeshText::rest_of_line()
  {
    std::string line = rest_of_this_line();
    while (line.empty() && next_line(line))
      line = trimmed(line);
    return line;
  }

  std::string MeshText::rest_of_this_line()
  {
    std::string line;
    std::getline(words_, line);
    words_.clear();
    words_.str("");
    return trimmed(line);
  }
} // namespace vfife
