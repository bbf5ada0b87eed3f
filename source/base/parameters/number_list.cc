// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/number_list.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/quantity.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cctype>
#include <memory>

namespace vfife
{
  namespace
  {
    bool is_digit(const char letter)
    {
      return std::isdigit(static_cast<unsigned char>(letter)) != 0;
    }

    /** The parts between commas as they are written. */
    std::vector<std::string> parts_of(const std::string &text)
    {
      std::vector<std::string> parts;
      for (std::size_t begin = 0; begin <= text.size();)
        {
          const std::size_t end = std::min(text.find(',', begin), text.size());
          parts.push_back(text.substr(begin, end - begin));
          begin = end + 1;
        }
      return parts;
    }

    /** How many digits @p part begins with. */
    std::size_t count_digits(const std::string &part)
    {
      return std::find_if_not(part.begin(), part.end(), is_digit) - part.begin();
    }

    /** Whether parts that commas without a blank join are one number: a decimal comma is one
     * alone, thousands have three digits behind each comma. */
    bool may_be_one(const std::vector<std::string> &run, const ListNumbers numbers)
    {
      if (run.size() < 2)
        return false;
      std::string first = trimmed(run.front());
      if (!first.empty() && (first[0] == '+' || first[0] == '-'))
        first.erase(0, 1);
      if (count_digits(first) != first.size())
        return false; // "1.5,2"
      const std::string &last = run.back();
      if (run.size() == 2 && numbers == ListNumbers::any && last[count_digits(last)] != '.')
        return true;
      return first.size() <= 3 && first[0] != '0' &&
             std::all_of(run.begin() + 1, run.end(), [](const std::string &part) {
               return count_digits(part) == 3;
             });
    }

    [[noreturn]] void refuse(const std::vector<std::string> &run)
    {
      std::string one, apart;
      for (const std::string &part : run)
        {
          one += (one.empty() ? "" : ",") + trimmed(part);
          apart += (apart.empty() ? "" : ", ") + trimmed(part);
        }
      throw InputError("\"" + one + "\" may mean one number or " + std::to_string(run.size()) +
                       ". Write a decimal point and no separator of thousands, or a blank after "
                       "each comma of a list (\"" +
                       apart + "\")");
    }

    std::vector<std::string> split(const std::string &text, const ListNumbers numbers)
    {
      check_list_commas(text, numbers);
      std::vector<std::string> list;
      if (trimmed(text).empty())
        return list;
      for (const std::string &part : parts_of(text))
        {
          list.push_back(trimmed(part));
          if (list.back().empty())
            throw InputError("empty number in the list");
        }
      return list;
    }

    class ListPattern : public dealii::Patterns::PatternBase
    {
    public:
      explicit ListPattern(const ListNumbers numbers)
        : numbers_(numbers)
      {
      }
      bool match(const std::string &text) const override
      {
        split(text, numbers_); // throws the reason
        return true;
      }
      std::string description(const OutputStyle) const override
      {
        return "numbers separated by commas";
      }
      std::unique_ptr<PatternBase> clone() const override
      {
        return std::make_unique<ListPattern>(*this);
      }

    private:
      ListNumbers numbers_;
    };
  } // namespace

  std::vector<std::string> split_at_commas(const std::string &text)
  {
    std::vector<std::string> parts = parts_of(text);
    for (std::string &part : parts)
      part = trimmed(part);
    return parts;
  }

  void check_list_commas(const std::string &text, const ListNumbers numbers)
  {
    std::vector<std::string> run;
    for (const std::string &part : parts_of(text))
      {
        const bool goes_on = !run.empty() && !run.back().empty() && is_digit(run.back().back()) &&
                             !part.empty() && is_digit(part[0]);
        if (!goes_on)
          {
            if (may_be_one(run, numbers))
              refuse(run);
            run.clear();
          }
        run.push_back(part);
      }
    if (may_be_one(run, numbers))
      refuse(run);
  }

  void declare_number_list(dealii::ParameterHandler &prm,
                           const std::string        &name,
                           std::vector<std::string> &value,
                           const std::string        &meaning,
                           const ListNumbers         numbers)
  {
    prm.declare_entry(name,
                      list_of(value),
                      ListPattern(numbers),
                      meaning + " (numbers separated by commas)");
    prm.add_action(name,
                   [&value, numbers](const std::string &text) { value = split(text, numbers); });
  }

  std::vector<double> read_number_list(const std::vector<std::string> &texts,
                                       const std::string              &unit)
  {
    const std::string of_bare = texts.empty() ? unit : read_quantity(texts.back(), unit).unit->name;
    std::vector<double> numbers;
    for (const std::string &text : texts)
      numbers.push_back(parse_quantity(text, of_bare));
    return numbers;
  }
} // namespace vfife
