// SPDX-License-Identifier: Apache-2.0
// The firmware's decisions, firmware/controller.c, with a clock of the test's own.
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "device/controller_protocol.h"
#include "firmware/config.h"
#include "firmware/controller.h"

namespace dorsum {
namespace {

class ControllerLogic : public ::testing::Test {
 protected:
  ControllerLogic() {
    controller_begin(&self_, ALL_CHANNELS, 'N', 'P', 99);
    session_ = Say(0, 1, HelloWords(0x1234)).session;
    sequence_ = 1;
  }

  ControllerReply Bytes(const std::string& bytes) {
    char text[LINE_CAPACITY + 1];
    std::string sent;
    for (const char byte : bytes) {
      sent.append(text, controller_byte(&self_, byte, false, now_ms_, text));
      EXPECT_EQ(self_.on & ~ALL_CHANNELS, 0U);
    }
    if (sent.empty()) return {};
    const auto reply = ParseControllerReply(sent.substr(0, sent.size() - 1));
    EXPECT_TRUE(reply) << sent;
    return reply.value_or(ControllerReply());
  }
  ControllerReply Say(std::uint16_t session, std::uint16_t sequence, const std::string& words) {
    return Bytes(ControllerLine(session, sequence, words));
  }
  ControllerReply Say(const std::string& words) { return Say(session_, ++sequence_, words); }
  // Lets time pass, a millisecond a tick.
  void Pass(std::uint32_t ms) {
    for (std::uint32_t i = 0; i < ms; ++i) {
      ++now_ms_;
      controller_tick(&self_, now_ms_);
    }
  }
  // The same, with a sign of life each half second.
  void PassAlive(std::uint32_t ms) {
    for (std::uint32_t i = 0; i < ms / 500; ++i) {
      Say("GET");
      Pass(500);
    }
  }

  controller self_ = {};
  std::uint32_t now_ms_ = 0xFFFFF000;  // wraps within the test
  std::uint16_t session_ = 0, sequence_ = 0;
};

TEST_F(ControllerLogic, SilentHostMeansOffAfterTwoSecondsAndNotSooner) {
  EXPECT_EQ(Say("SET 0102").on, 0x0102);
  Pass(1999);
  EXPECT_EQ(self_.on, 0x0102);
  Pass(1);
  EXPECT_EQ(self_.on, 0);
  EXPECT_EQ(Say("GET").why, 'S');
}

TEST_F(ControllerLogic, LaserStaysNoLongerThanItMayThoughTheHostIsAlive) {
  Say("SET 0001");
  PassAlive(9500);
  EXPECT_EQ(self_.on, 1);
  PassAlive(500);
  EXPECT_EQ(self_.on, 0);
  EXPECT_EQ(Say("GET").why, 'T');
}

TEST_F(ControllerLogic, SettingALaserAgainRenewsItAndARetryDoesNot) {
  Say("SET 0001");
  PassAlive(9000);
  const ControllerReply renewed = Say("SET 0001");
  PassAlive(9000);
  EXPECT_EQ(renewed.on, 1);
  EXPECT_EQ(self_.on, 1);
  Say("SET 0001");
  PassAlive(5000);
  const std::uint16_t set = ++sequence_;
  Say(session_, set, "SET 0001");
  bool lit_at_first = false;
  for (int i = 0; i < 11; ++i) {
    Pass(1000);
    Say(session_, set, "SET 0001");
    lit_at_first = lit_at_first || self_.on == 1;
  }
  EXPECT_TRUE(lit_at_first);
  EXPECT_EQ(self_.on, 0) << "the same line for ever kept a laser on";
}

TEST_F(ControllerLogic, LedsMayStayLongerButNotForEver) {
  Say("SET 0100");
  PassAlive(LED_LIMIT_MS - 500);
  EXPECT_EQ(self_.on, 0x0100);
  PassAlive(500);
  EXPECT_EQ(self_.on, 0);
}

TEST_F(ControllerLogic, LateCopyOfACommandSwitchesNothingOnAgain) {
  const std::string on = ControllerLine(session_, ++sequence_, "SET 0001");
  EXPECT_EQ(Bytes(on).on, 1);
  EXPECT_EQ(Say("SET 0000").on, 0);
  const ControllerReply late = Bytes(on);
  EXPECT_EQ(late.error, "STALE");
  EXPECT_EQ(self_.on, 0);
  Say("SET 0002");
  Bytes(on);
  EXPECT_EQ(self_.on, 0) << "a host that talks in the wrong order is trusted with a laser";
}

TEST_F(ControllerLogic, RetryOfACommandThatWasObeyedTellsWhatIsNow) {
  const std::string on = ControllerLine(session_, ++sequence_, "SET 0001");
  Bytes(on);
  Pass(SILENCE_LIMIT_MS);
  const ControllerReply again = Bytes(on);
  EXPECT_EQ(again.kind, ReplyKind::kState);
  EXPECT_EQ(again.on, 0) << "a retry lit a light that time had put out";
}

TEST_F(ControllerLogic, LinesOfAnEarlierSessionAreRefused) {
  const std::string old = ControllerLine(session_, 9, "SET 0001");
  const std::string old_hello = ControllerLine(0, 1, HelloWords(0x1234));
  session_ = Say(0, 1, HelloWords(0x9999)).session;
  sequence_ = 1;
  EXPECT_EQ(Bytes(old).error, "SESSION");
  EXPECT_EQ(self_.on, 0);
  Bytes(old_hello);  // the whole old session over again
  EXPECT_EQ(Bytes(old).error, "SESSION");
  EXPECT_EQ(self_.on, 0);
}

TEST_F(ControllerLogic, RepeatedGreetingGivesTheSameSession) {
  const ControllerReply first = Say(0, 5, HelloWords(0x7777)), second = Say(0, 5, HelloWords(0x7777));
  EXPECT_EQ(first.session, second.session);
  EXPECT_EQ(Say(first.session, 6, "SET 0001").on, 1);
}

TEST_F(ControllerLogic, NothingIsObeyedBeforeAGreeting) {
  controller_begin(&self_, ALL_CHANNELS, 'N', 'P', 99);
  EXPECT_EQ(Say(0, 2, "SET 0001").error, "SESSION");
  EXPECT_EQ(Say(session_, 2, "SET 0001").error, "SESSION");
  EXPECT_EQ(self_.on, 0);
}

TEST_F(ControllerLogic, WhateverIsWrongPutsEverythingOut) {
  const auto other = static_cast<std::uint16_t>(session_ + 1);
  const struct {
    std::string bytes;
    const char* error;
  } wrongs[] = {{"rubbish\n", "DAMAGED"},
                {std::string(300, 'A') + "\n", "DAMAGED"},
                {ControllerLine(session_, 500, "DANCE"), "COMMAND"},
                {ControllerLine(session_, 500, "SET 01"), "COMMAND"},
                {ControllerLine(session_, 105, "SET 0200"), "CHANNEL"},
                {ControllerLine(session_, 107, "LIMITS 0000FFFF 00000001"), "LIMIT"},
                {ControllerLine(session_, 50, "SET 0001"), "STALE"},
                {ControllerLine(other, 500, "GET"), "SESSION"},
                {ControllerLine(0, 1, "HELLO 63 0000"), "VERSION"}};
  std::uint16_t sequence = 100;
  for (const auto& wrong : wrongs) {
    ASSERT_EQ(Say(session_, sequence, "SET 0103").on, 0x0103) << wrong.bytes;
    EXPECT_EQ(Bytes(wrong.bytes).error, wrong.error) << wrong.bytes;
    EXPECT_EQ(self_.on, 0) << wrong.bytes;
    // CHANNEL and LIMIT are refused for what they ask, so they have used their number.
    if (std::string(wrong.error) == "CHANNEL" || std::string(wrong.error) == "LIMIT") ++sequence;
    ++sequence;
  }
}

TEST_F(ControllerLogic, ReceiverErrorPutsEverythingOutAtOnce) {
  Say("SET 0001");
  char text[LINE_CAPACITY + 1];
  EXPECT_EQ(controller_byte(&self_, 'x', true, now_ms_, text), 0);
  EXPECT_EQ(self_.on, 0);
}

TEST_F(ControllerLogic, OffIsObeyedFromWhoeverSaysIt) {
  Say("SET 0001");
  Say(0x0BAD, 77, "OFF");
  EXPECT_EQ(self_.on, 0);
}

TEST_F(ControllerLogic, LimitsGoDownOnlyAndComeBackWithTheNextSession) {
  const ControllerReply built_in = Say("LIMITS");
  EXPECT_EQ(built_in.silence_ms, 2000U);
  EXPECT_EQ(built_in.laser_ms, 10000U);
  EXPECT_EQ(Say("LIMITS 000003E8 00002710").laser_ms, 1000U);
  EXPECT_EQ(Say("LIMITS 000003E9 00002710").error, "LIMIT");
  EXPECT_EQ(Say("LIMITS 00000000 00002710").error, "LIMIT");
  EXPECT_EQ(Say("LIMITS").laser_ms, 1000U);
  Say("SET 0001");
  Pass(1000);
  EXPECT_EQ(self_.on, 0);
  session_ = Say(0, 1, HelloWords(1)).session;
  sequence_ = 1;
  EXPECT_EQ(Say("LIMITS").laser_ms, 10000U);
}

TEST_F(ControllerLogic, ChannelWhoseWiringIsWrongIsNeverOn) {
  controller_begin(&self_, 0x0002, 'N', 'P', 1);
  session_ = Say(0, 1, HelloWords(1)).session;
  sequence_ = 1;
  EXPECT_EQ(Say("SET 0003").error, "CHANNEL");
  EXPECT_EQ(self_.on, 0);
  EXPECT_EQ(Say("SET 0002").on, 2);
}

}  // namespace
}  // namespace dorsum
