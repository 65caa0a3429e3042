// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <toml++/toml.h>

namespace dorsum {

// One table of device.toml: reads typed values, remembers which keys it knows, and keeps the first error of
// the whole file in a string that all tables share. A key that is absent leaves its value as it is; so a
// reader is a flat list of reads and one check at its end.
class DeviceSection {
 public:
  DeviceSection(const toml::table& table, std::string prefix, std::string file, std::string* error);

  void Read(std::string_view key, double& value, double min, double max);
  void Read(std::string_view key, int& value, int min, int max);
  void Read(std::string_view key, std::string& value);
  void Read(std::string_view key, bool& value);
  void Read(std::string_view key, Eigen::Vector3d& value, double min_z, double max_z);
  template <std::size_t N>
  void Read(std::string_view key, std::array<double, N>& value, double min, double max) {
    const std::vector<double> list = ReadList(key, static_cast<int>(N), min, max);
    if (!list.empty()) std::copy(list.begin(), list.end(), value.begin());
  }
  // `count` numbers, or between 1 and -count of them; empty where there are none.
  std::vector<double> ReadList(std::string_view key, int count, double min, double max);
  // One of two words; true for the second.
  bool ReadChoice(std::string_view key, const std::string& first, const std::string& second, bool is_second);

  // A table of the file; an empty one where there is none.
  DeviceSection Sub(std::string_view key);
  // A list of 1 to max tables, [[key]].
  std::vector<DeviceSection> Subs(std::string_view key, int max);

  // To be called when all keys have been read.
  void RefuseUnknownKeys();
  void Fail(std::string_view key, const std::string& value, const std::string& wanted);
  static std::string Text(double value);

 private:
  const toml::node* Find(std::string_view key);
  void FailNode(std::string_view key, const toml::node& node, const std::string& wanted);
  std::optional<double> Checked(const toml::node& node, std::string_view key, double min, double max);

  const toml::table* table_;
  std::string prefix_, file_;
  std::string* error_;
  std::set<std::string> known_;
};

}  // namespace dorsum
