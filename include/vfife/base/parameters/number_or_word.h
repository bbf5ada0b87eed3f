// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_number_or_word_h
#define vfife_base_parameters_number_or_word_h

#include <vfife/base/parameter_handler.h>

#include <string>

namespace vfife
{
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
} // namespace vfife

#endif
