// SPDX-License-Identifier: Apache-2.0
#include "captures/image_file.h"

#include <cstdint>

#include "base/files.h"
#include "captures/green_channel.h"
#include "captures/image_header.h"
#include "captures/jpeg_image.h"
#include "captures/png_image.h"

namespace dorsum {
namespace {

std::string SizeText(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

Status CheckHeader(const ImageHeader& h, const std::string& name, std::optional<cv::Size> expected) {
  const std::string size = SizeText(h.width, h.height);
  if (static_cast<long>(h.width) * h.height > kMaxPixels) {
    return BadInput(name + " is " + size + " pixels, more than any camera here has; capture it again");
  }
  if (h.bits != 8) {
    return BadInput(name + " has " + std::to_string(h.bits) +
                    " bits per channel; 8 are expected, so save it as 8 bit");
  }
  if (h.channels != 3) {
    return BadInput(name + " is " + (h.channels < 3 ? "a grey" : "not a plain colour") +
                    " image; the stripes are read from the green channel, so capture it in colour");
  }
  if (expected && (h.width != expected->width || h.height != expected->height)) {
    return BadInput(name + " is " + size + " pixels, but " + SizeText(expected->width, expected->height) +
                    " is expected; use images of one camera at one resolution");
  }
  if (!h.complete) return BadInput(name + " is cut off: its end is missing; copy or capture it again");
  if (!h.intact) return BadInput(name + " is damaged; copy or capture it again");
  return {};
}

}  // namespace

std::optional<std::filesystem::path> FindImage(const std::filesystem::path& dir, const std::string& name) {
  std::error_code ec;
  for (const char* extension : {".png", ".jpg", ".jpeg", ".PNG", ".JPG", ".JPEG"}) {
    const std::filesystem::path path = dir / (name + extension);
    if (std::filesystem::is_regular_file(path, ec)) return path;
  }
  return std::nullopt;
}

Result<std::filesystem::path> RequireImage(const std::filesystem::path& dir, const std::string& name) {
  if (auto path = FindImage(dir, name)) return *path;
  return BadInput("the image " + name + " (.jpg or .png) is missing in " + dir.string());
}

Result<cv::Mat> DecodeImage(const std::string& bytes, const std::string& name,
                            std::optional<cv::Size> expected, Channels channels) {
  const Result<ImageHeader> header = ReadImageHeader(bytes);
  if (!header.ok()) return BadInput(name + " " + header.error().message + "; copy or capture it again");
  DORSUM_RETURN_IF_ERROR(CheckHeader(*header, name, expected));
  if (header->format == "JPEG") {
    const cv::Mat image = DecodeJpeg(bytes, {header->width, header->height}, channels);
    if (image.empty()) return BadInput(name + " is damaged; copy or capture it again");
    return image;
  }
  cv::Mat image = DecodePng(bytes);
  if (image.type() != CV_8UC3 || image.cols != header->width || image.rows != header->height) {
    return BadInput(name + " cannot be decoded; copy or capture it again");
  }
  return channels == Channels::kGreen ? GreenChannel(image) : image;
}

Result<cv::Mat> ReadImage(const std::filesystem::path& path, std::optional<cv::Size> expected,
                          Channels channels) {
  DORSUM_ASSIGN_OR_RETURN(const std::string bytes, ReadFile(path, std::size_t{512} << 20));
  return DecodeImage(bytes, path.string(), expected, channels);
}

Status CheckExposure(const cv::Mat& image, const std::string& name) {
  constexpr int kBlack = 10, kWhite = 245;
  const int channels = image.channels(), green = channels / 2;
  bool bright = false, dim = false;  // whether there is a place that is not black, and one that is not white
  for (int v = 0; v < image.rows && !(bright && dim); ++v) {
    const auto* row = image.ptr<std::uint8_t>(v);
    for (int u = 0; u < image.cols; ++u) {
      const int grey = row[channels * u + green];
      bright = bright || grey >= kBlack;
      dim = dim || grey <= kWhite;
    }
  }
  if (!bright) return BadInput(name + " is black; check the light and the exposure");
  if (!dim) return BadInput(name + " is white all over; lower the exposure");
  return {};
}

}  // namespace dorsum
