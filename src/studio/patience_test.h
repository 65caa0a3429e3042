// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace dorsum {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;  // and so slow that times mean nothing
#else
inline constexpr bool kSanitized = false;
#endif

// How long a test waits for what is to come. Only one that fails waits to the end.
inline constexpr int kPatience_ms = kSanitized ? 900000 : 120000;

}  // namespace dorsum
