// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal_attendant.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "cli/session.h"

namespace dorsum {
namespace {

// A pipe in the place of the keyboard.
class TerminalAttendantTest : public ::testing::Test {
 protected:
  TerminalAttendantTest() : keyboard_(dup(STDIN_FILENO)) {
    EXPECT_EQ(pipe(ends_), 0);
    dup2(ends_[0], STDIN_FILENO);
    close(ends_[0]);
  }
  ~TerminalAttendantTest() override {
    Hang();
    dup2(keyboard_, STDIN_FILENO);
    close(keyboard_);
  }
  void Type(const std::string& text) {
    EXPECT_EQ(write(ends_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void Hang() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }
  Status Ask(const Context& context = {}) {
    testing::internal::CaptureStderr();
    Status status = MakeTerminalAttendant(&session_)->Arrange(
        SeriesStep(), "Clear the backplane.",
        [this] {
          ++kept_lit_;
          return lights_;
        },
        context);
    said_ = testing::internal::GetCapturedStderr();
    return status;
  }

  Session session_;
  Status lights_;
  int kept_lit_ = 0;
  std::string said_;
  int keyboard_;
  int ends_[2] = {-1, -1};
};

TEST_F(TerminalAttendantTest, EnterGoesOnAndTheStripesWereKeptLit) {
  Type("\n");
  EXPECT_TRUE(Ask().ok());
  EXPECT_GE(kept_lit_, 1);
  EXPECT_NE(said_.find("Clear the backplane."), std::string::npos);
}

TEST_F(TerminalAttendantTest, QGivesUp) {
  Type("q\n");
  EXPECT_EQ(Ask().error().code, ErrorCode::kCancelled);
}

TEST_F(TerminalAttendantTest, AClosedInputIsWrongUsageAndNoEndlessWait) {
  Hang();
  EXPECT_EQ(Ask().error().code, ErrorCode::kUsage);
}

TEST_F(TerminalAttendantTest, AnInterruptEndsTheWait) {
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  EXPECT_EQ(Ask(context).error().code, ErrorCode::kCancelled);
}

TEST_F(TerminalAttendantTest, ALightThatCannotBeKeptEndsTheWait) {
  lights_ = Error{ErrorCode::kDevice, "the light controller is gone"};
  EXPECT_EQ(Ask().error().code, ErrorCode::kDevice);
}

}  // namespace
}  // namespace dorsum
