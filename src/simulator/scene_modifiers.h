// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace dorsum {

// What can go wrong, or be unusual, in a capture. Asked for behind a scene's name, each with a plus sign:
//   hand:man:right:anna+ring+dark, box25.5+dim1, hand:woman:left:eve+moved2+after
// kModifierRules says what each does, which number may follow and what it is without one.
enum class Modifier {
  kRing,
  kSleeve,
  kDark,
  kLight,
  kWet,
  kHair,
  kNails,
  kHigh,
  kSide,
  kMoved,
  kAfter,
  kAmbient,
  kOff,
  kDim,
  kDust,
  kKnocked,
};

struct ModifierRule {
  enum class Number { kNone, kOptional, kLaser };  // what may follow the word; a laser's number must
  Modifier kind;
  std::string_view word;
  Number number = Number::kNone;
  double preset = 0.0, min = 0.0, max = 0.0;
  bool hands_only = false;
  std::string_view meaning;
};
std::span<const ModifierRule> ModifierRules();
const ModifierRule& RuleOf(Modifier kind);

struct SceneModifier {
  Modifier kind = Modifier::kRing;
  double value = 0.0;  // the number behind the word, or its preset
};
using SceneModifiers = std::vector<SceneModifier>;

// The words between the plus signs of "ring+moved2". Each at most once per number.
Result<SceneModifiers> ParseModifiers(const std::string& text, bool is_hand);

// The value of a modifier that may stand once.
std::optional<double> Find(const SceneModifiers& modifiers, Modifier kind);
inline bool Has(const SceneModifiers& modifiers, Modifier kind) { return Find(modifiers, kind).has_value(); }

// One line for each rule, for --help.
std::string ModifierHelp();

}  // namespace dorsum
