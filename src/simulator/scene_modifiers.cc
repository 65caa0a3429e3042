// SPDX-License-Identifier: Apache-2.0
#include "simulator/scene_modifiers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

#include "captures/names.h"

namespace dorsum {
namespace {

using Number = ModifierRule::Number;

constexpr double kLastLaser = kMaxLasers - 1;
constexpr auto kRules = std::to_array<ModifierRule>({
    {Modifier::kRing, "ring", Number::kNone, 0, 0, 0, true, "a polished metal band on the ring finger"},
    {Modifier::kSleeve, "sleeve", Number::kNone, 0, 0, 0, true, "a folded cloth cuff over the wrist"},
    {Modifier::kDark, "dark", Number::kNone, 0, 0, 0, true, "dark skin: 0.28 times as bright"},
    {Modifier::kLight, "light", Number::kNone, 0, 0, 0, true, "light skin: 1.25 times as bright"},
    {Modifier::kWet, "wet", Number::kNone, 0, 0, 0, true, "patches of wet skin that shine under all lights"},
    {Modifier::kHair, "hair", Number::kNone, 0, 0, 0, true, "thin dark hairs"},
    {Modifier::kNails, "nails", Number::kNone, 0, 0, 0, true, "varnished nails: bright and glossy"},
    {Modifier::kHigh, "high", Number::kOptional, 60, 1, 200, false, "raised by so many mm"},
    {Modifier::kSide, "side", Number::kOptional, 80, -200, 200, false, "shifted along y by so many mm"},
    {Modifier::kMoved, "moved", Number::kOptional, 2, 0.1, 20, false,
     "shifted by so many mm after the first half of the lasers"},
    {Modifier::kAfter, "after", Number::kNone, 0, 0, 0, false,
     "also bgHandAfter, a last view under the LEDs"},
    {Modifier::kAmbient, "ambient", Number::kOptional, 10, 0, 50, false, "so many times the daylight"},
    {Modifier::kOff, "off", Number::kLaser, 0, 0, kLastLaser, false, "this laser stays dark"},
    {Modifier::kDim, "dim", Number::kLaser, 0, 0, kLastLaser, false, "this laser has 30 % of its power"},
    {Modifier::kDust, "dust", Number::kLaser, 0, 0, kLastLaser, false,
     "a dirty spot on this laser's grating: all its stripes dim over a few degrees"},
    {Modifier::kKnocked, "knocked", Number::kOptional, 0.2, 0.01, 5, false,
     "the camera turned by so many degrees since the calibration"},
});

std::string KnownWords() {
  std::string words;
  for (const ModifierRule& rule : kRules) {
    words += (words.empty() ? "+" : ", +") + std::string(rule.word);
    if (rule.number == Number::kLaser) words += "K";
  }
  return words;
}

Result<SceneModifier> ParseModifier(std::string_view text, bool is_hand) {
  const auto end_of_word = std::find_if(text.begin(), text.end(), [](char c) { return c < 'a' || c > 'z'; });
  const std::string_view word(text.begin(), end_of_word), rest(end_of_word, text.end());
  const auto* rule =
      std::find_if(kRules.begin(), kRules.end(), [&](const ModifierRule& r) { return r.word == word; });
  const std::string shown = "+" + std::string(text);
  if (rule == kRules.end()) {
    return UsageError("there is no \"" + shown + "\" for a scene; known are " + KnownWords());
  }
  if (rule->hands_only && !is_hand) return UsageError("\"" + shown + "\" needs a hand: hand:…" + shown);
  SceneModifier modifier{rule->kind, rule->preset};
  if (rest.empty() && rule->number != Number::kLaser) return modifier;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), modifier.value);
  const bool whole = rule->number != Number::kLaser || (rest.size() == 1 && rest[0] >= '0' && rest[0] <= '9');
  const bool fits = error == std::errc() && end == rest.data() + rest.size() && whole &&
                    rule->number != Number::kNone && modifier.value >= rule->min &&
                    modifier.value <= rule->max;
  if (fits) return modifier;
  std::ostringstream wanted;
  if (rule->number == Number::kNone) wanted << "no number";
  if (rule->number == Number::kOptional) wanted << "a number from " << rule->min << " to " << rule->max;
  if (rule->number == Number::kLaser) wanted << "a laser's number, 0 to " << rule->max;
  return UsageError("\"" + shown + "\" does not fit: +" + std::string(word) + " takes " + wanted.str());
}

}  // namespace

std::span<const ModifierRule> ModifierRules() { return kRules; }

const ModifierRule& RuleOf(Modifier kind) {
  return *std::find_if(kRules.begin(), kRules.end(), [kind](const auto& rule) { return rule.kind == kind; });
}

Result<SceneModifiers> ParseModifiers(const std::string& text, bool is_hand) {
  SceneModifiers modifiers;
  std::istringstream words(text + "+");
  for (std::string word; std::getline(words, word, '+');) {
    DORSUM_ASSIGN_OR_RETURN(const SceneModifier modifier, ParseModifier(word, is_hand));
    const bool per_laser = RuleOf(modifier.kind).number == Number::kLaser;
    for (const SceneModifier& other : modifiers) {
      if (other.kind == modifier.kind && (!per_laser || other.value == modifier.value)) {
        return UsageError("\"+" + word + "\" is asked for twice");
      }
    }
    modifiers.push_back(modifier);
  }
  if (Has(modifiers, Modifier::kDark) && Has(modifiers, Modifier::kLight)) {
    return UsageError("skin is \"+dark\" or \"+light\", not both");
  }
  return modifiers;
}

std::optional<double> Find(const SceneModifiers& modifiers, Modifier kind) {
  for (const SceneModifier& modifier : modifiers) {
    if (modifier.kind == kind) return modifier.value;
  }
  return std::nullopt;
}

std::string ModifierHelp() {
  std::ostringstream out;
  for (const ModifierRule& rule : kRules) {
    std::ostringstream name;
    name << "+" << rule.word;
    if (rule.number == Number::kLaser) name << "K";
    if (rule.number == Number::kOptional) name << "[" << rule.preset << "]";
    out << "  " << name.str() << std::string(name.str().size() < 16 ? 16 - name.str().size() : 1, ' ')
        << rule.meaning << (rule.hands_only ? " (hands only)" : "") << "\n";
  }
  return out.str();
}

}  // namespace dorsum
