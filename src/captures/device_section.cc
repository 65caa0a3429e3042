// SPDX-License-Identifier: Apache-2.0
#include "captures/device_section.h"

#include <cstdlib>
#include <sstream>
#include <utility>

namespace dorsum {
namespace {

std::string RangeText(double min, double max) {
  return "from " + DeviceSection::Text(min) + " to " + DeviceSection::Text(max);
}

}  // namespace

DeviceSection::DeviceSection(const toml::table& table, std::string prefix, std::string file,
                             std::string* error)
    : table_(&table), prefix_(std::move(prefix)), file_(std::move(file)), error_(error) {}

std::string DeviceSection::Text(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

void DeviceSection::Read(std::string_view key, double& value, double min, double max) {
  const toml::node* node = Find(key);
  if (node == nullptr) return;
  if (const auto number = Checked(*node, key, min, max)) value = *number;
}

void DeviceSection::Read(std::string_view key, int& value, int min, int max) {
  const toml::node* node = Find(key);
  if (node == nullptr) return;
  if (!node->is_integer()) return FailNode(key, *node, "a whole number " + RangeText(min, max));
  if (const auto number = Checked(*node, key, min, max)) value = static_cast<int>(*number);
}

void DeviceSection::Read(std::string_view key, std::string& value) {
  const toml::node* node = Find(key);
  if (node == nullptr) return;
  if (!node->is_string()) return FailNode(key, *node, "a text in quotes");
  value = **node->as_string();
}

void DeviceSection::Read(std::string_view key, bool& value) {
  const toml::node* node = Find(key);
  if (node == nullptr) return;
  if (!node->is_boolean()) return FailNode(key, *node, "true or false");
  value = **node->as_boolean();
}

void DeviceSection::Read(std::string_view key, Eigen::Vector3d& value, double min_z, double max_z) {
  const std::vector<double> list = ReadList(key, 3, -5000.0, 5000.0);
  if (list.empty()) return;
  value = {list[0], list[1], list[2]};
  if (!(value.z() >= min_z && value.z() <= max_z)) {
    Fail(key, "at height " + Text(value.z()), "at a height " + RangeText(min_z, max_z) + " mm");
  }
}

std::vector<double> DeviceSection::ReadList(std::string_view key, int count, double min, double max) {
  const toml::node* node = Find(key);
  if (node == nullptr) return {};
  const toml::array* array = node->as_array();
  const std::string wanted = (count > 0 ? "a list of " : "a list of 1 to ") +
                             std::to_string(std::abs(count)) + " numbers " + RangeText(min, max);
  const auto most = static_cast<std::size_t>(std::abs(count));
  if (array == nullptr || array->empty() || array->size() > most || (count > 0 && array->size() != most)) {
    FailNode(key, *node, wanted);
    return {};
  }
  std::vector<double> values;
  for (const toml::node& item : *array) {
    const auto number = Checked(item, key, min, max);
    if (!number) return {};
    values.push_back(*number);
  }
  return values;
}

bool DeviceSection::ReadChoice(std::string_view key, const std::string& first, const std::string& second,
                               bool is_second) {
  const toml::node* node = Find(key);
  if (node == nullptr) return is_second;
  const std::string word = node->value<std::string>().value_or("");
  if (word != first && word != second) FailNode(key, *node, "\"" + first + "\" or \"" + second + "\"");
  return word == second;
}

DeviceSection DeviceSection::Sub(std::string_view key) {
  static const toml::table kEmpty;
  const toml::node* node = Find(key);
  if (node != nullptr && !node->is_table()) FailNode(key, *node, "a [" + std::string(key) + "] table");
  const toml::table* table = node != nullptr && node->is_table() ? node->as_table() : &kEmpty;
  return {*table, prefix_ + std::string(key) + ".", file_, error_};
}

std::vector<DeviceSection> DeviceSection::Subs(std::string_view key, int max) {
  std::vector<DeviceSection> sections;
  const std::string wanted = "1 to " + std::to_string(max) + " tables [[" + std::string(key) + "]]";
  const toml::node* node = Find(key);
  const toml::array* array = node != nullptr ? node->as_array() : nullptr;
  const std::size_t count = array != nullptr ? array->size() : 0;
  if (count < 1 || count > static_cast<std::size_t>(max) || !array->is_homogeneous<toml::table>()) {
    const bool no_list = node != nullptr && array == nullptr;
    Fail(key, no_list ? "no list" : "a list of " + std::to_string(count), wanted);
    return sections;
  }
  for (std::size_t i = 0; i < count; ++i) {
    sections.emplace_back(*array->get_as<toml::table>(i),
                          prefix_ + std::string(key) + "[" + std::to_string(i) + "].", file_, error_);
  }
  return sections;
}

void DeviceSection::RefuseUnknownKeys() {
  for (const auto& [key, node] : *table_) {
    if (known_.contains(std::string(key.str())) || !error_->empty()) continue;
    std::string names;
    for (const std::string& name : known_) names += (names.empty() ? "" : ", ") + name;
    *error_ = file_ + ": unknown key " + prefix_ + std::string(key.str()) + "; known here: " + names;
  }
}

void DeviceSection::Fail(std::string_view key, const std::string& value, const std::string& wanted) {
  if (!error_->empty()) return;
  *error_ = file_ + ": " + prefix_ + std::string(key) + " is " + value + "; it must be " + wanted;
}

const toml::node* DeviceSection::Find(std::string_view key) {
  known_.emplace(key);
  return table_->get(key);
}

void DeviceSection::FailNode(std::string_view key, const toml::node& node, const std::string& wanted) {
  std::ostringstream value;
  node.visit([&value](const auto& n) { value << n; });
  std::string text = value.str();
  std::replace(text.begin(), text.end(), '\n', ' ');
  Fail(key, text, wanted);
}

std::optional<double> DeviceSection::Checked(const toml::node& node, std::string_view key, double min,
                                             double max) {
  const bool is_number = node.is_integer() || node.is_floating_point();
  const double number = node.value<double>().value_or(0.0);
  if (!is_number || !(number >= min && number <= max)) {  // also refuses NaN
    FailNode(key, node, "a number " + RangeText(min, max));
    return std::nullopt;
  }
  return number;
}

}  // namespace dorsum
