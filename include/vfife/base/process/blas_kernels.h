// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_process_blas_kernels_h
#define vfife_base_process_blas_kernels_h

namespace vfife
{
  /**
   * Sets the environment variable OPENBLAS_CORETYPE, which the user has not set, to the kernels for
   * this processor's instruction set, on Intel's processors. OpenBLAS chooses by the model's number
   * when it is loaded, and takes kernels without AVX for models that are newer than itself
   * (doc/developer/performance.md, Kernels of BLAS). Programs started afterwards have it.
   */
  void prefer_blas_kernels();
} // namespace vfife

#endif
