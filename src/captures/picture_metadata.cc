// SPDX-License-Identifier: Apache-2.0
#include "captures/picture_metadata.h"

#include <cstdint>

namespace dorsum {
namespace {

constexpr std::string_view kPngStart("\x89PNG\r\n\x1a\n", 8);

std::uint32_t Byte(std::string_view s, std::size_t i) { return static_cast<unsigned char>(s[i]); }
std::uint32_t Big16(std::string_view s, std::size_t i) { return Byte(s, i) << 8 | Byte(s, i + 1); }
std::uint32_t Big32(std::string_view s, std::size_t i) { return Big16(s, i) << 16 | Big16(s, i + 2); }

Result<std::string> PlainPng(std::string_view s) {
  std::string out(kPngStart);
  for (std::size_t i = kPngStart.size(); i + 12 <= s.size();) {
    const std::size_t length = Big32(s, i);
    if (length > s.size() - i - 12) break;
    const std::string_view type = s.substr(i + 4, 4);
    // The case of the first letter tells a chunk that a decoder needs; only these four are defined.
    if (type == "IHDR" || type == "PLTE" || type == "IDAT" || type == "IEND") out += s.substr(i, length + 12);
    if (type == "IEND") return out;
    i += length + 12;
  }
  return BadInput("is a damaged PNG");
}

// A segment's marker and length, and its data.
std::string Segment(std::uint32_t marker, std::string_view data) {
  const std::size_t length = data.size() + 2;
  std::string out = {'\xff', static_cast<char>(marker), static_cast<char>(length >> 8),
                     static_cast<char>(length & 0xff)};
  return out += data;
}

std::string PlainSegment(std::uint32_t marker, std::string_view data) {
  constexpr std::string_view kJfif("JFIF\0", 5), kAdobe("Adobe", 5);
  // Version 1.01, no density, no preview.
  constexpr std::string_view kPlainJfif("JFIF\0\x01\x01\0\0\x01\0\x01\0\0", 14);
  if (marker == 0xe0) return data.substr(0, 5) == kJfif ? Segment(marker, kPlainJfif) : "";
  if (marker == 0xee) {  // version, flags and the colour transform
    return data.substr(0, 5) == kAdobe && data.size() >= 12 ? Segment(marker, data.substr(0, 12)) : "";
  }
  const bool other_app = marker >= 0xe0 && marker <= 0xef, comment = marker == 0xfe,
             reserved = marker >= 0xf0 && marker <= 0xfd;
  return other_app || comment || reserved ? "" : Segment(marker, data);
}

// Where the compressed data that starts at i ends: at a marker that is neither a stuffed byte nor a restart.
std::size_t ScanEnd(std::string_view s, std::size_t i) {
  for (; i + 1 < s.size(); ++i) {
    if (Byte(s, i) != 0xff) continue;
    const std::uint32_t next = Byte(s, i + 1);
    if (next != 0 && next != 0xff && (next < 0xd0 || next > 0xd7)) return i;
  }
  return s.size();
}

Result<std::string> PlainJpeg(std::string_view s) {
  std::string out("\xff\xd8");
  for (std::size_t i = 2; i + 1 < s.size();) {
    if (Byte(s, i) != 0xff) break;
    const std::uint32_t marker = Byte(s, i + 1);
    if (marker == 0xff) {  // fill byte
      ++i;
      continue;
    }
    if (marker == 0xd9) return out += "\xff\xd9";
    if (i + 4 > s.size()) break;
    const std::size_t length = Big16(s, i + 2);
    if (length < 2 || length > s.size() - i - 2) break;
    out += PlainSegment(marker, s.substr(i + 4, length - 2));
    i += 2 + length;
    if (marker != 0xda) continue;
    const std::size_t end = ScanEnd(s, i);
    out += s.substr(i, end - i);
    i = end;
  }
  return BadInput("is a damaged JPEG");
}

}  // namespace

Result<std::string> WithoutMetadata(std::string_view bytes) {
  if (bytes.substr(0, kPngStart.size()) == kPngStart) return PlainPng(bytes);
  if (bytes.substr(0, 2) == "\xff\xd8") return PlainJpeg(bytes);
  return BadInput("is neither a PNG nor a JPEG image");
}

}  // namespace dorsum
