// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/element/kernels/kernels.h>

#include <cstdlib>

namespace vfife
{
  namespace generic
  {
    extern const ElementKernels element_kernels[n_frame_kinds];
  }
#ifdef __x86_64__
  namespace sse2
  {
    extern const ElementKernels element_kernels[n_frame_kinds];
  }
  namespace avx2
  {
    extern const ElementKernels element_kernels[n_frame_kinds];
  }
  namespace avx512
  {
    extern const ElementKernels element_kernels[n_frame_kinds];
  }
#endif

  namespace
  {
    constexpr InstructionSet instruction_sets[] = {InstructionSet::avx512,
                                                   InstructionSet::avx2,
                                                   InstructionSet::sse2,
                                                   InstructionSet::generic};

    /** First of the kernels of a set, by frame; nullptr when this program has none. */
    const ElementKernels *kernels_of(const InstructionSet instruction_set)
    {
      switch (instruction_set)
        {
#ifdef __x86_64__
        case InstructionSet::sse2:
          return sse2::element_kernels;
        case InstructionSet::avx2:
          return avx2::element_kernels;
        case InstructionSet::avx512:
          return avx512::element_kernels;
#endif
        case InstructionSet::generic:
          return generic::element_kernels;
        default:
          return nullptr;
        }
    }

    bool processor_runs(const InstructionSet instruction_set)
    {
#ifdef __x86_64__
      // What -march=haswell and -march=skylake-avx512 let the compiler use in these loops.
      const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                        __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
      if (instruction_set == InstructionSet::avx2)
        return avx2;
      if (instruction_set == InstructionSet::avx512)
        return avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
               __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
               __builtin_cpu_supports("avx512cd");
#endif
      return kernels_of(instruction_set) != nullptr;
    }
  } // namespace

  const char *name_of(const InstructionSet instruction_set)
  {
    switch (instruction_set)
      {
      case InstructionSet::sse2:
        return "sse2";
      case InstructionSet::avx2:
        return "avx2";
      case InstructionSet::avx512:
        return "avx512";
      default:
        return "generic";
      }
  }

  bool is_available(const InstructionSet instruction_set)
  {
    return kernels_of(instruction_set) != nullptr && processor_runs(instruction_set);
  }

  InstructionSet best_instruction_set()
  {
    const char *const wanted = std::getenv("VFIFE_INSTRUCTION_SET");
    for (const InstructionSet instruction_set : instruction_sets)
      // Without a wish the fastest set is taken: the list runs from fast to slow.
      if (wanted == nullptr || *wanted == '\0')
        {
          if (is_available(instruction_set))
            return instruction_set;
        }
      else if (std::string(wanted) == name_of(instruction_set))
        {
          if (!is_available(instruction_set))
            throw InputError("The environment variable VFIFE_INSTRUCTION_SET: expected an "
                             "instruction set of this processor, got " +
                             std::string(wanted) + ".");
          return instruction_set;
        }
    if (wanted != nullptr && *wanted != '\0')
      throw InputError("The environment variable VFIFE_INSTRUCTION_SET: expected generic, sse2, "
                       "avx2 or avx512, got '" +
                       std::string(wanted) + "'.");
    return InstructionSet::generic;
  }

  const ElementKernels &select_kernels(const FrameKind frame, const InstructionSet instruction_set)
  {
    if (!is_available(instruction_set))
      throw InputError("This processor does not have the instruction set " +
                       std::string(name_of(instruction_set)) + " of the element kernels.");
    return kernels_of(instruction_set)[static_cast<unsigned int>(frame)];
  }
} // namespace vfife
