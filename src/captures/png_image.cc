// SPDX-License-Identifier: Apache-2.0
#include "captures/png_image.h"

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <stdexcept>
#include <vector>

#include <png.h>
#include <zlib.h>

#include "captures/image_file.h"

namespace dorsum {
namespace {

void Silent(png_structp /*png*/, png_const_charp /*message*/) {}

// libpng's functions must not return from an error, and C cannot be thrown through.
[[noreturn]] void Escape(png_structp png, png_const_charp /*message*/) { png_longjmp(png, 1); }

void ReadBytes(png_structp png, png_bytep to, std::size_t count) {
  auto& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
  if (rest.size() < count) png_error(png, "end of data");
  std::memcpy(to, rest.data(), count);
  rest.remove_prefix(count);
}

void AppendBytes(png_structp png, png_bytep from, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(from), count);
}

void NothingToFlush(png_structp /*png*/) {}

// Nothing in these two may need a destructor: Escape jumps over it. `image` and `rows` are made by the
// caller.
bool ReadRows(png_structp png, png_infop info, cv::Mat* image, std::vector<png_bytep>* rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_info(png, info);
  const png_uint_32 width = png_get_image_width(png, info), height = png_get_image_height(png, info);
  const png_byte type = png_get_color_type(png, info);
  if (png_get_bit_depth(png, info) > 8 || static_cast<long>(width) * static_cast<long>(height) > kMaxPixels)
    return false;
  if (type == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png);
  if (type == PNG_COLOR_TYPE_GRAY) png_set_expand_gray_1_2_4_to_8(png);
  png_set_strip_alpha(png);
  png_set_bgr(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  const int channels = png_get_channels(png, info);
  image->create(static_cast<int>(height), static_cast<int>(width), CV_8UC(channels));
  if (png_get_rowbytes(png, info) != image->step[0]) return false;
  rows->resize(height);
  for (png_uint_32 r = 0; r < height; ++r) (*rows)[r] = image->ptr(static_cast<int>(r));
  png_read_image(png, rows->data());
  png_read_end(png, nullptr);
  return true;
}

bool WriteRows(png_structp png, png_infop info, const cv::Mat& image, int compression) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  const bool deep = image.depth() == CV_16U;
  png_set_compression_level(png, compression);
  if (compression == 1) {
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_set_compression_strategy(png, Z_RLE);
  }
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.cols), static_cast<png_uint_32>(image.rows),
               deep ? 16 : 8, image.channels() == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_set_bgr(png);
  if (deep) png_set_swap(png);  // PNG's numbers begin with the high byte
  for (int r = 0; r < image.rows; ++r) png_write_row(png, image.ptr(r));
  png_write_end(png, nullptr);
  return true;
}

}  // namespace

cv::Mat DecodePng(std::string_view bytes) {
  cv::Mat image;
  std::vector<png_bytep> rows;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, Escape, Silent);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  if (info == nullptr) throw std::bad_alloc();
  png_set_read_fn(png, &bytes, ReadBytes);
  const bool whole = ReadRows(png, info, &image, &rows);
  png_destroy_read_struct(&png, &info, nullptr);
  return whole ? image : cv::Mat();
}

std::string EncodePng(const cv::Mat& image, int compression) {
  const bool known = (image.depth() == CV_8U || image.depth() == CV_16U) &&
                     (image.channels() == 1 || image.channels() == 3) && !image.empty();
  if (!known) throw std::logic_error("EncodePng: a picture of 1 or 3 channels of 8 or 16 bits is needed");
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, Escape, Silent);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  if (info == nullptr) throw std::bad_alloc();
  png_set_write_fn(png, &bytes, AppendBytes, NothingToFlush);
  const bool written = WriteRows(png, info, image, std::clamp(compression, 0, 9));
  png_destroy_write_struct(&png, &info);
  if (!written) throw std::runtime_error("libpng cannot encode a picture of this size");
  return bytes;
}

}  // namespace dorsum
