// SPDX-License-Identifier: Apache-2.0
#pragma once

// What every file has in common that is compiled for several instruction sets (Highway). To be included
// before Highway, once for each of them. Sets that hardly gain over a smaller one are left out, and so are
// those whose vectors have no fixed size and cannot be members or elements.
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
