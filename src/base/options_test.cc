// SPDX-License-Identifier: Apache-2.0
#include "base/options.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temp_folder_test.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

struct Values {
  double pitch = 0.5;
  int rows = 3;
  bool flip = false;
  std::string method = "classic";
};

class OptionTableTest : public ::testing::Test {
 protected:
  OptionTableTest() {
    table_.Add("pitch-mm", &values_.pitch, 0.1, 5.0, "grid, mm");
    table_.Add("rows", &values_.rows, 1, 10, "rows");
    table_.Add("flip", &values_.flip, "turn over");
    table_.Add("method", &values_.method, {"classic", "bundle"}, "which one");
  }

  std::string Refusal(const std::string& name, const std::string& value) {
    const Status status = table_.Set(name, value);
    if (status.ok()) return "(no error)";
    EXPECT_EQ(status.error().code, ErrorCode::kUsage);
    return status.error().message;
  }

  Status ReadToml(const std::string& text) {
    EXPECT_TRUE(WriteFile(folder_ / "settings.toml", text).ok());
    return table_.ReadToml(folder_ / "settings.toml", "reconstruct");
  }

  TempFolder folder_;
  Values values_;
  OptionTable table_;
};

TEST_F(OptionTableTest, SetsWhatIsAllowed) {
  EXPECT_TRUE(table_.Set("pitch-mm", "0.25").ok());
  EXPECT_TRUE(table_.Set("rows", "10").ok());
  EXPECT_TRUE(table_.Set("flip", "true").ok());
  EXPECT_TRUE(table_.Set("method", "bundle").ok());
  EXPECT_EQ(values_.pitch, 0.25);
  EXPECT_EQ(values_.rows, 10);
  EXPECT_TRUE(values_.flip);
  EXPECT_EQ(values_.method, "bundle");
  EXPECT_EQ(OptionTable::ValueText(table_.specs()[0]), "0.25");
  EXPECT_EQ(OptionTable::ValueText(table_.specs()[1]), "10");
  EXPECT_EQ(OptionTable::ValueText(table_.specs()[2]), "true");
  EXPECT_EQ(OptionTable::ValueText(table_.specs()[3]), "bundle");
}

TEST_F(OptionTableTest, RefusalsSayWhatIsAllowedAndChangeNothing) {
  EXPECT_THAT(Refusal("pitch-mm", "0.05"),
              AllOf(HasSubstr("--pitch-mm"), HasSubstr("0.1 to 5"), HasSubstr("0.05")));
  for (const char* value : {"nan", "inf", "", "1x", " 1", "1,5"}) {
    EXPECT_THAT(Refusal("pitch-mm", value), HasSubstr("a number from"));
  }
  for (const char* value : {"0", "11", "2.5", "99999999999999", "x"}) {
    EXPECT_THAT(Refusal("rows", value), HasSubstr("a whole number from 1 to 10"));
  }
  EXPECT_THAT(Refusal("flip", "yes"), HasSubstr("true or false"));
  EXPECT_THAT(Refusal("method", "Classic"), HasSubstr("one of: classic, bundle"));
  EXPECT_THAT(Refusal("none", "1"), HasSubstr("no option 'none'"));
  EXPECT_EQ(values_.pitch, 0.5);
  EXPECT_EQ(values_.rows, 3);
  EXPECT_FALSE(values_.flip);
  EXPECT_EQ(values_.method, "classic");
}

TEST_F(OptionTableTest, ReadsItsTableAndLeavesOthersAlone) {
  EXPECT_TRUE(
      ReadToml(
          "[other]\nunknown = 1\n[reconstruct]\npitch-mm = 2\nrows = 4\nflip = true\nmethod = 'bundle'\n")
          .ok());
  EXPECT_EQ(values_.pitch, 2.0);
  EXPECT_EQ(values_.rows, 4);
  EXPECT_TRUE(values_.flip);
  EXPECT_EQ(values_.method, "bundle");
  EXPECT_TRUE(ReadToml("").ok());
}

TEST_F(OptionTableTest, BadTomlNamesFileTableAndOption) {
  const auto message = [&](const std::string& text) {
    const Status status = ReadToml(text);
    if (status.ok()) return std::string("(no error)");
    EXPECT_EQ(status.error().code, ErrorCode::kBadInput);
    return status.error().message;
  };
  EXPECT_THAT(message("[reconstruct]\npitsch-mm = 2\n"),
              AllOf(HasSubstr("settings.toml"), HasSubstr("[reconstruct]"), HasSubstr("pitsch-mm")));
  EXPECT_THAT(message("[reconstruct]\npitch-mm = 9.0\n"),
              AllOf(HasSubstr("settings.toml"), HasSubstr("pitch-mm")));
  EXPECT_THAT(message("[reconstruct]\npitch-mm = [1, 2]\n"), HasSubstr("pitch-mm"));
  EXPECT_THAT(message("[reconstruct.rows]\nx = 1\n"), HasSubstr("rows"));
  EXPECT_THAT(message("reconstruct = 5\n"), AllOf(HasSubstr("settings.toml"), HasSubstr("[reconstruct]")));
  EXPECT_THAT(message("[reconstruct\n"), HasSubstr("line 1"));
}

}  // namespace
}  // namespace dorsum
