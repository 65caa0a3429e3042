// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "base/result.h"

namespace dorsum::accuracy {

// Puts texts in the places {{NAME}} of a template. A place without a text is an error.
Result<std::string> FillTemplate(const std::string& text, const std::map<std::string, std::string>& places);

// docs/accuracy.md: bench/accuracy/accuracy.md.in filled with what is recorded under bench/accuracy/results.
// `bench` is the folder of the template.
Result<std::string> MakeDocument(const std::filesystem::path& bench);

}  // namespace dorsum::accuracy
