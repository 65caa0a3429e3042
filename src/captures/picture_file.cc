// SPDX-License-Identifier: Apache-2.0
#include "captures/picture_file.h"

#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "base/files.h"

namespace dorsum {

Status WritePictureFile(const CameraDesign& camera, const cv::Mat& bgr, const std::filesystem::path& stem) {
  const bool png = camera.format == "png";
  const std::string extension = png ? ".png" : ".jpg";
  const std::vector<int> parameters = png ? std::vector<int>{cv::IMWRITE_PNG_COMPRESSION, 3}
                                          : std::vector<int>{cv::IMWRITE_JPEG_QUALITY, camera.jpeg_quality};
  std::vector<unsigned char> bytes;
  if (!cv::imencode(extension, bgr, bytes, parameters)) {
    return Error{ErrorCode::kInternal, "cannot encode " + stem.string()};
  }
  return WriteFile(stem.string() + extension, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Result<cv::Mat> ThroughStream(const CameraDesign& camera, const cv::Mat& bgr) {
  if (camera.stream_jpeg_quality <= 0) return bgr;
  std::vector<unsigned char> stream;
  if (!cv::imencode(".jpg", bgr, stream, {cv::IMWRITE_JPEG_QUALITY, camera.stream_jpeg_quality})) {
    return Error{ErrorCode::kInternal, "cannot encode a picture of the camera's stream"};
  }
  return cv::imdecode(stream, cv::IMREAD_COLOR);
}

}  // namespace dorsum
