// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#define VFIFE_SIMD_NAMESPACE generic
#define VFIFE_KERNEL_WIDTH 1
#define VFIFE_INSTRUCTION_SET_TEXT "generic"
#include "kernels.inl"
