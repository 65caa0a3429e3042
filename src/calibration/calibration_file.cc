// SPDX-License-Identifier: Apache-2.0
#include "calibration/calibration_file.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "base/files.h"
#include "base/version.h"

namespace dorsum {
namespace {

constexpr const char* kSchema = "dorsum/calibration";
constexpr int kVersionOfSchema = 1;

Json ToJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Eigen::Vector3d ReadVector(JsonReader* reader, const std::string& key) {
  const std::vector<double> v = reader->Numbers(key, 3, -1e6, 1e6);
  return {v[0], v[1], v[2]};
}

Json CameraToJson(const Camera& c) {
  Json rotation = Json::array();
  for (int r = 0; r < 3; ++r) {
    for (int k = 0; k < 3; ++k) rotation.push_back(c.camera_from_world.rotation(r, k));
  }
  return {{"width", c.width},
          {"height", c.height},
          {"camera_matrix", {c.fx, 0.0, c.cx, 0.0, c.fy, c.cy, 0.0, 0.0, 1.0}},
          {"distortion", c.distortion},
          {"camera_from_world",
           {{"rotation", rotation}, {"translation_mm", ToJson(c.camera_from_world.translation)}}}};
}

Status ReadCamera(const Json& json, const std::string& where, Camera* c) {
  JsonReader reader(json, where + ", camera");
  c->width = reader.Integer("width", 16, 20000);
  c->height = reader.Integer("height", 16, 20000);
  const std::vector<double> k = reader.Numbers("camera_matrix", 9, -1e6, 1e6);
  const std::vector<double> d = reader.Numbers("distortion", 5, -1e3, 1e3);
  JsonReader pose(reader.Object("camera_from_world"), where + ", camera_from_world");
  DORSUM_RETURN_IF_ERROR(reader.status());
  const std::vector<double> rotation = pose.Numbers("rotation", 9, -1.0 - 1e-9, 1.0 + 1e-9);
  c->camera_from_world.translation = ReadVector(&pose, "translation_mm");
  DORSUM_RETURN_IF_ERROR(pose.status());
  c->fx = k[0];
  c->cx = k[2];
  c->fy = k[4];
  c->cy = k[5];
  for (std::size_t i = 0; i < 5; ++i) c->distortion[i] = d[i];
  for (int i = 0; i < 9; ++i)
    c->camera_from_world.rotation(i / 3, i % 3) = rotation[static_cast<std::size_t>(i)];
  const Eigen::Matrix3d& r = c->camera_from_world.rotation;
  if ((r * r.transpose() - Eigen::Matrix3d::Identity()).norm() > 1e-6 || r.determinant() < 0.0 ||
      c->fx <= 0.0 || c->fy <= 0.0 || c->Center().z() <= 0.0) {
    return BadInput(where + ": the camera's matrix or pose is not one of a camera above the backplane");
  }
  return {};
}

const char* FormName(FanForm form) {
  return form == FanForm::kFlat ? "flat" : form == FanForm::kConical ? "conical" : "general";
}

Json LaserToJson(const LaserGeometry& laser) {
  Json planes = Json::array();
  for (const PlaneSheet& s : laser.planes) {
    planes.push_back({{"order", s.order}, {"normal", ToJson(s.plane.normal)}, {"offset_mm", s.plane.offset}});
  }
  Json reference = Json::array();
  for (const ReferenceStripe& r : laser.reference) {
    reference.push_back({{"order", r.order},
                         {"middle_v_px", r.middle_v},
                         {"half_v_px", r.half_v},
                         {"u_px", r.u},
                         {"peak", r.peak}});
  }
  Json json = {{"laser", laser.laser},
               {"min_order", laser.min_order},
               {"max_order", laser.max_order},
               {"grating_mm", ToJson(laser.grating)},
               {"planes", planes},
               {"reference_stripes", reference},
               {"correction", {{"polynomial", laser.correction.c}}},
               {"residual_mm", laser.residual_mm}};
  if (laser.fan) {
    json["cone"] = {{"origin_mm", ToJson(laser.fan->origin)},
                    {"a", ToJson(laser.fan->a)},
                    {"b", ToJson(laser.fan->b)},
                    {"n", ToJson(laser.fan->n)},
                    {"fan_distance_mm", laser.fan->fan_distance_mm},
                    {"tilt_rad", laser.fan->tilt},
                    {"turn_rad", laser.fan->turn},
                    {"bow", EffectiveBow(*laser.fan)},
                    {"step", laser.fan->step},
                    {"form", FormName(laser.fan->form)}};
  }
  return json;
}

Status ReadCone(const Json& json, const std::string& where, LaserGeometry* laser) {
  JsonReader reader(json, where + ", cone");
  DiffractedFan fan;
  fan.origin = ReadVector(&reader, "origin_mm");
  fan.a = ReadVector(&reader, "a");
  fan.b = ReadVector(&reader, "b");
  fan.n = ReadVector(&reader, "n");
  fan.fan_distance_mm = reader.Number("fan_distance_mm", 0.0, 1000.0);
  fan.tilt = reader.Number("tilt_rad", -1.5, 1.5);
  fan.step = reader.Number("step", 1e-6, 1.0);
  const std::string form = reader.Text("form");
  bool known = false;
  for (const FanForm f : {FanForm::kFlat, FanForm::kConical, FanForm::kGeneral}) {
    if (form != FormName(f)) continue;
    fan.form = f;
    known = true;
  }
  if (!known) reader.Fail("form", "must be flat, conical or general");
  fan.bow = reader.Number("bow", -1.0, 1.0);
  fan.turn = reader.Number("turn_rad", -0.5, 0.5);
  Eigen::Matrix3d axes;
  axes << fan.a, fan.b, fan.n;
  if ((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm() > 1e-6) {
    reader.Fail("", "the axes a, b, n are not perpendicular unit vectors");
  }
  DORSUM_RETURN_IF_ERROR(reader.status());
  laser->fan = fan;
  return {};
}

Status ReadReference(const Json& list, const std::string& where, LaserGeometry* laser) {
  for (const Json& item : list) {
    JsonReader reader(item, where + ", reference_stripes of laser " + std::to_string(laser->laser));
    ReferenceStripe r;
    r.order = reader.Integer("order", -1000, 1000);
    r.middle_v = reader.Number("middle_v_px", -1e5, 1e5);
    r.half_v = reader.Number("half_v_px", 0.5, 1e5);
    const std::vector<double> u = reader.Numbers("u_px", 4, -1e6, 1e6),
                              peak = reader.Numbers("peak", 3, -1e6, 1e6);
    DORSUM_RETURN_IF_ERROR(reader.status());
    std::copy(u.begin(), u.end(), r.u.begin());
    std::copy(peak.begin(), peak.end(), r.peak.begin());
    laser->reference.push_back(r);
  }
  return {};
}

Status ReadLaser(const Json& json, const std::string& where, LaserGeometry* laser) {
  JsonReader reader(json, where + ", lasers");
  laser->laser = reader.Integer("laser", 0, 7);
  laser->min_order = reader.Integer("min_order", -1000, 1000);
  laser->max_order = reader.Integer("max_order", -1000, 1000);
  laser->grating = ReadVector(&reader, "grating_mm");
  laser->residual_mm = reader.Number("residual_mm", 0.0, 1e3);
  JsonReader correction(reader.Object("correction"), where + ", correction");
  const Json& planes = reader.Array("planes", 2001);
  const Json& reference = reader.Array("reference_stripes", 2001);
  DORSUM_RETURN_IF_ERROR(reader.status());
  const std::vector<double> c = correction.Numbers("polynomial", 6, -1e6, 1e6);
  DORSUM_RETURN_IF_ERROR(correction.status());
  for (std::size_t i = 0; i < 6; ++i) laser->correction.c[i] = c[i];
  for (const Json& item : planes) {
    JsonReader plane(item, where + ", planes of laser " + std::to_string(laser->laser));
    PlaneSheet sheet;
    sheet.order = plane.Integer("order", -1000, 1000);
    sheet.plane.normal = ReadVector(&plane, "normal");
    sheet.plane.offset = plane.Number("offset_mm", -1e5, 1e5);
    if (std::abs(sheet.plane.normal.norm() - 1.0) > 1e-6) plane.Fail("normal", "is not of unit length");
    if (!laser->planes.empty() && sheet.order != laser->planes.back().order + 1)
      plane.Fail("order", "leaves a gap");
    DORSUM_RETURN_IF_ERROR(plane.status());
    laser->planes.push_back(sheet);
  }
  DORSUM_RETURN_IF_ERROR(ReadReference(reference, where, laser));
  if (json.contains("cone")) DORSUM_RETURN_IF_ERROR(ReadCone(json["cone"], where, laser));
  if (laser->planes.empty() && !laser->fan) {
    return BadInput(where + ": laser " + std::to_string(laser->laser) +
                    " has no light sheets; calibrate again");
  }
  return {};
}

Status ReadPart(const Json& json, const std::string& where, PartReport* part) {
  JsonReader reader(json, where + ", parts");
  part->part = reader.Text("part");
  part->verdict = reader.Text("verdict");
  const std::string grade = reader.Text("grade");
  bool known = false;
  for (const Grade g : {Grade::kGood, Grade::kDoubtful, Grade::kBad}) {
    if (grade != GradeName(g)) continue;
    part->grade = g;
    known = true;
  }
  if (!known) reader.Fail("grade", "must be good, doubtful or bad");
  for (const Json& item : reader.Array("figures", 1000)) {
    JsonReader figure(item, where + ", figures");
    part->figures.push_back({figure.Text("name"), figure.Number("value"), figure.Text("unit")});
    DORSUM_RETURN_IF_ERROR(figure.status());
  }
  return reader.status();
}

}  // namespace

Json CalibrationToJson(const Calibration& c) {
  Json lasers = Json::array(), parts = Json::array(), sources = Json::array();
  for (const LaserGeometry& laser : c.device.lasers) lasers.push_back(LaserToJson(laser));
  for (const PartReport& part : c.parts) {
    Json figures = Json::array();
    for (const Figure& f : part.figures)
      figures.push_back({{"name", f.name}, {"value", f.value}, {"unit", f.unit}});
    parts.push_back({{"part", part.part},
                     {"grade", GradeName(part.grade)},
                     {"verdict", part.verdict},
                     {"figures", figures}});
  }
  for (const SourceFile& s : c.sources) sources.push_back({{"file", s.name}, {"sha256", s.sha256}});
  return {{"schema", kSchema},
          {"version", kVersionOfSchema},
          {"program", c.version},
          {"method", c.method},
          {"working_volume_mm", {c.device.min_height_mm, c.device.max_height_mm}},
          {"camera", CameraToJson(c.device.camera)},
          {"lasers", lasers},
          {"parts", parts},
          {"warnings", c.warnings},
          {"made_from", sources},
          {"background_image_base64", EncodeBase64(c.background)}};
}

Result<Calibration> CalibrationFromJson(const Json& json, const std::string& where) {
  JsonReader reader(json, where);
  reader.Schema(kSchema, kVersionOfSchema);
  Calibration c;
  c.version = reader.Text("program");
  c.method = reader.Text("method");
  const std::vector<double> volume = reader.Numbers("working_volume_mm", 2, -1000.0, 1000.0);
  const Json& camera = reader.Object("camera");
  const Json& lasers = reader.Array("lasers", 8);
  const Json& parts = reader.Array("parts", 100);
  const Json& warnings = reader.Array("warnings", 1000);
  const Json& sources = reader.Array("made_from", 100000);
  const std::string background = reader.Text("background_image_base64");
  DORSUM_RETURN_IF_ERROR(reader.status());
  c.device.min_height_mm = volume[0];
  c.device.max_height_mm = volume[1];
  if (volume[0] >= volume[1]) return BadInput(where + ": the working volume's bottom is not below its top");
  DORSUM_RETURN_IF_ERROR(ReadCamera(camera, where, &c.device.camera));
  for (const Json& item : lasers) {
    LaserGeometry laser;
    DORSUM_RETURN_IF_ERROR(ReadLaser(item, where, &laser));
    if (!c.device.lasers.empty() && laser.laser <= c.device.lasers.back().laser) {
      return BadInput(where + ": the lasers are not in ascending order");
    }
    c.device.lasers.push_back(laser);
  }
  if (c.device.lasers.empty()) return BadInput(where + " holds no laser; calibrate again");
  for (const Json& item : parts) {
    PartReport part;
    DORSUM_RETURN_IF_ERROR(ReadPart(item, where, &part));
    c.parts.push_back(part);
  }
  for (const Json& item : warnings) {
    if (item.is_string()) c.warnings.push_back(item.get<std::string>());
  }
  for (const Json& item : sources) {
    JsonReader source(item, where + ", made_from");
    c.sources.push_back({source.Text("file"), source.Text("sha256")});
    DORSUM_RETURN_IF_ERROR(source.status());
  }
  const Result<std::string> bytes = DecodeBase64(background);
  if (!bytes.ok()) return BadInput(where + ": the background image is damaged; calibrate again");
  c.background = *bytes;
  return c;
}

Status WriteCalibration(const std::filesystem::path& path, const Calibration& calibration) {
  return WriteJson(path, CalibrationToJson(calibration));
}

Result<Calibration> ReadCalibration(const std::filesystem::path& path) {
  DORSUM_ASSIGN_OR_RETURN(const Json json, ReadJson(path));
  return CalibrationFromJson(json, path.string());
}

}  // namespace dorsum
