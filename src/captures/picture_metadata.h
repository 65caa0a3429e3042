// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace dorsum {

// The same PNG or JPEG with nothing but what its pixels need: no text, times, places, camera names, previews
// or profiles, and nothing behind its end. Of a PNG (W3C PNG §11) the critical chunks stay, of a JPEG (ITU-T
// T.81 annex B) the tables, frames and scans, and of the application segments the two that a decoder needs to
// know its colours (JFIF, Adobe), cut to their fixed parts. The compressed pixels are not touched. The error
// is a phrase without the file's name, for the caller to complete.
Result<std::string> WithoutMetadata(std::string_view bytes);

}  // namespace dorsum
