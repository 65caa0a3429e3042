// SPDX-License-Identifier: Apache-2.0
#include "base/toml.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temp_folder_test.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(ReadTomlFile, ReadsTables) {
  const TempFolder folder;
  ASSERT_TRUE(WriteFile(folder / "a.toml", "[x]\ny = 2\n").ok());
  const auto table = ReadTomlFile(folder / "a.toml");
  ASSERT_TRUE(table.ok());
  EXPECT_EQ((*table)["x"]["y"].value<int>(), 2);
}

TEST(ReadTomlFile, AnErrorNamesTheLine) {
  const TempFolder folder;
  for (const char* text :
       {"a = 1\nb = 2\nc = = 3\n", "a = 1\nb = 2\na = 3\n", "a = 1\nb = 2\nc = '\xff'\n"}) {
    ASSERT_TRUE(WriteFile(folder / "a.toml", text).ok());
    const auto table = ReadTomlFile(folder / "a.toml");
    ASSERT_FALSE(table.ok());
    EXPECT_EQ(table.error().code, ErrorCode::kBadInput);
    EXPECT_THAT(table.error().message, AllOf(HasSubstr("a.toml"), HasSubstr("line 3")));
  }
}

TEST(ReadTomlFile, AMissingFileIsAnError) {
  const TempFolder folder;
  EXPECT_THAT(ReadTomlFile(folder / "none.toml").error().message, HasSubstr("none.toml"));
}

}  // namespace
}  // namespace dorsum
