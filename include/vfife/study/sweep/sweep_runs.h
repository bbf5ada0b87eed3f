// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_sweep_sweep_runs_h
#define vfife_study_sweep_sweep_runs_h

#include <vfife/base/parameter_handler.h>
#include <vfife/study/sweep/error_bars.h>

#include <cstddef>
#include <string>
#include <vector>

namespace vfife
{
  struct CaseFile;

  /** One entry of a case, or several that change together, and the values that a sweep gives them,
   * as texts. */
  struct SweepParameter
  {
    std::string name, entry, values, sizes;

    void declare(dealii::ParameterHandler &prm);

    std::vector<std::string> list_entries() const;
    std::vector<std::string> list_values() const;
    /** What each of the entries is set to. */
    std::vector<std::string> list_parts(const std::string &value) const;
    /** Those that are stated; nothing where they are to be derived. */
    std::vector<double> list_sizes() const;

  private:
    /** Throws InputError, see check_list_commas(). */
    void check_commas(const char *list, const std::string &text) const;
  };

  /** Which runs a sweep has: every combination of the values of its physical parameters, and beside
   * each those that differ from it in one numerical parameter. */
  struct SweepRuns
  {
    /** One run: the values of all parameters. */
    using Values = std::vector<std::string>;

    enum class Combination
    {
      list,   ///< first values together, second values together...
      product ///< each with each; the last parameter changes fastest
    };

    std::vector<std::string>    names;     ///< of the parameters
    std::vector<std::string>    numerical; ///< those of them that are numerical
    std::vector<SweepParameter> parameters;
    Combination                 combination = Combination::product;

    /** Throws InputError. */
    void check() const;
    /** Throws InputError for numerical parameters that do not go from coarse to fine: whole numbers
     * that fall, sizes of elements and factors of the time step that rise. Which way others go is
     * not known. @param file of any run */
    void check_order(const CaseFile &file) const;
    /** The first parameter that sets the entry, or nullptr. */
    const SweepParameter *find_parameter(const std::string &entry) const;

    /** Each combination after the runs that differ from it in one numerical parameter. */
    std::vector<Values> list() const;
    /** Of runs whose folders these are. */
    std::vector<SweepVariant> list_variants(const std::vector<std::string> &folders) const;

    /** "thickness = 5 mm, angle = 70 deg" */
    std::string describe(const Values &values) const;
    /** What a run sets: "Section/entry=value" of each entry. */
    std::vector<std::string> list_overrides(const Values &values) const;
    /** Path of the entry that makes a run's parameters wrong, by the message of that; empty where
     * it is none of the sweep's. */
    std::string find_cause(const std::string &message) const;

    /** "run_01": name of the run's folder in that of the sweep, from the number @p i from 0 on. */
    static std::string folder_of(std::size_t i);

  private:
    void check_numerical() const;
    /** Two runs that are the same. */
    void check_repetition() const;
    bool is_numerical(const SweepParameter &parameter) const;
    /** All combinations of the physical parameters, the numerical ones at their last values. */
    std::vector<Values> list_combinations() const;
  };
} // namespace vfife

#endif
