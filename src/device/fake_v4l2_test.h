// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include <linux/videodev2.h>
#include <opencv2/core.hpp>

namespace dorsum {

// A webcam without a kernel: while it lives, ioctl() and poll() of this test program on its file are answered
// as a Video4Linux driver would, so that VideoCapture's own code for cameras runs. The file stands for the
// device and for its buffers, which VideoCapture maps. All else goes to the kernel as before.
class FakeV4l2 {
 public:
  struct Control {
    int value, min, max;
  };
  // The bytes of frame i in the present format.
  using Painter = std::function<std::string(int frame)>;

  FakeV4l2(const std::filesystem::path& folder, Painter painter);
  FakeV4l2(const FakeV4l2&) = delete;
  FakeV4l2& operator=(const FakeV4l2&) = delete;
  ~FakeV4l2();

  std::string device() const { return path_.string(); }

  // To be set before the camera is opened, or with the mutex held.
  std::mutex mutex;
  std::vector<cv::Size> sizes = {{320, 240}, {160, 120}};
  std::vector<std::uint32_t> formats = {V4L2_PIX_FMT_YUYV, V4L2_PIX_FMT_MJPEG};
  std::map<std::uint32_t, Control> controls;
  double interval_s = 0.005;
  double exposed_before_s = 0.02;  // the stamp, before the frame arrives
  bool foreign_clock = false;      // stamps of another clock, as some drivers have
  bool silent = false, gone = false;

  // What the program's ioctl() and poll() do with this camera's file.
  int Ioctl(unsigned long request, void* argument);
  int Poll(short* revents, int timeout_ms);
  bool Is(int file) const;

 private:
  int SetFormat(v4l2_format& format);
  int Dequeue(v4l2_buffer& buffer);
  int HandleControl(unsigned long request, v4l2_control& control);

  const std::filesystem::path path_;
  const Painter painter_;
  int file_ = -1;
  std::uint64_t inode_ = 0;
  cv::Size size_{160, 120};
  std::uint32_t format_ = V4L2_PIX_FMT_YUYV;
  std::vector<std::uint32_t> queue_;
  bool streams_ = false;
  bool promised_ = false;  // a frame, by poll()
  int frame_ = 0;
};

}  // namespace dorsum
