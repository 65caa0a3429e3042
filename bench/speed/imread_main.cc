// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include <opencv2/imgcodecs.hpp>

// Reads images and does nothing else: what a process that looks at a capture takes at least.
int main(int argc, char** argv) {
  std::size_t bytes = 0;
  for (int i = 1; i < argc; ++i) {
    const cv::Mat image = cv::imread(argv[i], cv::IMREAD_COLOR);
    bytes += image.total() * image.elemSize();
  }
  std::printf("%zu\n", bytes);
  return bytes > 0 ? 0 : 1;
}
