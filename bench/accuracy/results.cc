// SPDX-License-Identifier: Apache-2.0
#include "accuracy/results.h"

#include <cstdio>
#include <cstdlib>

namespace dorsum::accuracy {
namespace {

// Five figures are more than any of these numbers is worth, and keep the file readable.
double Short(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", value);
  return std::strtod(text, nullptr);
}

Json FiguresToJson(const Figures& figures) {
  Json json = Json::object();
  for (const auto& [name, value] : figures) json[name] = Short(value);
  return json;
}

Figures FiguresFromJson(const Json& json) {
  Figures figures;
  for (const auto& [name, value] : json.items()) figures[name] = value.get<double>();
  return figures;
}

Json ModelToJson(const ModelErrors& m) {
  return {{"model", m.model},
          {"points", m.points},
          {"rmse_mm", Short(m.rmse_mm)},
          {"nrmse", Short(m.nrmse)},
          {"bias_mm", Short(m.bias_mm)},
          {"median_abs_mm", Short(m.median_abs_mm)},
          {"p95_abs_mm", Short(m.p95_abs_mm)}};
}

ModelErrors ModelFromJson(const Json& json) {
  ModelErrors m;
  m.model = json.at("model");
  m.points = json.at("points");
  m.rmse_mm = json.at("rmse_mm");
  m.nrmse = json.at("nrmse");
  m.bias_mm = json.at("bias_mm");
  m.median_abs_mm = json.at("median_abs_mm");
  m.p95_abs_mm = json.at("p95_abs_mm");
  return m;
}

Json CaptureToJson(const CaptureResult& c) {
  Json json = {{"name", c.name}};
  if (!c.refused.empty()) json["refused"] = c.refused;
  if (!c.warnings.empty()) json["warnings"] = c.warnings;
  if (!c.figures.empty()) json["figures"] = FiguresToJson(c.figures);
  if (!c.budget.empty()) json["budget"] = FiguresToJson(c.budget);
  for (const ModelErrors& m : c.models) json["models"].push_back(ModelToJson(m));
  return json;
}

CaptureResult CaptureFromJson(const Json& json) {
  CaptureResult c;
  c.name = json.at("name");
  c.refused = json.value("refused", "");
  c.warnings = json.value("warnings", std::vector<std::string>());
  if (json.contains("figures")) c.figures = FiguresFromJson(json.at("figures"));
  if (json.contains("budget")) c.budget = FiguresFromJson(json.at("budget"));
  if (json.contains("models")) {
    for (const Json& m : json.at("models")) c.models.push_back(ModelFromJson(m));
  }
  return c;
}

Json DeviceToJson(const DeviceResult& d) {
  Json json = {{"design", d.design}, {"seed", d.seed}, {"rung", d.rung}};
  if (!d.refused.empty()) json["refused"] = d.refused;
  if (!d.figures.empty()) json["figures"] = FiguresToJson(d.figures);
  for (const CaptureResult& c : d.captures) json["captures"].push_back(CaptureToJson(c));
  for (const RepeatDifference& r : d.repeats) {
    json["repeats"].push_back(
        {{"first", r.first}, {"second", r.second}, {"model", r.model}, {"diff_mm", Short(r.diff_mm)}});
  }
  return json;
}

DeviceResult DeviceFromJson(const Json& json) {
  DeviceResult d;
  d.design = json.at("design");
  d.seed = json.at("seed");
  d.rung = json.at("rung");
  d.refused = json.value("refused", "");
  if (json.contains("figures")) d.figures = FiguresFromJson(json.at("figures"));
  if (json.contains("captures")) {
    for (const Json& c : json.at("captures")) d.captures.push_back(CaptureFromJson(c));
  }
  if (json.contains("repeats")) {
    for (const Json& r : json.at("repeats")) {
      d.repeats.push_back({r.at("first"), r.at("second"), r.at("model"), r.at("diff_mm")});
    }
  }
  return d;
}

}  // namespace

Json ResultsToJson(const Results& results) {
  Json json = {{"schema", "dorsum/accuracy"}, {"version", 1}, {"program", results.version}};
  json["devices"] = Json::array();
  for (const DeviceResult& d : results.devices) json["devices"].push_back(DeviceToJson(d));
  return json;
}

Result<Results> ReadResults(const std::filesystem::path& path) {
  DORSUM_ASSIGN_OR_RETURN(const Json json, ReadJson(path));
  Results results;
  try {
    results.version = json.at("program");
    for (const Json& d : json.at("devices")) results.devices.push_back(DeviceFromJson(d));
  } catch (const Json::exception& e) {
    return BadInput(path.string() + ": " + e.what());
  }
  return results;
}

}  // namespace dorsum::accuracy
