// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <filesystem>
#include <memory>

namespace vfife
{
  namespace
  {
    namespace fs = std::filesystem;

    // What tells these entries from free text, shown to the user as what is allowed.
    const char *const file_words    = "the name of a file";
    const char *const formula_words = "a formula or the name of a file (.csv, .txt)";
    const char *const quantity_words =
      "a quantity, a formula of t or the name of a file (.csv, .txt)";

    /** Any text; its description is what the entry is known by. */
    class NamedPattern : public dealii::Patterns::PatternBase
    {
    public:
      using Check = std::function<void(const std::string &)>;

      explicit NamedPattern(const char *words, const Check &check = {})
        : words_(words)
        , check_(check)
      {
      }
      bool match(const std::string &text) const override
      {
        if (check_)
          check_(text);
        return true;
      }
      std::string description(const OutputStyle = Machine) const override
      {
        return words_;
      }
      std::unique_ptr<PatternBase> clone() const override
      {
        return std::make_unique<NamedPattern>(*this);
      }

    private:
      const char *words_;
      Check       check_; ///< throws the reason of a refusal
    };

    void declare(dealii::ParameterHandler &prm,
                 const std::string        &name,
                 std::string              &value,
                 const std::string        &meaning,
                 const char               *words)
    {
      prm.declare_entry(name, value, NamedPattern(words), meaning);
      prm.add_action(name, [&value](const std::string &text) { value = text; });
    }

    /** Sets all names of files below @p section to what @p make makes of them. */
    template <typename Make>
    void
    set_file_names(const DeclaredSection &section, const Make &make, dealii::ParameterHandler &prm)
    {
      for (const DeclaredSection::Entry &entry : section.entries)
        if (names_a_file(entry.pattern, entry.value))
          prm.set(entry.name, make(entry.value));
      for (const DeclaredSection &inner : section.sections)
        {
          const Subsection inside(prm, inner.name);
          set_file_names(inner, make, prm);
        }
    }
    void add_missing_files(const DeclaredSection   &section,
                           const std::string       &path,
                           std::vector<InputError> &missing)
    {
      for (const DeclaredSection::Entry &entry : section.entries)
        if (names_a_file(entry.pattern, entry.value) && !is_there(entry.value))
          missing.emplace_back(path + entry.name, "file \"" + entry.value + "\" does not exist");
      for (const DeclaredSection &inner : section.sections)
        add_missing_files(inner, path + inner.name + "/", missing);
    }
  } // namespace

  void declare_file_name(dealii::ParameterHandler &prm,
                         const std::string        &name,
                         std::string              &value,
                         const std::string        &meaning)
  {
    declare(prm, name, value, meaning, file_words);
  }

  bool names_a_table(const std::string &text)
  {
    const std::string end = fs::path(text).extension().string();
    return end == ".csv" || end == ".txt";
  }

  void declare_formula_or_table(dealii::ParameterHandler &prm,
                                const std::string        &name,
                                std::string              &value,
                                const std::string        &meaning)
  {
    declare(prm, name, value, meaning, formula_words);
  }

  void declare_quantity_or_table(dealii::ParameterHandler                       &prm,
                                 const std::string                              &name,
                                 const std::string                              &default_text,
                                 const std::function<void(const std::string &)> &check,
                                 const std::function<void(const std::string &)> &store,
                                 const std::string                              &meaning)
  {
    prm.declare_entry(name, default_text, NamedPattern(quantity_words, check), meaning);
    prm.add_action(name, store);
  }

  bool names_a_file(const std::string &pattern, const std::string &text)
  {
    return (pattern == file_words && !text.empty()) ||
           ((pattern == formula_words || pattern == quantity_words) && names_a_table(text));
  }

  bool is_there(const std::string &path)
  {
    std::error_code error;
    return fs::exists(path, error);
  }

  std::string find_beside(const std::string &folder, const std::string &name)
  {
    // An absolute name stays as it is.
    const fs::path  beside = (fs::path(folder) / name).lexically_normal();
    std::error_code error;
    return fs::exists(beside, error) || !fs::exists(name, error) ? beside.string() : name;
  }

  void check_files(const dealii::ParameterHandler &prm)
  {
    std::vector<InputError> missing;
    add_missing_files(find_declared(prm), "", missing);
    if (missing.size() == 1)
      throw missing[0];
    if (!missing.empty())
      throw InputErrors(missing);
  }

  AbsoluteFileNames::AbsoluteFileNames(dealii::ParameterHandler &prm)
    : prm_(prm)
    , before_(find_declared(prm))
  {
    const auto absolute = [](const std::string &name) {
      return fs::absolute(name).lexically_normal().string();
    };
    set_file_names(before_, absolute, prm_);
  }

  AbsoluteFileNames::~AbsoluteFileNames()
  {
    const auto same = [](const std::string &name) { return name; };
    set_file_names(before_, same, prm_);
  }
} // namespace vfife
