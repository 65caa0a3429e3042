// SPDX-License-Identifier: Apache-2.0
#include "simulator/scene_modifiers.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simulator/named_scene.h"

namespace dorsum {
namespace {

using ::testing::HasSubstr;

TEST(SceneModifiers, TakeTheirNumberOrTheirPreset) {
  const auto modifiers = ParseModifiers("ring+moved1.5+knocked+off0+off2", true);
  ASSERT_TRUE(modifiers.ok()) << modifiers.error().message;
  ASSERT_EQ(modifiers->size(), 5U);
  EXPECT_TRUE(Has(*modifiers, Modifier::kRing));
  EXPECT_FALSE(Has(*modifiers, Modifier::kSleeve));
  EXPECT_EQ(Find(*modifiers, Modifier::kMoved), 1.5);
  EXPECT_EQ(Find(*modifiers, Modifier::kKnocked), 0.2);
  EXPECT_EQ((*modifiers)[4].value, 2.0);
}

TEST(SceneModifiers, RefuseWhatDoesNotFit) {
  for (const char* text : {"", "rings", "ring1", "moved-1", "moved0", "movednan", "moved1mm", "off", "off8",
                           "off1.5", "off-1", "ring+ring", "off1+off1", "dark+light", "ring++dark", "Ring"}) {
    const auto result = ParseModifiers(text, true);
    ASSERT_FALSE(result.ok()) << text;
    EXPECT_EQ(result.error().code, ErrorCode::kUsage);
    EXPECT_EQ(result.error().message.find('\n'), std::string::npos);
  }
  EXPECT_THAT(ParseModifiers("ring", false).error().message, HasSubstr("needs a hand"));
  EXPECT_THAT(ParseModifiers("bling", true).error().message, HasSubstr("+dustK"));
  EXPECT_THAT(ParseModifiers("moved99", true).error().message, HasSubstr("0.1 to 20"));
}

TEST(SceneModifiers, HelpNamesEachOfThemOnce) {
  const std::string help = ModifierHelp();
  for (const ModifierRule& rule : ModifierRules()) {
    const std::string entry = "  +" + std::string(rule.word);
    EXPECT_NE(help.find(entry), std::string::npos) << rule.word;
    EXPECT_EQ(&RuleOf(rule.kind), &rule);
  }
}

TEST(SceneModifiers, StandBetweenSceneAndRepeatAndChangeNoShape) {
  const auto name = ParseSceneName("hand:man:left:joe:k1+sleeve+side-40_r2");
  ASSERT_TRUE(name.ok()) << name.error().message;
  EXPECT_EQ(name->geometry, "hand:man:left:joe:k1");
  EXPECT_EQ(name->folder, "hand_man_left_joe_k1+sleeve+side-40_r2");
  EXPECT_EQ(name->visit, 1);
  EXPECT_EQ(Find(name->modifiers, Modifier::kSide), -40.0);
  EXPECT_TRUE(ParseSceneName("whitebox20+dim1").ok());
  EXPECT_FALSE(ParseSceneName("whitebox20+dark").ok());
  EXPECT_FALSE(ParseSceneName("box20+").ok());
}

}  // namespace
}  // namespace dorsum
