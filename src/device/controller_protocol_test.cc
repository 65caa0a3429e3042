// SPDX-License-Identifier: Apache-2.0
#include "device/controller_protocol.h"

#include <cstdio>

#include <gtest/gtest.h>

#include "firmware/controller.h"
#include "firmware/line.h"

namespace dorsum {
namespace {

std::string WithCrc(const std::string& body) {
  char crc[8];
  std::snprintf(crc, sizeof crc, "*%04X", ControllerCrc(body));
  return body + crc;
}

command Read(const std::string& line) {
  command read = {};
  EXPECT_EQ(line.back(), '\n');
  EXPECT_EQ(line_read(line.data(), static_cast<std::uint8_t>(line.size() - 1), &read), LINE_FINE) << line;
  return read;
}

TEST(ControllerProtocol, BothSidesCountTheSameChecksum) {
  EXPECT_EQ(ControllerCrc("123456789"), 0x29B1);  // the published check value of CRC-16/CCITT-FALSE
  EXPECT_EQ(line_crc("123456789", 9), 0x29B1);
}

TEST(ControllerProtocol, FirmwareReadsWhatTheHostWrites) {
  const command hello = Read(ControllerLine(0, 1, HelloWords(0xBEEF)));
  EXPECT_EQ(hello.verb, VERB_HELLO);
  EXPECT_EQ(hello.protocol, kControllerProtocol);
  EXPECT_EQ(hello.nonce, 0xBEEF);
  const command set = Read(ControllerLine(0x1A2B, 0xFFFF, SetWords(0x0101)));
  EXPECT_EQ(set.verb, VERB_SET);
  EXPECT_EQ(set.session, 0x1A2B);
  EXPECT_EQ(set.sequence, 0xFFFF);
  EXPECT_EQ(set.channels, 0x0101);
  EXPECT_EQ(Read(ControllerLine(1, 2, "GET")).verb, VERB_GET);
  EXPECT_EQ(Read(ControllerLine(1, 2, "OFF")).verb, VERB_OFF);
  EXPECT_FALSE(Read(ControllerLine(1, 2, "LIMITS")).has_limits);
  const command limits = Read(ControllerLine(1, 2, "LIMITS 00001388 0000EA60"));
  EXPECT_TRUE(limits.has_limits);
  EXPECT_EQ(limits.laser_ms, 5000U);
  EXPECT_EQ(limits.led_ms, 60000U);
}

TEST(ControllerProtocol, HostReadsWhatTheFirmwareWrites) {
  controller firmware;
  controller_begin(&firmware, 0x01FD, 'I', 'B', 7);
  char text[LINE_CAPACITY + 1];
  const std::uint8_t length = controller_banner(&firmware, text);
  const auto boot = ParseControllerReply(std::string_view(text, length - 1U));
  ASSERT_TRUE(boot);
  EXPECT_EQ(boot->kind, ReplyKind::kBoot);
  EXPECT_EQ(boot->firmware_version, "1.0.0");
  EXPECT_EQ(boot->reset_cause, 'B');

  std::string sent;
  for (const char byte : ControllerLine(0, 1, HelloWords(0xBEEF))) {
    sent.append(text, controller_byte(&firmware, byte, false, 5, text));
  }
  const auto greeting = ParseControllerReply(sent.substr(0, sent.size() - 1));
  ASSERT_TRUE(greeting) << sent;
  EXPECT_EQ(greeting->kind, ReplyKind::kGreeting);
  EXPECT_EQ(greeting->nonce, 0xBEEF);
  EXPECT_EQ(greeting->channels, 9);
  EXPECT_EQ(greeting->wired, 0x01FD);
  EXPECT_TRUE(greeting->inverted);
  EXPECT_NE(greeting->session, 0);
}

TEST(ControllerProtocol, NoSingleLostDoubledOrChangedByteIsBelieved) {
  const std::string good = WithCrc("<1A2B 0007 OK 0101 -");
  ASSERT_TRUE(ParseControllerReply(good));
  const std::string line = ControllerLine(0x1A2B, 7, SetWords(0x0101));
  const std::string said = line.substr(0, line.size() - 1);
  const auto firmware_believes = [](const std::string& text) {
    command read;
    return line_read(text.data(), static_cast<std::uint8_t>(text.size()), &read) == LINE_FINE;
  };
  ASSERT_TRUE(firmware_believes(said));
  for (const std::string* original : {&good, &said}) {
    const auto believes = [&](const std::string& text) {
      return original == &good ? ParseControllerReply(text).has_value() : firmware_believes(text);
    };
    for (std::size_t i = 0; i < original->size(); ++i) {
      std::string lost = *original, doubled = *original;
      EXPECT_FALSE(believes(lost.erase(i, 1))) << lost;
      EXPECT_FALSE(believes(doubled.insert(i, 1, (*original)[i]))) << doubled;
      for (int value = 0; value < 256; ++value) {
        std::string garbled = *original;
        garbled[i] = static_cast<char>(value);
        EXPECT_EQ(believes(garbled), garbled == *original) << garbled;
      }
    }
  }
}

TEST(ControllerProtocol, RepliesThatAreWholeButMakeNoSenseAreNone) {
  for (const char* body :
       {"<1A2B 0007 OK 0101", "<1A2B 0007 OK 101 -", "<1A2B 0007 OK 0101 X", "<1A2B 0007 OK 0101 - -",
        "<1A2B 0007", "<1a2b 0007 OK 0101 -", "<1A2B 0007 YES", "<1A2B 0007 ERR", "<1A2B 0007 ERR OH",
        "<0000 0000 BOOT 01 version P", "<1A2B 0001 HI 01 BEEF 1.0.0 FF 01FF N P", "<1A2B 0007 OK  0101 -",
        "<", "<    "}) {
    EXPECT_FALSE(ParseControllerReply(WithCrc(body))) << body;
  }
  EXPECT_FALSE(ParseControllerReply(""));
  EXPECT_FALSE(ParseControllerReply("*29B1"));
}

TEST(ControllerProtocol, LineBeginsAnewWhereItsBeginningIsSeen) {
  LineAssembler assembler;
  std::string lines;
  for (const char byte : std::string("noise<half<whole\n\n") + std::string(500, 'x') + "\n<next\n") {
    if (const auto line = assembler.Add(byte)) lines += *line + "|";
  }
  EXPECT_EQ(lines, "<whole|<next|");
}

}  // namespace
}  // namespace dorsum
