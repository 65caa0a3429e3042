// SPDX-License-Identifier: Apache-2.0
#include "surface/tiff_image.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

#include <tiffio.h>

namespace dorsum {
namespace {

// A file in memory.
struct Memory {
  std::string bytes;
  std::size_t at = 0;
};

Memory& MemoryOf(thandle_t handle) { return *static_cast<Memory*>(handle); }

tmsize_t Read(thandle_t handle, void* to, tmsize_t count) {
  Memory& m = MemoryOf(handle);
  const std::size_t there = m.bytes.size() - std::min(m.bytes.size(), m.at);
  const std::size_t n = std::min(static_cast<std::size_t>(count), there);
  std::memcpy(to, m.bytes.data() + m.at, n);
  m.at += n;
  return static_cast<tmsize_t>(n);
}

tmsize_t Write(thandle_t handle, void* from, tmsize_t count) {
  Memory& m = MemoryOf(handle);
  const auto n = static_cast<std::size_t>(count);
  m.bytes.resize(std::max(m.bytes.size(), m.at + n), '\0');
  std::memcpy(m.bytes.data() + m.at, from, n);
  m.at += n;
  return count;
}

toff_t Seek(thandle_t handle, toff_t by, int whence) {
  Memory& m = MemoryOf(handle);
  m.at = by + (whence == SEEK_CUR ? m.at : whence == SEEK_END ? m.bytes.size() : 0);
  return m.at;
}

int Close(thandle_t /*handle*/) { return 0; }
toff_t Size(thandle_t handle) { return MemoryOf(handle).bytes.size(); }

}  // namespace

std::string EncodeTiff(const cv::Mat1f& image) {
  Memory memory;
  TIFF* tiff = TIFFClientOpen("height", "w", &memory, Read, Write, Seek, Close, Size, nullptr, nullptr);
  if (tiff == nullptr) throw std::bad_alloc();
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, image.cols);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, image.rows);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 32);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
  TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, image.rows);
  bool written = true;
  std::vector<float> row(static_cast<std::size_t>(image.cols));  // libtiff may change what it is given
  for (int r = 0; written && r < image.rows; ++r) {
    std::copy_n(image.ptr<float>(r), row.size(), row.begin());
    written = TIFFWriteScanline(tiff, row.data(), static_cast<std::uint32_t>(r), 0) == 1;
  }
  TIFFClose(tiff);
  if (!written) throw std::runtime_error("libtiff cannot encode a picture of this size");
  return std::move(memory.bytes);
}

}  // namespace dorsum
