// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/number_list.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/quantity.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

namespace vfife
{
  namespace
  {
    using CheckedRead = std::function<void(const std::string &)>;

    /**
     * A pattern that knows why it refuses a text: match() throws the InputError of the reader
     * instead of returning false, so that the reason reaches the user and not only the fact.
     * ParameterFile adds file and line.
     */
    class ReasonedPattern : public dealii::Patterns::PatternBase
    {
    public:
      ReasonedPattern(const CheckedRead &check, const std::string &words)
        : check_(check)
        , words_(words)
      {
      }

      bool match(const std::string &text) const override
      {
        check_(text);
        return true;
      }

      std::string description(const OutputStyle) const override
      {
        return words_;
      }

      std::unique_ptr<dealii::Patterns::PatternBase> clone() const override
      {
        return std::make_unique<ReasonedPattern>(*this);
      }

    private:
      CheckedRead check_;
      std::string words_;
    };

    /**
     * Declares an entry whose text is read by @p read (throws on a bad text) and stored by @p
     * store. For the default text @p default_value itself is stored, because the text may be
     * rounded.
     */
    template <typename Value, typename Read, typename Store>
    void declare(dealii::ParameterHandler &prm,
                 const std::string        &name,
                 const std::string        &default_text,
                 const Value              &default_value,
                 const Read               &read,
                 const Store              &store,
                 const std::string        &words,
                 const std::string        &description)
    {
      // Read twice: by the pattern, which may refuse the text, and by the action, which stores the
      // value.
      const auto check = [read](const std::string &text) { (void)read(text); };
      try
        {
          prm.declare_entry(name, default_text, ReasonedPattern(check, words), description);
        }
      catch (const InputError &error)
        {
          throw InputError("default " + default_text + " of \"" + name + "\": " + error.what());
        }
      // Called at once with the default, and again whenever the entry is set.
      prm.add_action(name, [read, store, default_text, default_value](const std::string &text) {
        store(text == default_text ? default_value : read(text));
      });
    }

    /** How patterns of declare_quantity() begin. */
    const std::string number_words = "a number";

    /** How those of whole numbers begin. */
    const std::string whole_number_words = "a whole number";

    /**
     * As a message ends with it: "positive", "at least 2", "between 0 and 1"; "" without a limit.
     */
    std::string range_words(const Range &range)
    {
      if (!range.zero_word.empty())
        {
          Range numbers     = range;
          numbers.zero_word = "";
          numbers.open_below |= range.lowest == 0.;
          const std::string words = range_words(numbers);
          return words + (words.empty() ? "or \"" : ", or \"") + range.zero_word + "\"";
        }
      const bool        below = std::isfinite(range.lowest), above = std::isfinite(range.highest);
      const std::string low = number_text(range.lowest), high = number_text(range.highest);
      if (below && above)
        return range.open_below ? "above " + low + " and at most " + high
                                : "between " + low + " and " + high;
      if (below && range.lowest == 0.)
        return range.open_below ? "positive" : "not negative";
      if (below)
        return (range.open_below ? "above " : "at least ") + low;
      return above ? "at most " + high : "";
    }

    /** Throws unless the quantity is in @p range, which is stated in @p unit. */
    void check_range(const Quantity &quantity, const Unit &unit, const Range &range)
    {
      const double number = quantity.in(unit);
      // a converted number may miss the limit it means by its round-off
      const auto slack = [&](const double limit) {
        return quantity.unit == &unit ? 0. : 1e-14 * std::abs(limit);
      };
      const bool low = range.open_below ? number <= range.lowest + slack(range.lowest)
                                        : number < range.lowest - slack(range.lowest);
      if (low || number > range.highest + slack(range.highest))
        {
          const std::string words    = range_words(range);
          const bool        negation = words.compare(0, 4, "not ") == 0;
          throw InputError("must " + (negation ? "not be " + words.substr(4) : "be " + words) +
                           " [" + unit.name + "]" + (range.hint.empty() ? "" : "; " + range.hint));
        }
    }

    /** "meaning (words) [unit]" */
    std::string
    description_of(const std::string &meaning, const std::string &words, const std::string &unit)
    {
      return meaning + (words.empty() ? "" : " (" + words + ")") +
             (unit.empty() ? "" : " [" + unit + "]");
    }

    /** The three parts between two commas. */
    std::vector<std::string> split_three(const std::string &text)
    {
      const std::vector<std::string> parts = split_at_commas(text);
      if (parts.size() != 3)
        throw InputError("must be three numbers separated by commas; the decimal sign is a point");
      // Of "9,000, 0 N", which has a number too few.
      for (const std::string &part : parts)
        if (part.size() > 1 && part[0] == '0' && part[1] >= '0' && part[1] <= '9')
          throw InputError(
            "\"" + part +
            "\" begins with a zero. Write a decimal point and no separator of thousands");
      return parts;
    }

    /** The names of "a, b, c". Throws InputError for empty and repeated ones. */
    std::vector<std::string> split_names(const std::string &text)
    {
      std::vector<std::string> names;
      if (trimmed(text).empty())
        return names;
      // Also a comma at the end has a name missing behind it.
      for (const std::string &name : split_at_commas(text))
        {
          if (name.empty())
            throw InputError("empty name in the list");
          if (std::find(names.begin(), names.end(), name) != names.end())
            throw InputError("duplicate name \"" + name + "\"");
          names.push_back(name);
        }
      return names;
    }
  } // namespace

  Subsection::Subsection(dealii::ParameterHandler &prm, const std::string &name)
    : prm_(prm)
  {
    prm_.enter_subsection(name);
  }

  Subsection::~Subsection()
  {
    prm_.leave_subsection();
  }

  double
  read_quantity_in_range(const std::string &text, const std::string &unit, const Range &range)
  {
    if (!range.zero_word.empty() && text == range.zero_word)
      return 0.;
    const Unit    &bare     = find_unit(unit);
    const Quantity quantity = read_quantity(text, bare.name);
    if (quantity.internal() != 0. || range.zero_word.empty())
      check_range(quantity, bare, range);
    return quantity.internal();
  }

  std::string text_in_force(const std::string &pattern, const std::string &text)
  {
    const std::string open_word = "or \"";
    const std::size_t place     = pattern.find(open_word);
    char             *rest      = nullptr;
    if (place == std::string::npos || pattern.compare(0, number_words.size(), number_words) != 0 ||
        std::strtod(text.c_str(), &rest) != 0. || rest == text.c_str())
      return text;
    const std::size_t begin = place + open_word.size();
    return pattern.substr(begin, pattern.find('"', begin) - begin);
  }

  bool is_whole_number(const std::string &pattern)
  {
    return pattern.compare(0, whole_number_words.size(), whole_number_words) == 0;
  }

  std::string
  describe_quantity(const std::string &meaning, const std::string &unit, const Range &range)
  {
    return description_of(meaning, range_words(range), unit);
  }

  void declare_quantity(dealii::ParameterHandler &prm,
                        const std::string        &name,
                        double                   &value,
                        const std::string        &unit,
                        const std::string        &meaning,
                        const Range              &range)
  {
    // A bare number is in the unit of the description, whatever the units inside; what is stored is
    // in these.
    const auto read = [unit, range](const std::string &text) {
      return read_quantity_in_range(text, unit, range);
    };
    const std::string words = range_words(range);
    declare(
      prm,
      name,
      value == 0. && !range.zero_word.empty() ? range.zero_word : quantity_text(value, unit),
      value,
      read,
      [&value](const double number) { value = number; },
      number_words + (words.empty() ? "" : ", " + words) + " [" + unit + "]",
      describe_quantity(meaning, unit, range));
  }

  void declare_vector(dealii::ParameterHandler &prm,
                      const std::string        &name,
                      Vector3                  &value,
                      const std::string        &unit,
                      const std::string        &meaning)
  {
    const Unit &bare = find_unit(unit);
    const auto  read = [&bare](const std::string &text) {
      // "0, 0, 5 m": the unit behind the last number is also that of bare numbers before it.
      const auto     parts = split_three(text);
      const Quantity last  = read_quantity(parts[2], bare.name);
      Vector3        numbers;
      numbers[2] = last.internal();
      for (unsigned int c = 0; c < 2; ++c)
        numbers[c] = parse_quantity(parts[c], last.unit->name);
      return numbers;
    };
    const auto text = [&](const unsigned int c) { return quantity_text(value[c], unit); };
    declare(
      prm,
      name,
      text(0) + ", " + text(1) + ", " + text(2),
      value,
      read,
      [&value](const Vector3 &numbers) { value = numbers; },
      "three numbers [" + unit + "]",
      description_of(meaning, "three numbers", unit));
  }

  void declare_number(dealii::ParameterHandler &prm,
                      const std::string        &name,
                      double                   &value,
                      const std::string        &meaning,
                      const Range              &range)
  {
    declare_quantity(prm, name, value, "-", meaning, range);
  }

  void declare_integer(dealii::ParameterHandler &prm,
                       const std::string        &name,
                       unsigned int             &value,
                       const std::string        &meaning,
                       const unsigned int        lowest,
                       const unsigned int        highest)
  {
    // The largest int stands for no limit, and is not shown.
    const bool unlimited = highest == static_cast<unsigned int>(std::numeric_limits<int>::max());
    const std::string words =
      unlimited ? (lowest == 0 ? "" : "at least " + std::to_string(lowest))
                : "between " + std::to_string(lowest) + " and " + std::to_string(highest);
    const auto read = [lowest, highest, words](const std::string &text) {
      std::string  rest;
      const double number = read_number(text, rest);
      // 1e6 is a whole number too
      if (!rest.empty() || number != std::floor(number))
        throw InputError("must be a whole number");
      if (number < lowest || number > highest)
        throw InputError("must be " +
                         (words.empty() ? "a whole number from 0 to 2147483647" : words));
      return static_cast<unsigned int>(number);
    };
    declare(
      prm,
      name,
      std::to_string(value),
      value,
      read,
      [&value](const unsigned int number) { value = number; },
      whole_number_words + (words.empty() ? "" : ", " + words),
      description_of(meaning, words, "-"));
  }

  void declare_number_or_word(dealii::ParameterHandler &prm,
                              const std::string        &name,
                              NumberOrWord             &value,
                              const std::string        &word,
                              const std::string        &meaning,
                              const unsigned int        lowest,
                              const unsigned int        highest)
  {
    const std::string range =
      "between " + std::to_string(lowest) + " and " + std::to_string(highest);
    const auto read = [=, number = value.number](const std::string &text) {
      if (text == word)
        return NumberOrWord{number, true};
      const std::optional<double> found = plain_number(text);
      if (!found || *found != std::floor(*found))
        throw InputError("must be a whole number, or \"" + word + "\"");
      if (*found < lowest || *found > highest)
        throw InputError("must be " + range);
      return NumberOrWord{static_cast<unsigned int>(*found), false};
    };
    declare(
      prm,
      name,
      value.is_word ? word : std::to_string(value.number),
      value,
      read,
      [&value](const NumberOrWord &given) { value = given; },
      whole_number_words + ", " + range + ", or \"" + word + "\"",
      description_of(meaning, range + ", or \"" + word + "\"", "-"));
  }

  void declare_switch(dealii::ParameterHandler &prm,
                      const std::string        &name,
                      bool                     &value,
                      const std::string        &meaning)
  {
    const auto read = [](const std::string &text) {
      if (text == "yes" || text == "true" || text == "on")
        return true;
      if (text == "no" || text == "false" || text == "off")
        return false;
      throw InputError("must be yes or no");
    };
    declare(
      prm,
      name,
      value ? "yes" : "no",
      value,
      read,
      [&value](const bool answer) { value = answer; },
      "yes or no",
      description_of(meaning, "yes, no", ""));
  }

  void declare_text(dealii::ParameterHandler &prm,
                    const std::string        &name,
                    std::string              &value,
                    const std::string        &meaning)
  {
    declare(
      prm,
      name,
      value,
      value,
      [](const std::string &text) { return text; },
      [&value](const std::string &text) { value = text; },
      "text",
      meaning);
  }

  void declare_names(dealii::ParameterHandler &prm,
                     const std::string        &name,
                     std::vector<std::string> &value,
                     const std::string        &meaning)
  {
    declare(
      prm,
      name,
      list_of(value),
      value,
      split_names,
      [&value](const std::vector<std::string> &names) { value = names; },
      "names separated by commas",
      description_of(meaning, "names separated by commas", ""));
  }

  void declare_choice(dealii::ParameterHandler            &prm,
                      const std::string                   &name,
                      const std::vector<std::string>      &words,
                      const std::string                   &default_word,
                      const std::function<void(unsigned)> &select,
                      const std::string                   &meaning)
  {
    const auto read = [words](const std::string &text) {
      const auto word = std::find(words.begin(), words.end(), text);
      if (word == words.end())
        throw InputError("must be one of " + list_of(words, true) + did_you_mean(text, words));
      return static_cast<unsigned>(word - words.begin());
    };
    declare(prm,
            name,
            default_word,
            read(default_word),
            read,
            select,
            "one of " + list_of(words, true),
            description_of(meaning, list_of(words), ""));
  }
} // namespace vfife
