// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace dorsum {

// A serial port, 8N1 without flow control, that nobody else may use meanwhile. Opened through the system
// rather than libserialport, which takes only names right below /dev: no /dev/serial/by-id/..., no link that
// a udev rule makes, no pseudo-terminal. Opening one resets most Arduinos.
class SerialPort {
 public:
  // `baud` is one of the speeds that the system has a name for, 300 to 4000000. A device error says what is
  // wrong with the port: not there, no permission, in use, no serial port.
  static Result<std::unique_ptr<SerialPort>> Open(const std::string& path, int baud);
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;
  ~SerialPort();

  // What has come in, waiting up to `timeout_s` for the first byte; empty when none came. A device error when
  // the port is gone.
  Result<std::string> Read(double timeout_s);
  // All of it, or a device error when the port is gone or takes nothing for a second.
  Status Write(std::string_view bytes);

  const std::string& path() const { return path_; }
  bool gone() const { return gone_; }  // found to be, by a read or a write

 private:
  SerialPort(std::string path, int handle) : path_(std::move(path)), handle_(handle) {}
  Error Gone();

  std::string path_;
  int handle_;
  bool gone_ = false;
};

// Ports of USB devices, by name: "/dev/ttyACM0", "/dev/ttyUSB0".
std::vector<std::string> UsbSerialPorts();

}  // namespace dorsum
