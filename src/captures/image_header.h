// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace dorsum {

// What an encoded image says of itself, read without decoding, so that a huge, truncated or grey image is
// refused before any memory is spent on it.
struct ImageHeader {
  std::string format;         // "PNG" or "JPEG"
  int width = 0, height = 0;  // px
  int channels = 0;           // 1 grey, 2 grey and alpha, 3 colour, 4 colour and alpha
  int bits = 0;               // per channel
  bool complete = false;      // the end marker is there
  bool intact = true;         // the checksums are right; a JPEG has none
};

// Reads PNG's IHDR (W3C PNG §11.2.2) or JPEG's frame header (ITU-T T.81 B.2.2). The error is a phrase
// without the file's name, for the caller to complete.
Result<ImageHeader> ReadImageHeader(std::string_view bytes);

}  // namespace dorsum
