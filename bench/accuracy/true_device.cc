// SPDX-License-Identifier: Apache-2.0
#include "accuracy/true_device.h"

#include <cmath>

#include "accuracy/capture_truth.h"
#include "base/json.h"

namespace dorsum::accuracy {
namespace {

Eigen::Vector3d Vector(JsonReader* json, const std::string& key) {
  const std::vector<double> v = json->Numbers(key, 3);
  return v.size() == 3 ? Eigen::Vector3d(v[0], v[1], v[2]) : Eigen::Vector3d::Zero();
}

}  // namespace

Result<DeviceGeometry> ReadTrueDevice(const std::filesystem::path& device_json) {
  DeviceGeometry device;
  DORSUM_ASSIGN_OR_RETURN(device.camera, ReadTrueCamera(device_json));
  DORSUM_ASSIGN_OR_RETURN(const Json file, ReadJson(device_json));
  JsonReader top(file, device_json.string());
  const Json& lasers = top.Array("lasers", 8);
  DORSUM_RETURN_IF_ERROR(top.status());
  for (const Json& one : lasers) {
    JsonReader json(one, device_json.string() + ": lasers");
    LaserGeometry laser;
    laser.laser = static_cast<int>(device.lasers.size());
    DiffractedFan fan;
    fan.origin = Vector(&json, "origin");
    fan.a = Vector(&json, "a");
    fan.b = Vector(&json, "b");
    fan.n = Vector(&json, "n");
    fan.fan_distance_mm = json.Number("s");
    fan.tilt = std::asin(json.Number("alpha_in", -1.0, 1.0));
    fan.step = json.Number("D");
    fan.form = json.Text("fan_model") == "flat" ? FanForm::kFlat : FanForm::kConical;
    laser.max_order = json.Integer("M", 0, 1000);
    laser.min_order = -laser.max_order;
    DORSUM_RETURN_IF_ERROR(json.status());
    laser.grating = fan.origin;
    laser.fan = fan;
    device.lasers.push_back(laser);
  }
  return device;
}

}  // namespace dorsum::accuracy
