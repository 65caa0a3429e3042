// SPDX-License-Identifier: Apache-2.0
#include "device/controller_protocol.h"

#include <algorithm>
#include <initializer_list>
#include <vector>

namespace dorsum {
namespace {

std::string Hex(std::uint32_t value, int digits) {
  std::string text(static_cast<std::size_t>(digits), '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, value >>= 4U) {
    *digit = "0123456789ABCDEF"[value & 0xFU];
  }
  return text;
}

// Exactly so many digits, capitals only.
template <class T>
bool ReadHex(std::string_view word, std::size_t digits, T& value) {
  if (word.size() != digits) return false;
  std::uint32_t sum = 0;
  for (const char c : word) {
    if (c >= '0' && c <= '9') {
      sum = sum << 4U | static_cast<std::uint32_t>(c - '0');
    } else if (c >= 'A' && c <= 'F') {
      sum = sum << 4U | static_cast<std::uint32_t>(c - 'A' + 10);
    } else {
      return false;
    }
  }
  value = static_cast<T>(sum);
  return true;
}

// One of these letters, alone.
bool ReadLetter(std::string_view word, std::string_view allowed, char& letter) {
  if (word.size() != 1 || allowed.find(word[0]) == std::string_view::npos) return false;
  letter = word[0];
  return true;
}

bool ReadVersion(std::string_view word, std::string& version) {
  const bool good = !word.empty() && word.size() <= 16 && std::all_of(word.begin(), word.end(), [](char c) {
    return (c >= '0' && c <= '9') || c == '.';
  });
  if (good) version = std::string(word);
  return good;
}

using Words = std::vector<std::string_view>;

Words Split(std::string_view text) {
  Words words;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

constexpr std::string_view kResetCauses = "PEBWU", kWhys = "-HSTE";

// words[0] and [1] are session and sequence, [2] the kind.
bool ReadBoot(const Words& words, ControllerReply& reply) {
  reply.kind = ReplyKind::kBoot;
  return words.size() == 6 && ReadHex(words[3], 2, reply.protocol) &&
         ReadVersion(words[4], reply.firmware_version) &&
         ReadLetter(words[5], kResetCauses, reply.reset_cause);
}

bool ReadGreeting(const Words& words, ControllerReply& reply) {
  reply.kind = ReplyKind::kGreeting;
  char logic = 0;
  const bool good = words.size() == 10 && ReadHex(words[3], 2, reply.protocol) &&
                    ReadHex(words[4], 4, reply.nonce) && ReadVersion(words[5], reply.firmware_version) &&
                    ReadHex(words[6], 2, reply.channels) && ReadHex(words[7], 4, reply.wired) &&
                    ReadLetter(words[8], "NI", logic) &&
                    ReadLetter(words[9], kResetCauses, reply.reset_cause) && reply.channels <= 16;
  reply.inverted = logic == 'I';
  return good;
}

bool ReadError(const Words& words, ControllerReply& reply) {
  reply.kind = ReplyKind::kError;
  if (words.size() < 4) return false;
  reply.error = std::string(words[3]);
  if (reply.error == "VERSION") {
    return words.size() == 6 && ReadHex(words[4], 2, reply.protocol) &&
           ReadVersion(words[5], reply.firmware_version);
  }
  const auto known = {"DAMAGED", "COMMAND", "SESSION", "STALE", "CHANNEL", "LIMIT"};
  return words.size() == 4 && std::find(known.begin(), known.end(), reply.error) != known.end();
}

bool ReadKind(const Words& words, ControllerReply& reply) {
  if (words[2] == "BOOT") return ReadBoot(words, reply);
  if (words[2] == "HI") return ReadGreeting(words, reply);
  if (words[2] == "ERR") return ReadError(words, reply);
  if (words[2] == "OK") {
    reply.kind = ReplyKind::kState;
    return words.size() == 5 && ReadHex(words[3], 4, reply.on) && ReadLetter(words[4], kWhys, reply.why);
  }
  if (words[2] == "LIMITS") {
    reply.kind = ReplyKind::kLimits;
    return words.size() == 6 && ReadHex(words[3], 8, reply.silence_ms) &&
           ReadHex(words[4], 8, reply.laser_ms) && ReadHex(words[5], 8, reply.led_ms);
  }
  return false;
}

}  // namespace

std::uint16_t ControllerCrc(std::string_view text) {
  std::uint32_t crc = 0xFFFF;
  for (const char c : text) {
    crc ^= static_cast<std::uint32_t>(static_cast<unsigned char>(c)) << 8U;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 0x8000U) != 0 ? (crc << 1U) ^ 0x1021U : crc << 1U;
  }
  return static_cast<std::uint16_t>(crc & 0xFFFFU);
}

std::string ControllerLine(std::uint16_t session, std::uint16_t sequence, std::string_view words) {
  std::string line = ">" + Hex(session, 4) + " " + Hex(sequence, 4) + " " + std::string(words);
  line += "*" + Hex(ControllerCrc(line), 4) + "\n";
  return line;
}

std::string HelloWords(std::uint16_t nonce) {
  return "HELLO " + Hex(kControllerProtocol, 2) + " " + Hex(nonce, 4);
}

std::string SetWords(std::uint16_t channels) { return "SET " + Hex(channels, 4); }

std::optional<ControllerReply> ParseControllerReply(std::string_view line) {
  if (line.size() < 6 || line.size() > LineAssembler::kLongest || line.front() != '<') return std::nullopt;
  const std::string_view body = line.substr(0, line.size() - 5), end = line.substr(line.size() - 5);
  std::uint16_t crc = 0;
  if (end.front() != '*' || !ReadHex(end.substr(1), 4, crc) || crc != ControllerCrc(body)) {
    return std::nullopt;
  }
  const Words words = Split(body.substr(1));
  ControllerReply reply;
  if (words.size() < 3 || !ReadHex(words[0], 4, reply.session) || !ReadHex(words[1], 4, reply.sequence) ||
      !ReadKind(words, reply)) {
    return std::nullopt;
  }
  return reply;
}

std::optional<std::string> LineAssembler::Add(char byte) {
  if (byte == '\n') {
    std::optional<std::string> line;
    if (!line_.empty() && !too_long_) line = line_;
    line_.clear();
    too_long_ = false;
    return line;
  }
  if (byte == '<') {
    line_.clear();
    too_long_ = false;
  }
  if (line_.size() < kLongest) {
    line_ += byte;
  } else {
    too_long_ = true;
  }
  return std::nullopt;
}

}  // namespace dorsum
