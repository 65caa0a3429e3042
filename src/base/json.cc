// SPDX-License-Identifier: Apache-2.0
#include "base/json.h"

#include <cmath>
#include <sstream>

#include "base/files.h"

namespace dorsum {
namespace {

const Json& EmptyObject() {
  static const Json kEmpty = Json::object();
  return kEmpty;
}

const Json& EmptyArray() {
  static const Json kEmpty = Json::array();
  return kEmpty;
}

// The value's beginning in ASCII, so that no character is cut in two.
std::string Shown(const Json& value) {
  return value.dump(-1, ' ', /*ensure_ascii=*/true, Json::error_handler_t::replace).substr(0, 40);
}

std::string RangeText(double min, double max) {
  std::ostringstream out;
  out << "between " << min << " and " << max;
  return out.str();
}

}  // namespace

Result<Json> ReadJson(const std::filesystem::path& path) {
  DORSUM_ASSIGN_OR_RETURN(const std::string text, ReadFile(path, std::size_t{256} << 20));
  // NaN and Infinity are not JSON: the parser refuses them, as it should.
  Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded()) {
    const bool nan = text.find("NaN") != std::string::npos || text.find("Infinity") != std::string::npos;
    return BadInput(path.string() + " is not valid JSON" + (nan ? " (it holds NaN or Infinity)" : "") +
                    "; write it again or restore it");
  }
  return json;
}

Status WriteJson(const std::filesystem::path& path, const Json& json) {
  // Names of files may hold any bytes; those that are not UTF-8 are replaced, since dump() would throw.
  return WriteFile(path, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

JsonReader::JsonReader(const Json& object, std::string where) : object_(&object), where_(std::move(where)) {
  if (!object.is_object()) {
    object_ = &EmptyObject();
    failed_ = true;
    message_ = where_ + ": a JSON object is expected";
  }
}

void JsonReader::Fail(const std::string& key, const std::string& what) {
  if (failed_) return;
  failed_ = true;
  message_ = where_ + ": " + (key.empty() ? "" : "'" + key + "' ") + what;
}

Status JsonReader::status() const { return failed_ ? Status(BadInput(message_)) : Status(); }

bool JsonReader::Has(const std::string& key) const { return object_->contains(key); }

const Json* JsonReader::Find(const std::string& key) {
  if (failed_) return nullptr;
  const auto it = object_->find(key);
  if (it == object_->end()) {
    Fail(key, "is missing");
    return nullptr;
  }
  return &*it;
}

double JsonReader::Number(const std::string& key, double min, double max) {
  const Json* j = Find(key);
  if (j == nullptr) return 0.0;
  const double value = j->is_number() ? j->get<double>() : std::nan("");
  if (!std::isfinite(value) || value < min || value > max) {
    Fail(key, "must be a number " + RangeText(min, max) + ", not " + Shown(*j));
    return 0.0;
  }
  return value;
}

int JsonReader::Integer(const std::string& key, int min, int max) {
  const double value = Number(key, min, max);
  if (value != std::floor(value)) {
    Fail(key, "must be a whole number");
    return 0;
  }
  return static_cast<int>(value);
}

std::string JsonReader::Text(const std::string& key) {
  const Json* j = Find(key);
  if (j == nullptr) return {};
  if (!j->is_string()) {
    Fail(key, "must be a text");
    return {};
  }
  return j->get<std::string>();
}

bool JsonReader::Bool(const std::string& key) {
  const Json* j = Find(key);
  if (j == nullptr) return false;
  if (!j->is_boolean()) {
    Fail(key, "must be true or false");
    return false;
  }
  return j->get<bool>();
}

std::vector<double> JsonReader::Numbers(const std::string& key, int count, double min, double max) {
  std::vector<double> out;
  const Json* j = Find(key);
  if (j == nullptr) {
    out.resize(count > 0 ? static_cast<std::size_t>(count) : 0, 0.0);
    return out;
  }
  if (!j->is_array() || (count >= 0 && j->size() != static_cast<std::size_t>(count))) {
    Fail(key, count >= 0 ? "must be a list of " + std::to_string(count) + " numbers"
                         : "must be a list of numbers");
  } else {
    for (const Json& item : *j) {
      const double value = item.is_number() ? item.get<double>() : std::nan("");
      if (!std::isfinite(value) || value < min || value > max) {
        Fail(key, "must hold numbers " + RangeText(min, max) + ", not " + Shown(item));
        break;
      }
      out.push_back(value);
    }
  }
  if (count >= 0) out.resize(static_cast<std::size_t>(count), 0.0);
  return out;
}

const Json& JsonReader::Object(const std::string& key) {
  const Json* j = Find(key);
  if (j == nullptr) return EmptyObject();
  if (!j->is_object()) {
    Fail(key, "must be an object");
    return EmptyObject();
  }
  return *j;
}

const Json& JsonReader::Array(const std::string& key, int max_count) {
  const Json* j = Find(key);
  if (j == nullptr) return EmptyArray();
  if (!j->is_array() || j->size() > static_cast<std::size_t>(max_count)) {
    Fail(key, "must be a list of at most " + std::to_string(max_count) + " entries");
    return EmptyArray();
  }
  return *j;
}

void JsonReader::Schema(const std::string& schema, int version) {
  const std::string found = Text("schema");
  if (failed_ || found != schema) {
    failed_ = true;
    message_ = where_ + " is not a " + schema + " file" + (found.empty() ? "" : " but a " + found + " file");
    return;
  }
  const int found_version = Integer("version", 1, 1000000);
  if (found_version > version) {
    Fail("version", "is " + std::to_string(found_version) + ", newer than this program reads (" +
                        std::to_string(version) + "); use a newer program");
  }
}

}  // namespace dorsum
