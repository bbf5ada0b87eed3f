// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_run_observers_h
#define vfife_study_run_run_observers_h

#include <vfife/model/observer.h>

#include <memory>
#include <utility>

namespace vfife
{
  class OutputFolder;

  /** What looks at a run and writes into its folder. */
  class RunObservers
  {
  public:
    /** The folder must outlive the object. */
    explicit RunObservers(const OutputFolder &folder)
      : folder_(folder)
    {
    }

    /** Adds an observer, made of the folder and the arguments. */
    template <typename Writer, typename... Arguments>
    const Writer &add(Arguments &&...arguments)
    {
      list_.push_back(std::make_unique<Writer>(folder_, std::forward<Arguments>(arguments)...));
      return static_cast<const Writer &>(*list_.back());
    }

    Observers &list()
    {
      return list_;
    }

  private:
    const OutputFolder &folder_;
    Observers           list_;
  };
} // namespace vfife

#endif
