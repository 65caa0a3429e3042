// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace dorsum {

// The host's side of the light controller's lines, docs/protocol.md. Written apart from the firmware's, so
// that a test of one against the other says something.

inline constexpr int kControllerProtocol = 1;

// CRC-16/CCITT-FALSE of all that stands before a line's '*'.
std::uint16_t ControllerCrc(std::string_view text);

// A whole line with its newline; `words` is the command, such as "SET 0001".
std::string ControllerLine(std::uint16_t session, std::uint16_t sequence, std::string_view words);
std::string HelloWords(std::uint16_t nonce);
std::string SetWords(std::uint16_t channels);

enum class ReplyKind { kBoot, kGreeting, kState, kLimits, kError };

// What is not of a reply's kind stays as it is here.
struct ControllerReply {
  ReplyKind kind = ReplyKind::kError;
  std::uint16_t session = 0, sequence = 0;
  int protocol = 0;              // boot, greeting, error VERSION
  std::string firmware_version;  // the same
  std::uint16_t nonce = 0;       // greeting
  int channels = 0;              // greeting
  std::uint16_t wired = 0;       // greeting: channels that can be switched
  bool inverted = false;         // greeting: a low pin lights its light
  char reset_cause = 'U';        // boot, greeting: P power, E reset pin, B brown-out, W watchdog, U unknown
  std::uint16_t on = 0;          // state
  char why = 'H';                // state: - lit, H host, S silence, T time, E error
  std::uint32_t silence_ms = 0, laser_ms = 0, led_ms = 0;  // limits
  std::string error;                                       // error: its word
};

// Of a line without its newline; nothing where it is damaged or no reply.
std::optional<ControllerReply> ParseControllerReply(std::string_view line);

// Puts lines together from bytes as they come. A '<' begins a line wherever it stands, and what is too long
// to be a line is passed over.
class LineAssembler {
 public:
  static constexpr std::size_t kLongest = 64;
  // The line that this byte ends, without its newline.
  std::optional<std::string> Add(char byte);

 private:
  std::string line_;
  bool too_long_ = false;
};

}  // namespace dorsum
