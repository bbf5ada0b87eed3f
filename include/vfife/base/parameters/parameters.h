// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_parameters_h
#define vfife_base_parameters_parameters_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/types.h>

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  /**
   * Enters a subsection for the life of the object.
   */
  class Subsection
  {
  public:
    Subsection(dealii::ParameterHandler &prm, const std::string &name);
    ~Subsection();
    Subsection(const Subsection &)            = delete;
    Subsection &operator=(const Subsection &) = delete;

  private:
    dealii::ParameterHandler &prm_;
  };

  /** Declares options that have a section of their own, which they do not name themselves. */
  template <typename Options>
  void declare_section(dealii::ParameterHandler &prm, const std::string &name, Options &options)
  {
    const Subsection section(prm, name);
    options.declare(prm);
  }

  /** What a number may be; the words appear in the message and in the description. */
  struct Range
  {
    double lowest     = -std::numeric_limits<double>::infinity();
    double highest    = std::numeric_limits<double>::infinity();
    bool   open_below = false; ///< lowest itself is not allowed

    std::string hint      = {}; ///< what to do instead; ends the message
    std::string zero_word = {}; ///< written and read for 0, which then means no number

    Range with_hint(const std::string &text) const
    {
      Range range = *this;
      range.hint  = text;
      return range;
    }

    /** The same with 0 as @p word: "auto" where the program finds the number, "not given"... Files
     * of earlier versions have 0. */
    Range or_word(const std::string &word) const
    {
      Range range     = *this;
      range.zero_word = word;
      return range;
    }

    static Range any()
    {
      return {};
    }
    static Range positive()
    {
      return {0., std::numeric_limits<double>::infinity(), true};
    }
    static Range not_negative()
    {
      return {0., std::numeric_limits<double>::infinity(), false};
    }
    static Range between(const double lowest, const double highest)
    {
      return {lowest, highest, false};
    }
  };

  /**
   * Declares a dimensioned entry bound to @p value. A bare number in the file is in @p unit; a
   * number with a unit of the same dimension is converted ("5 mm", "0.2 in" is not known, "20000
   * rpm", "70 deg", "800 N m").
   * @p value holds the default on entry and is always in *internal* units (mm, s, t, N, MPa, rad,
   * rad/s, N mm): a default of 70 deg is `70 * pi / 180`. The range is stated in @p unit. @p value
   * must outlive @p prm. The description shown to the user becomes "meaning [unit]".
   */
  void declare_quantity(dealii::ParameterHandler &prm,
                        const std::string        &name,
                        double                   &value,
                        const std::string        &unit,
                        const std::string        &meaning,
                        const Range              &range = Range::any());

  /** The number of a text as declare_quantity() reads it [internal units]. */
  double
  read_quantity_in_range(const std::string &text, const std::string &unit, const Range &range);

  /** A valid @p text of an entry of this @p pattern (DeclaredSection::Entry) as it is in force: 0,
   * which files of earlier versions have, is the word of Range::or_word(). */
  std::string text_in_force(const std::string &pattern, const std::string &text);

  /** Whether an entry of this @p pattern is a whole number (or a word instead of one). */
  bool is_whole_number(const std::string &pattern);

  /** What a description says of a unit and a range: "meaning (words) [unit]". */
  std::string
  describe_quantity(const std::string &meaning, const std::string &unit, const Range &range);

  /**
   * Declares three dimensioned numbers separated by commas, "0, 0, 5 m/s"; each is read as by
   * declare_quantity(), and a unit behind the last one is that of all that carry none. @p value is
   * in internal units.
   */
  void declare_vector(dealii::ParameterHandler &prm,
                      const std::string        &name,
                      Vector3                  &value,
                      const std::string        &unit,
                      const std::string        &meaning);

  /** Declares a dimensionless number. */
  void declare_number(dealii::ParameterHandler &prm,
                      const std::string        &name,
                      double                   &value,
                      const std::string        &meaning,
                      const Range              &range = Range::any());

  /** Declares a whole number in [lowest, highest]. */
  void declare_integer(dealii::ParameterHandler &prm,
                       const std::string        &name,
                       unsigned int             &value,
                       const std::string        &meaning,
                       unsigned int              lowest  = 0,
                       unsigned int              highest = std::numeric_limits<int>::max());

  /** A whole number, or a word in its place. */
  struct NumberOrWord
  {
    unsigned int number  = 0;     ///< kept where the word is given
    bool         is_word = false; ///< the word is given
  };

  /** Declares a whole number in [lowest, highest] or @p word; the default is that of @p value. */
  void declare_number_or_word(dealii::ParameterHandler &prm,
                              const std::string        &name,
                              NumberOrWord             &value,
                              const std::string        &word,
                              const std::string        &meaning,
                              unsigned int              lowest,
                              unsigned int              highest);

  /** Declares a yes/no entry (yes, no, true, false). */
  void declare_switch(dealii::ParameterHandler &prm,
                      const std::string        &name,
                      bool                     &value,
                      const std::string        &meaning);

  /** Declares free text. */
  void declare_text(dealii::ParameterHandler &prm,
                    const std::string        &name,
                    std::string              &value,
                    const std::string        &meaning);

  /** Declares a comma-separated list of names. */
  void declare_names(dealii::ParameterHandler &prm,
                     const std::string        &name,
                     std::vector<std::string> &value,
                     const std::string        &meaning);

  /** The words of a choice and what they stand for: one explicit table per family. */
  template <typename Enum>
  using Choices = std::vector<std::pair<std::string, Enum>>;

  /** Declares an entry whose words are those of a table; @p select is called with the row's index.
   */
  void declare_choice(dealii::ParameterHandler            &prm,
                      const std::string                   &name,
                      const std::vector<std::string>      &words,
                      const std::string                   &default_word,
                      const std::function<void(unsigned)> &select,
                      const std::string                   &meaning);

  template <typename Enum>
  void declare_choice(dealii::ParameterHandler &prm,
                      const std::string        &name,
                      Enum                     &value,
                      const Choices<Enum>      &choices,
                      const std::string        &meaning)
  {
    std::vector<std::string> words;
    std::string              default_word;
    for (const auto &choice : choices)
      {
        words.push_back(choice.first);
        if (choice.second == value)
          default_word = choice.first;
      }
    declare_choice(
      prm,
      name,
      words,
      default_word,
      [&value, choices](const unsigned i) { value = choices[i].second; },
      meaning);
  }

  /** The word that stands for @p value in a table of choices. */
  template <typename Enum>
  std::string word_of(const Enum value, const Choices<Enum> &choices)
  {
    for (const auto &choice : choices)
      if (choice.second == value)
        return choice.first;
    return "?";
  }
} // namespace vfife

#endif
