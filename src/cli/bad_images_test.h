// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/files.h"

namespace dorsum {

// Ways in which the image DIR/NAME.png can be no good, each with what the message must say of it.
struct BadImage {
  const char* what;
  const char* culprit;
  void (*spoil)(const std::filesystem::path& dir, const std::string& name);
};

inline void PutFile(const std::filesystem::path& path, const std::string& bytes) {
  ASSERT_TRUE(WriteFile(path, bytes).ok());
}
inline void PutImage(const std::filesystem::path& path, const cv::Mat& image) {
  ASSERT_TRUE(cv::imwrite(path.string(), image)) << path;
}
inline cv::Mat GetImage(const std::filesystem::path& path) {
  return cv::imread(path.string(), cv::IMREAD_UNCHANGED);
}

// The beginning of a PNG file, as large as you like.
inline std::string PngHeader(std::uint32_t width, std::uint32_t height) {
  const auto big = [](std::uint32_t n) {
    return std::string{static_cast<char>(n >> 24), static_cast<char>(n >> 16), static_cast<char>(n >> 8),
                       static_cast<char>(n)};
  };
  const std::string end("\0\0\0\0IEND\xae\x42\x60\x82", 12);
  return "\x89PNG\r\n\x1a\n" + big(13) + "IHDR" + big(width) + big(height) +
         std::string("\x08\x02\0\0\0", 5) + big(0) + end;
}

inline const std::vector<BadImage>& BadImages() {
  using Path = std::filesystem::path;
  using Name = std::string;
  static const std::vector<BadImage> kBad = {
      {"missing", "missing",
       [](const Path& dir, const Name& name) { std::filesystem::remove(dir / (name + ".png")); }},
      {"empty", "", [](const Path& dir, const Name& name) { PutFile(dir / (name + ".png"), ""); }},
      {"text", "",
       [](const Path& dir, const Name& name) { PutFile(dir / (name + ".png"), "not an image\n"); }},
      {"truncated PNG", "",
       [](const Path& dir, const Name& name) {
         const Path path = dir / (name + ".png");
         std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
       }},
      {"truncated JPEG", "",
       [](const Path& dir, const Name& name) {
         const Path path = dir / (name + ".jpg");
         PutImage(path, GetImage(dir / (name + ".png")));
         std::filesystem::remove(dir / (name + ".png"));
         std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
       }},
      {"of another size", "560x420",
       [](const Path& dir, const Name& name) {
         cv::Mat image = GetImage(dir / (name + ".png"));
         cv::resize(image, image, {400, 300});
         PutImage(dir / (name + ".png"), image);
       }},
      {"grey", "grey",
       [](const Path& dir, const Name& name) {
         cv::Mat image = GetImage(dir / (name + ".png"));
         cv::cvtColor(image, image, cv::COLOR_BGR2GRAY);
         PutImage(dir / (name + ".png"), image);
       }},
      {"16 bit", "16 bits",
       [](const Path& dir, const Name& name) {
         cv::Mat image = GetImage(dir / (name + ".png"));
         image.convertTo(image, CV_16U, 257.0);
         PutImage(dir / (name + ".png"), image);
       }},
      {"huge PNG", "20000x20000",
       [](const Path& dir, const Name& name) { PutFile(dir / (name + ".png"), PngHeader(20000, 20000)); }},
      {"huge JPEG", "20000x20000",
       [](const Path& dir, const Name& name) {
         std::filesystem::remove(dir / (name + ".png"));
         const std::string frame("\xff\xd8\xff\xc0\x00\x11\x08\x4e\x20\x4e\x20\x03\x01\x22\x00", 15);
         PutFile(dir / (name + ".jpg"), frame + std::string("\x02\x11\x01\x03\x11\x01\xff\xd9", 8));
       }},
      {"a PNG with a lying header", "",
       [](const Path& dir, const Name& name) { PutFile(dir / (name + ".png"), PngHeader(560, 420)); }},
      {"a folder", "",
       [](const Path& dir, const Name& name) {
         std::filesystem::remove(dir / (name + ".png"));
         std::filesystem::create_directory(dir / (name + ".png"));
       }},
  };
  return kBad;
}

}  // namespace dorsum
