// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace dorsum {

// English texts of the libraries that library_words.h knows. %1 … %9, in this order, stand for values, or for
// texts that are known themselves. In a name of at most three words, such as "laser %1", a value is one word.
std::span<const char* const> LibraryTextsOfUse();         // instructions, verdicts, findings, option help
std::span<const char* const> LibraryErrorsOfFiles();      // files, folders, their contents, surfaces
std::span<const char* const> LibraryErrorsOfDevices();    // cameras, the light controller
std::span<const char* const> LibraryErrorsOfCaptures();   // captures, calibrations, their images
std::span<const char* const> LibraryErrorsOfCampaigns();  // campaigns, and what is found in them

}  // namespace dorsum
