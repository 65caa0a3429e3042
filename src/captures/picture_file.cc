// SPDX-License-Identifier: Apache-2.0
#include "captures/picture_file.h"

#include <string>

#include "base/files.h"
#include "captures/jpeg_image.h"
#include "captures/png_image.h"

namespace dorsum {

Status WritePictureFile(const CameraDesign& camera, const cv::Mat& bgr, const std::filesystem::path& stem) {
  const bool png = camera.format == "png";
  return WriteFile(stem.string() + (png ? ".png" : ".jpg"),
                   png ? EncodePng(bgr) : EncodeJpeg(bgr, camera.jpeg_quality));
}

Result<cv::Mat> ThroughStream(const CameraDesign& camera, const cv::Mat& bgr) {
  if (camera.stream_jpeg_quality <= 0) return bgr;
  return DecodeJpeg(EncodeJpeg(bgr, camera.stream_jpeg_quality), bgr.size());
}

}  // namespace dorsum
