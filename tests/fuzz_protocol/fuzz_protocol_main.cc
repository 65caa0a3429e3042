// SPDX-License-Identifier: Apache-2.0
// Throws broken, hostile and random bytes at both sides of the light controller's protocol:
//   fuzz-protocol COUNT [SEED]
// COUNT inputs for the firmware's logic and as many for the host's parser, the same ones for the same seed.
// Besides not crashing, the firmware must light nothing that is not wired, nothing longer than it may, and
// must answer with lines that the host can read. Exit code 1 says what went wrong with which input.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "device/controller_protocol.h"
#include "firmware/config.h"
#include "firmware/controller.h"

namespace dorsum {
namespace {

class Fuzzer {
 public:
  explicit Fuzzer(std::uint64_t seed) : random_(seed) { controller_begin(&firmware_, kWired, 'N', 'P', 1); }

  void Run(long count) {
    for (input_ = 0; input_ < count; ++input_) {
      Feed(Broken(Command()));
      PassTime();
      Read(Broken(Reply()));
    }
  }

  void Summarise() const {
    std::printf(
        "%ld inputs a side: the firmware sent %ld lines and was lit after %ld inputs, the host believed "
        "%ld\n",
        input_, sent_, lit_, believed_);
  }

 private:
  static constexpr std::uint16_t kWired = 0x017F;

  std::uint32_t Below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }
  std::uint16_t Word() { return static_cast<std::uint16_t>(random_()); }

  [[noreturn]] void Fail(const char* what) const {
    std::fprintf(stderr, "fuzz-protocol: input %ld: %s\n", input_, what);
    std::exit(1);
  }

  static std::string Hex(std::uint32_t value, int digits) {
    char text[16];
    std::snprintf(text, sizeof text, "%0*X", digits, value);
    return text;
  }

  // Mostly of the session that is open, so that the depths are reached.
  std::string Command() {
    const std::uint16_t session = Below(8) != 0 ? firmware_.session : Word();
    const auto ahead = static_cast<std::uint16_t>(Below(8) != 0 ? 1U : Below(4));
    const std::uint16_t sequence =
        Below(16) != 0 ? static_cast<std::uint16_t>(firmware_.sequence + ahead) : Word();
    switch (Below(8)) {
      case 0:
        return ControllerLine(0, sequence, HelloWords(Word()));
      case 1:
        return ControllerLine(session, sequence, "GET");
      case 2:
        return ControllerLine(session, sequence, "OFF");
      case 3:
        return ControllerLine(session, sequence, "LIMITS");
      case 4:
        return ControllerLine(session, sequence,
                              "LIMITS " + Hex(Below(20000), 8) + " " + Hex(Below(900000), 8));
      default:
        return ControllerLine(session, sequence, SetWords(Below(4) != 0 ? Word() & kWired : Word()));
    }
  }

  std::string Reply() {
    static const char* const kBodies[] = {"BOOT 01 1.0.0 P", "HI 01 BEEF 1.0.0 09 01FF N E",
                                          "OK 0101 -",       "LIMITS 000007D0 00002710 000927C0",
                                          "ERR STALE",       "ERR VERSION 02 1.0.0"};
    std::string line = "<" + Hex(Word(), 4) + " " + Hex(Word(), 4) + " " + kBodies[Below(6)];
    return line + "*" + Hex(ControllerCrc(line), 4) + "\n";
  }

  void Mutate(std::string& bytes) {
    const std::size_t at = bytes.empty() ? 0 : Below(static_cast<std::uint32_t>(bytes.size()));
    switch (Below(7)) {
      case 0:
        bytes.insert(at, 1, static_cast<char>(Below(256)));
        break;
      case 1:
        if (!bytes.empty()) bytes.erase(at, 1 + Below(4));
        break;
      case 2:
        if (!bytes.empty()) bytes[at] = static_cast<char>(Below(256));
        break;
      case 3:
        if (!bytes.empty()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << Below(8)));
        break;
      case 4:
        bytes.insert(at, bytes.substr(at, 1 + Below(40)));
        break;
      case 5:
        bytes.insert(at, std::string(Below(120), "0F >*\n"[Below(6)]));
        break;
      default:
        bytes.resize(at);
    }
  }

  // A line as it is, damaged, damaged with a checksum that fits again, or no line at all.
  std::string Broken(std::string line) {
    const std::uint32_t kind = Below(8);
    if (kind < 2) return line;
    if (kind == 2) {
      std::string bytes(Below(100), 0);
      for (char& byte : bytes) byte = static_cast<char>(Below(256));
      return bytes + "\n";
    }
    if (kind < 6) line.resize(line.size() - 6);
    for (std::uint32_t i = 0; i <= Below(4); ++i) Mutate(line);
    if (kind < 6) line += "*" + Hex(ControllerCrc(line), 4) + "\n";
    return line;
  }

  void Feed(const std::string& bytes) {
    char text[LINE_CAPACITY + 1];
    for (const char byte : bytes) {
      const std::uint8_t length = controller_byte(&firmware_, byte, Below(2000) == 0, now_ms_, text);
      if ((firmware_.on & ~kWired) != 0) Fail("a channel is on that is not wired");
      if (length == 0) continue;
      ++sent_;
      if (length > sizeof text || text[length - 1] != '\n' || !ParseControllerReply({text, length - 1U})) {
        Fail("the firmware's reply makes no sense to the host");
      }
    }
    if (firmware_.on != 0) ++lit_;
  }

  void PassTime() {
    const std::uint16_t before = firmware_.on;
    now_ms_ += Below(64) != 0 ? Below(40) : Below(12000);
    controller_tick(&firmware_, now_ms_);
    if ((firmware_.on & ~before) != 0) Fail("time lit a light");
    if (firmware_.on == 0) return;
    if (now_ms_ - firmware_.heard_ms >= SILENCE_LIMIT_MS) Fail("lit though the host is silent");
    const bool laser = (firmware_.on & LASER_CHANNELS) != 0;
    if (now_ms_ - firmware_.set_ms >= (laser ? LASER_LIMIT_MS : LED_LIMIT_MS)) Fail("lit for too long");
  }

  void Read(const std::string& bytes) {
    for (const char byte : bytes) {
      if (const auto line = assembler_.Add(byte)) believed_ += ParseControllerReply(*line) ? 1 : 0;
    }
    if (ParseControllerReply(bytes) && bytes.empty()) Fail("the host believes in nothing");
  }

  std::mt19937_64 random_;
  controller firmware_ = {};
  LineAssembler assembler_;
  std::uint32_t now_ms_ = 0;
  long input_ = 0, sent_ = 0, lit_ = 0, believed_ = 0;
};

}  // namespace
}  // namespace dorsum

int main(int argc, char** argv) {
  const long count = argc > 1 ? std::atol(argv[1]) : 0;
  if (count <= 0) {
    std::fprintf(stderr, "usage: fuzz-protocol COUNT [SEED]\n");
    return 2;
  }
  dorsum::Fuzzer fuzzer(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
  fuzzer.Run(count);
  fuzzer.Summarise();
  return 0;
}
