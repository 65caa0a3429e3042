// SPDX-License-Identifier: Apache-2.0
#include "captures/image_header.h"

#include <cstdint>

#include <zlib.h>

namespace dorsum {
namespace {

std::uint32_t Byte(std::string_view s, std::size_t i) { return static_cast<unsigned char>(s[i]); }
std::uint32_t Big16(std::string_view s, std::size_t i) { return Byte(s, i) << 8 | Byte(s, i + 1); }
std::uint32_t Big32(std::string_view s, std::size_t i) { return Big16(s, i) << 16 | Big16(s, i + 2); }

// Whether all chunks are there with the right checksums, up to IEND.
bool ChunksAreIntact(std::string_view s) {
  for (std::size_t i = 8; i + 12 <= s.size();) {
    const std::size_t length = Big32(s, i);
    if (length > s.size() - i - 12) return false;
    const std::string_view chunk = s.substr(i + 4, length + 4);  // its type and its data
    const auto* bytes = reinterpret_cast<const unsigned char*>(chunk.data());
    if (crc32_z(0, bytes, chunk.size()) != Big32(s, i + 8 + length)) return false;
    if (chunk.substr(0, 4) == "IEND") return true;
    i += length + 12;
  }
  return false;
}

Result<ImageHeader> ReadPng(std::string_view s) {
  if (s.size() < 33 || s.substr(12, 4) != "IHDR") return BadInput("is a damaged PNG");
  ImageHeader h;
  h.format = "PNG";
  const std::uint32_t width = Big32(s, 16), height = Big32(s, 20);
  if (width == 0 || height == 0 || width > 0x7fffffff || height > 0x7fffffff)
    return BadInput("is a damaged PNG");
  h.width = static_cast<int>(width);
  h.height = static_cast<int>(height);
  h.bits = static_cast<int>(Byte(s, 24));
  switch (Byte(s, 25)) {
    case 0:
      h.channels = 1;
      break;
    case 2:
      h.channels = 3;
      break;
    case 3:
      h.channels = 3;
      h.bits = 8;
      break;  // palette of colours
    case 4:
      h.channels = 2;
      break;
    case 6:
      h.channels = 4;
      break;
    default:
      return BadInput("is a damaged PNG");
  }
  h.complete = s.substr(s.size() - 8, 4) == "IEND" || s.find("IEND", 33) != std::string_view::npos;
  h.intact = ChunksAreIntact(s);
  return h;
}

bool IsFrameHeader(std::uint32_t marker) {
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

Result<ImageHeader> ReadJpeg(std::string_view s) {
  std::size_t i = 2;
  while (i + 9 < s.size()) {
    if (Byte(s, i) != 0xff) return BadInput("is a damaged JPEG");
    const std::uint32_t marker = Byte(s, i + 1);
    if (marker == 0xff) {  // fill byte
      ++i;
      continue;
    }
    if (IsFrameHeader(marker)) {
      ImageHeader h;
      h.format = "JPEG";
      h.bits = static_cast<int>(Byte(s, i + 4));
      h.height = static_cast<int>(Big16(s, i + 5));
      h.width = static_cast<int>(Big16(s, i + 7));
      h.channels = i + 9 < s.size() ? static_cast<int>(Byte(s, i + 9)) : 0;
      if (h.width == 0 || h.height == 0) return BadInput("is a damaged JPEG");
      // Some cameras pad the file, so the end marker may not be the last two bytes.
      h.complete = s.rfind("\xff\xd9") != std::string_view::npos && s.rfind("\xff\xd9") > i;
      return h;
    }
    if (marker == 0xd9 || marker == 0xda) break;
    i += 2 + Big16(s, i + 2);
  }
  return BadInput("is a damaged JPEG");
}

}  // namespace

Result<ImageHeader> ReadImageHeader(std::string_view bytes) {
  if (bytes.empty()) return BadInput("is empty");
  if (bytes.size() >= 8 && bytes.substr(0, 8) == std::string_view("\x89PNG\r\n\x1a\n", 8))
    return ReadPng(bytes);
  if (bytes.size() >= 4 && Byte(bytes, 0) == 0xff && Byte(bytes, 1) == 0xd8) return ReadJpeg(bytes);
  return BadInput("is neither a PNG nor a JPEG image");
}

}  // namespace dorsum
