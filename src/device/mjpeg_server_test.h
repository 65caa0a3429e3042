// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace dorsum {

inline std::string JpegOf(const cv::Mat& image, int quality = 90) {
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
  return {bytes.begin(), bytes.end()};
}

// A network camera on 127.0.0.1: Motion JPEG over HTTP (multipart/x-mixed-replace). The function gives the
// bytes of frame i when it is due, called from the server's thread; what it gives need not be a JPEG. Frames
// should differ by some noise, as a sensor's do: a camera that repeats itself is taken for frozen.
// One viewer at a time; the next one is served when it has gone, with frames counted on.
class MjpegServer {
 public:
  enum class Act { kSend, kHold, kClose };  // send the frame; send nothing ever more; close the connection
  struct Part {
    Part(std::string bytes) : jpeg(std::move(bytes)) {}  // NOLINT(google-explicit-constructor)
    Part(Act a) : act(a) {}                              // NOLINT(google-explicit-constructor)
    Act act = Act::kSend;
    std::string jpeg;
  };
  using NextPart = std::function<Part(int frame)>;

  explicit MjpegServer(NextPart next, double interval_s = 1.0 / 30.0, bool answers = true)
      : next_(std::move(next)), interval_s_(interval_s), answers_(answers) {
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (listener_ < 0 || bind(listener_, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
        listen(listener_, 4) != 0 ||
        getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
      throw std::runtime_error("no port for the test's server");
    }
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { Serve(); });
  }
  MjpegServer(const MjpegServer&) = delete;
  MjpegServer& operator=(const MjpegServer&) = delete;
  ~MjpegServer() {
    stop_ = true;
    thread_.join();
    close(listener_);
  }

  std::string url() const { return "http://127.0.0.1:" + std::to_string(port_) + "/video"; }
  int sent() const { return sent_; }  // frames

 private:
  static constexpr int kPoll_ms = 20;

  // Waits until the socket is ready for that; false when the server stops.
  bool Ready(int file, short events) const {
    while (!stop_) {
      pollfd one{file, events, 0};
      if (poll(&one, 1, kPoll_ms) > 0) return true;
    }
    return false;
  }

  bool Send(int file, std::string_view bytes) const {
    while (!bytes.empty()) {
      if (!Ready(file, POLLOUT)) return false;
      const ssize_t n = send(file, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (n < 0 && errno != EAGAIN) return false;  // the viewer has gone
      if (n > 0) bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
  }

  // Until the time has passed, or the viewer has gone, or the server stops.
  bool Pause(int file, double seconds) const {
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (!stop_) {
      const double left = std::chrono::duration<double>(until - std::chrono::steady_clock::now()).count();
      if (left <= 0.0) return true;
      pollfd one{file, POLLRDHUP, 0};
      const int wait_ms = std::min(kPoll_ms, static_cast<int>(left * 1000.0) + 1);
      if (poll(&one, 1, wait_ms) > 0) return false;
    }
    return false;
  }

  void Stream(int file) {
    constexpr double kForever_s = 1e6;
    std::string request;
    char buffer[1024];
    while (request.find("\r\n\r\n") == std::string::npos) {
      if (!Ready(file, POLLIN)) return;
      const ssize_t n = recv(file, buffer, sizeof buffer, 0);
      if (n <= 0) return;
      request.append(buffer, static_cast<std::size_t>(n));
    }
    if (!answers_) {
      Pause(file, kForever_s);
      return;
    }
    if (!Send(file,
              "HTTP/1.0 200 OK\r\nCache-Control: no-store\r\n"
              "Content-Type: multipart/x-mixed-replace; boundary=frame\r\n\r\n")) {
      return;
    }
    while (!stop_) {
      const Part part = next_(frame_++);
      if (part.act == Act::kClose) return;
      if (part.act == Act::kHold) {
        Pause(file, kForever_s);
        return;
      }
      const std::string head =
          "--frame\r\nContent-Type: image/jpeg\r\nContent-Length: " + std::to_string(part.jpeg.size()) +
          "\r\n\r\n";
      if (!Send(file, head + part.jpeg + "\r\n")) return;
      ++sent_;
      if (!Pause(file, interval_s_)) return;
    }
  }

  void Serve() {
    while (Ready(listener_, POLLIN)) {
      const int file = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
      if (file < 0) continue;
      Stream(file);
      close(file);
    }
  }

  const NextPart next_;
  const double interval_s_;
  const bool answers_;
  int listener_ = -1;
  int port_ = 0;
  int frame_ = 0;
  std::atomic<int> sent_ = 0;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

}  // namespace dorsum
