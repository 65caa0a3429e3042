// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace dorsum {

enum class Grade { kGood, kDoubtful, kBad };

inline const char* GradeName(Grade g) {
  return g == Grade::kGood ? "good" : g == Grade::kDoubtful ? "doubtful" : "bad";
}

struct Figure {
  std::string name;
  double value = 0.0;
  std::string unit;  // "mm", "px", "" for counts
};

// What one part of a calibration says of itself: its figures, and in words whether they can be trusted.
struct PartReport {
  std::string part;  // "camera", "laser 2", "correction"
  Grade grade = Grade::kGood;
  std::string verdict;  // one sentence
  std::vector<Figure> figures;
};

}  // namespace dorsum
