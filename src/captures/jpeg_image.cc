// SPDX-License-Identifier: Apache-2.0
#include "captures/jpeg_image.h"

#include <csetjmp>
#include <cstdio>  // jpeglib.h needs it
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include <jerror.h>
#include <jpeglib.h>

#include "captures/green_channel.h"

namespace dorsum {
namespace {

struct JpegErrors {
  jpeg_error_mgr manager{};
  std::jmp_buf escape{};
  bool damaged = false;
};

JpegErrors& ErrorsOf(j_common_ptr info) { return *static_cast<JpegErrors*>(info->client_data); }

// libjpeg's functions must not return from a fatal error, and C cannot be thrown through.
[[noreturn]] void OnFatalError(j_common_ptr info) { std::longjmp(ErrorsOf(info).escape, 1); }

void OnMessage(j_common_ptr info, int level) {
  if (level >= 0) return;  // a trace, no warning
  const jpeg_error_mgr& message = *info->err;
  switch (message.msg_code) {
    case JWRN_JFIF_MAJOR:
    case JWRN_ADOBE_XFORM:
    case JWRN_BOGUS_ICC:
      return;  // odd, but the pixels are not touched
    case JWRN_EXTRANEOUS_DATA: {
      const int stray_bytes = message.msg_parm.i[0], next_marker = message.msg_parm.i[1];
      if (next_marker == JPEG_EOI && stray_bytes <= kJpegPadding) return;
      break;
    }
    default:
      break;
  }
  ErrorsOf(info).damaged = true;
}

// Nothing here may need a destructor: OnFatalError jumps over it. `row` has room for a row of BGR where the
// image is green alone.
bool DecodeInto(cv::Mat* image, unsigned char* row, std::string_view bytes, JpegErrors* errors) {
  jpeg_decompress_struct info{};
  info.err = jpeg_std_error(&errors->manager);
  info.client_data = errors;
  errors->manager.error_exit = OnFatalError;
  errors->manager.emit_message = OnMessage;
  if (setjmp(errors->escape) != 0) {
    jpeg_destroy_decompress(&info);
    return false;
  }
  jpeg_create_decompress(&info);
  jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&info, TRUE);
  info.out_color_space = JCS_EXT_BGR;
  jpeg_start_decompress(&info);
  const bool fits = info.output_width == static_cast<JDIMENSION>(image->cols) &&
                    info.output_height == static_cast<JDIMENSION>(image->rows);
  while (fits && !errors->damaged && info.output_scanline < info.output_height) {
    unsigned char* const out = image->ptr(static_cast<int>(info.output_scanline));
    JSAMPROW to = row != nullptr ? row : out;
    jpeg_read_scanlines(&info, &to, 1);
    if (row != nullptr) TakeGreen(row, info.output_width, out);
  }
  const bool whole = fits && !errors->damaged;
  if (whole) jpeg_finish_decompress(&info);  // reads on to the end marker
  jpeg_destroy_decompress(&info);
  return whole && !errors->damaged;
}

// The same holds here. `out` belongs to the caller, who frees it.
bool EncodeInto(unsigned char** out, unsigned long* size, const cv::Mat& image, int quality, bool optimise,
                JpegErrors* errors) {
  jpeg_compress_struct info{};
  info.err = jpeg_std_error(&errors->manager);
  info.client_data = errors;
  errors->manager.error_exit = OnFatalError;
  errors->manager.emit_message = OnMessage;
  if (setjmp(errors->escape) != 0) {
    jpeg_destroy_compress(&info);
    return false;
  }
  jpeg_create_compress(&info);
  jpeg_mem_dest(&info, out, size);
  info.image_width = static_cast<JDIMENSION>(image.cols);
  info.image_height = static_cast<JDIMENSION>(image.rows);
  info.input_components = image.channels();
  info.in_color_space = image.channels() == 3 ? JCS_EXT_BGR : JCS_GRAYSCALE;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, quality, TRUE);
  info.optimize_coding = optimise ? TRUE : FALSE;
  jpeg_start_compress(&info, TRUE);
  while (info.next_scanline < info.image_height) {
    auto* row = const_cast<unsigned char*>(image.ptr(static_cast<int>(info.next_scanline)));
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  return true;
}

}  // namespace

std::string EncodeJpeg(const cv::Mat& image, int quality, bool optimise) {
  if (image.empty() || (image.type() != CV_8UC1 && image.type() != CV_8UC3))
    throw std::logic_error("EncodeJpeg: a grey or colour picture of 8 bits is needed");
  unsigned char* out = nullptr;
  unsigned long size = 0;
  JpegErrors errors;
  const bool written = EncodeInto(&out, &size, image, quality, optimise, &errors);
  std::string bytes(reinterpret_cast<const char*>(out), written ? size : 0);
  std::free(out);
  if (!written) throw std::runtime_error("libjpeg cannot encode a picture of this size");
  return bytes;
}

cv::Mat DecodeJpeg(std::string_view bytes, cv::Size size, Channels channels) {
  const bool green = channels == Channels::kGreen;
  cv::Mat image(size, green ? CV_8UC1 : CV_8UC3);
  std::vector<unsigned char> row(green ? 3 * static_cast<std::size_t>(size.width) : 0);
  JpegErrors errors;
  return DecodeInto(&image, green ? row.data() : nullptr, bytes, &errors) ? image : cv::Mat();
}

}  // namespace dorsum
