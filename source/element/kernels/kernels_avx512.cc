// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#define VFIFE_SIMD_NAMESPACE avx512
#define VFIFE_KERNEL_WIDTH 8
#define VFIFE_INSTRUCTION_SET_TEXT "avx512"
#include "kernels.inl"
