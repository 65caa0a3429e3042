// SPDX-License-Identifier: Apache-2.0
#include "device/serial_port.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <libserialport.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "device/device_error.h"

namespace dorsum {
namespace {

constexpr std::pair<int, speed_t> kSpeeds[] = {
    {300, B300},         {600, B600},         {1200, B1200},       {2400, B2400},       {4800, B4800},
    {9600, B9600},       {19200, B19200},     {38400, B38400},     {57600, B57600},     {115200, B115200},
    {230400, B230400},   {460800, B460800},   {500000, B500000},   {576000, B576000},   {921600, B921600},
    {1000000, B1000000}, {1152000, B1152000}, {1500000, B1500000}, {2000000, B2000000}, {2500000, B2500000},
    {3000000, B3000000}, {3500000, B3500000}, {4000000, B4000000}};

Error CannotOpen(const std::string& path, int reason) {
  switch (reason) {
    case ENOENT:
    case ENXIO:
    case ENODEV:
      return DeviceError(
          "there is no port " + path +
          "; plug the light controller in, or correct controller.port in the device description");
    case EACCES:
    case EPERM:
      return DeviceError(
          "no permission to use " + path +
          "; join the group dialout (sudo usermod -aG dialout $USER, then log in anew) or add the "
          "udev rule of docs/light-controller.md");
    case EBUSY:
    case EWOULDBLOCK:
      return DeviceError(path + " is in use by another program; close that first");
    case ENOTTY:
      return DeviceError(path + " is no serial port; name the light controller's as controller.port");
    default:
      return DeviceError("cannot open " + path + ": " + std::strerror(reason) +
                         "; unplug the light controller and plug it in again");
  }
}

// Raw bytes, no flow control, and no line that a modem would have to raise first. 0 or the reason.
int SetUp(int handle, speed_t speed) {
  if (flock(handle, LOCK_EX | LOCK_NB) != 0) return errno;
  termios settings = {};
  if (tcgetattr(handle, &settings) != 0) return errno == EINVAL ? ENOTTY : errno;
  ioctl(handle, TIOCEXCL);
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD | HUPCL;
  settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS | CSTOPB | PARENB);
  settings.c_cc[VMIN] = 1;  // so that nothing to read and hung up differ
  settings.c_cc[VTIME] = 0;
  cfsetispeed(&settings, speed);
  cfsetospeed(&settings, speed);
  if (tcsetattr(handle, TCSANOW, &settings) != 0) return errno;
  tcflush(handle, TCIOFLUSH);
  return 0;
}

}  // namespace

Result<std::unique_ptr<SerialPort>> SerialPort::Open(const std::string& path, int baud) {
  const auto* speed = std::find_if(std::begin(kSpeeds), std::end(kSpeeds),
                                   [&](const auto& one) { return one.first == baud; });
  if (speed == std::end(kSpeeds)) {
    return DeviceError("no serial port runs at " + std::to_string(baud) +
                       " baud; set controller.baud to 115200, the firmware's");
  }
  const int handle = open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (handle < 0) return CannotOpen(path, errno);
  if (const int reason = SetUp(handle, speed->second); reason != 0) {
    close(handle);
    return CannotOpen(path, reason);
  }
  return std::unique_ptr<SerialPort>(new SerialPort(path, handle));
}

SerialPort::~SerialPort() {
  ioctl(handle_, TIOCNXCL);
  close(handle_);
}

Error SerialPort::Gone() {
  gone_ = true;
  return DeviceError("the light controller on " + path_ +
                     " is gone; check its cable and plug it in again, then start over");
}

Result<std::string> SerialPort::Read(double timeout_s) {
  pollfd wait = {handle_, POLLIN, 0};
  const int ready = poll(&wait, 1, static_cast<int>(std::max(0.0, timeout_s) * 1000.0 + 0.999));
  if (ready == 0 || (ready < 0 && errno == EINTR)) return std::string();
  char bytes[256];
  const ssize_t count = ready < 0 ? -1 : read(handle_, bytes, sizeof bytes);
  if (count > 0) return std::string(bytes, static_cast<std::size_t>(count));
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return std::string();
  return Gone();  // ready, and yet nothing to read: hung up
}

Status SerialPort::Write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(handle_, bytes.data(), bytes.size());
    if (count > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
      continue;
    }
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno != EAGAIN) return Gone();
    pollfd wait = {handle_, POLLOUT, 0};
    if (poll(&wait, 1, 1000) == 0) return Gone();
  }
  return {};
}

std::vector<std::string> UsbSerialPorts() {
  std::vector<std::string> names;
  sp_port** ports = nullptr;
  if (sp_list_ports(&ports) != SP_OK) return names;
  for (sp_port** port = ports; *port != nullptr; ++port) {
    if (sp_get_port_transport(*port) == SP_TRANSPORT_USB) names.emplace_back(sp_get_port_name(*port));
  }
  sp_free_port_list(ports);
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace dorsum
