// SPDX-License-Identifier: Apache-2.0
#include "device/fake_v4l2_test.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdarg>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "device/frame_source.h"

namespace dorsum {
namespace {

constexpr std::uint32_t kBufferBytes = 1U << 20U;
constexpr std::uint32_t kMaxBuffers = 8;

// The one that is there, for the two functions of the C library at the end.
std::atomic<FakeV4l2*>& Present() {
  static std::atomic<FakeV4l2*> present = nullptr;
  return present;
}

int Fail(int reason) {
  errno = reason;
  return -1;
}

}  // namespace

FakeV4l2::FakeV4l2(const std::filesystem::path& folder, Painter painter)
    : path_(folder / "video0"), painter_(std::move(painter)) {
  file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  struct stat status {};
  if (file_ < 0 || ftruncate(file_, off_t{kBufferBytes} * kMaxBuffers) != 0 || fstat(file_, &status) != 0)
    throw std::runtime_error("no file for the fake camera");
  inode_ = status.st_ino;
  Present() = this;
}

FakeV4l2::~FakeV4l2() {
  Present() = nullptr;
  close(file_);
}

bool FakeV4l2::Is(int file) const {
  struct stat status {};
  return fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_ino == inode_;
}

int FakeV4l2::SetFormat(v4l2_format& format) {
  auto& pixels = format.fmt.pix;
  if (std::find(formats.begin(), formats.end(), pixels.pixelformat) != formats.end())
    format_ = pixels.pixelformat;
  for (const cv::Size& size : sizes) {
    if (size == cv::Size(static_cast<int>(pixels.width), static_cast<int>(pixels.height))) size_ = size;
  }
  pixels.width = static_cast<std::uint32_t>(size_.width);
  pixels.height = static_cast<std::uint32_t>(size_.height);
  pixels.pixelformat = format_;
  pixels.bytesperline = 2 * pixels.width;
  pixels.sizeimage = kBufferBytes;
  return 0;
}

int FakeV4l2::Dequeue(v4l2_buffer& buffer) {
  if ((silent && !promised_) || queue_.empty() || !streams_) return Fail(EAGAIN);
  promised_ = false;
  const std::uint32_t index = queue_.front();
  queue_.erase(queue_.begin());
  const std::string bytes = painter_(frame_++);
  if (pwrite(file_, bytes.data(), bytes.size(), off_t{kBufferBytes} * index) < 0) return Fail(EIO);
  const double stamp_s = foreign_clock ? 12.0 : MonotonicSeconds() - exposed_before_s;
  buffer.index = index;
  buffer.length = kBufferBytes;
  buffer.bytesused = static_cast<std::uint32_t>(bytes.size());
  buffer.flags = V4L2_BUF_FLAG_MAPPED | V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
  buffer.timestamp.tv_sec = static_cast<time_t>(stamp_s);
  buffer.timestamp.tv_usec =
      static_cast<suseconds_t>((stamp_s - static_cast<double>(buffer.timestamp.tv_sec)) * 1e6);
  buffer.m.offset = kBufferBytes * index;
  return 0;
}

int FakeV4l2::HandleControl(unsigned long request, v4l2_control& control) {
  const auto found = controls.find(control.id);
  if (found == controls.end()) return Fail(EINVAL);
  if (request == VIDIOC_G_CTRL) {
    control.value = found->second.value;
    return 0;
  }
  // As uvcvideo: no hand at an exposure that the camera chooses itself.
  if (control.id == V4L2_CID_EXPOSURE_ABSOLUTE && controls.contains(V4L2_CID_EXPOSURE_AUTO) &&
      controls.at(V4L2_CID_EXPOSURE_AUTO).value != V4L2_EXPOSURE_MANUAL) {
    return Fail(EACCES);
  }
  found->second.value = std::clamp(control.value, found->second.min, found->second.max);
  return 0;
}

int FakeV4l2::Ioctl(unsigned long request, void* argument) {
  const std::lock_guard lock(mutex);
  if (gone) return Fail(ENODEV);
  switch (request) {
    case VIDIOC_QUERYCAP: {
      auto& capability = *static_cast<v4l2_capability*>(argument);
      capability = {};
      capability.capabilities = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING | V4L2_CAP_DEVICE_CAPS;
      capability.device_caps = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
      return 0;
    }
    case VIDIOC_G_FMT: {
      v4l2_format& format = *static_cast<v4l2_format*>(argument);
      format.fmt.pix.width = format.fmt.pix.height = format.fmt.pix.pixelformat = 0;
      return SetFormat(format);
    }
    case VIDIOC_S_FMT:
      return SetFormat(*static_cast<v4l2_format*>(argument));
    case VIDIOC_G_PARM:
    case VIDIOC_S_PARM:
      static_cast<v4l2_streamparm*>(argument)->parm.capture.timeperframe = {1, 30};
      return 0;
    case VIDIOC_REQBUFS: {
      auto& request_buffers = *static_cast<v4l2_requestbuffers*>(argument);
      request_buffers.count = std::min(request_buffers.count, kMaxBuffers);
      queue_.clear();
      return 0;
    }
    case VIDIOC_QUERYBUF: {
      auto& buffer = *static_cast<v4l2_buffer*>(argument);
      buffer.length = kBufferBytes;
      buffer.m.offset = kBufferBytes * buffer.index;
      return 0;
    }
    case VIDIOC_QBUF:
      queue_.push_back(static_cast<v4l2_buffer*>(argument)->index);
      return 0;
    case VIDIOC_DQBUF:
      return Dequeue(*static_cast<v4l2_buffer*>(argument));
    case VIDIOC_STREAMON:
    case VIDIOC_STREAMOFF:
      streams_ = request == VIDIOC_STREAMON;
      return 0;
    case VIDIOC_QUERYCTRL: {
      auto& query = *static_cast<v4l2_queryctrl*>(argument);
      const auto found = controls.find(query.id);
      if (found == controls.end()) return Fail(EINVAL);
      query.minimum = found->second.min;
      query.maximum = found->second.max;
      return 0;
    }
    case VIDIOC_G_CTRL:
    case VIDIOC_S_CTRL:
      return HandleControl(request, *static_cast<v4l2_control*>(argument));
    default:
      return Fail(ENOTTY);
  }
}

int FakeV4l2::Poll(short* revents, int timeout_ms) {
  std::unique_lock lock(mutex);
  if (gone) {
    *revents = POLLERR;
    return 1;
  }
  const bool due = promised_ = !silent && streams_ && !queue_.empty();
  const double wait_s = due ? interval_s : timeout_ms / 1000.0;
  lock.unlock();
  std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
  *revents = due ? POLLIN : 0;
  return due ? 1 : 0;
}

}  // namespace dorsum

// These two stand before the C library's for all of the test program.
// NOLINTBEGIN(readability-inconsistent-declaration-parameter-name)
extern "C" int ioctl(int file, unsigned long request, ...) noexcept {
  va_list arguments;
  va_start(arguments, request);
  void* argument = va_arg(arguments, void*);
  va_end(arguments);
  dorsum::FakeV4l2* camera = dorsum::Present();
  if (camera != nullptr && camera->Is(file)) return camera->Ioctl(request, argument);
  return static_cast<int>(syscall(SYS_ioctl, file, request, argument));
}

#ifndef __clang__  // which has no such warning
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // the header promises that poll() reads nothing
#endif
extern "C" int poll(pollfd* files, nfds_t count, int timeout_ms) {
  dorsum::FakeV4l2* camera = dorsum::Present();
  if (camera != nullptr && count == 1 && camera->Is(files->fd))
    return camera->Poll(&files->revents, timeout_ms);
  return static_cast<int>(syscall(SYS_poll, files, count, timeout_ms));
}
#ifndef __clang__
#pragma GCC diagnostic pop
#endif
// NOLINTEND(readability-inconsistent-declaration-parameter-name)
