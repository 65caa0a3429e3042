// SPDX-License-Identifier: Apache-2.0
#include "accuracy/document_tables.h"

#include <algorithm>
#include <array>
#include <map>

#include "accuracy/markdown.h"
#include "accuracy/scene_kind.h"

namespace dorsum::accuracy {
namespace {

struct Row51 {
  const char* nrmse;
  const char* rmse;
};

// The document's Table 5.1: real boxes, three lasers.
const std::map<std::string, std::map<std::string, Row51>>& TheirTable51() {
  static const std::map<std::string, std::map<std::string, Row51>> kTable = {
      {"box13.5",
       {{"laser 0", {"0.1671", "1.2816"}},
        {"laser 1", {"0.1144", "0.6912"}},
        {"laser 2", {"0.1525", "0.3743"}},
        {"merged", {"0.1155", "0.9114"}}}},
      {"box25.5",
       {{"laser 0", {"0.2190", "1.4558"}},
        {"laser 1", {"0.1993", "0.7977"}},
        {"laser 2", {"0.1764", "0.4317"}},
        {"merged", {"0.1576", "1.0474"}}}}};
  return kTable;
}

// Its Table 5.2, mm: lasers 0 to 2 and merged of models 1 and 2, 1 and 3, 2 and 3.
constexpr std::array<std::array<const char*, 4>, 3> kTheirTable52 = {
    {{"0.0173", "0.0030", "0.0089", "0.0123"},
     {"0.0266", "0.0261", "0.0146", "0.0141"},
     {"0.0093", "0.0291", "0.0057", "0.0018"}}};

const DeviceResult* FirstDevice(const Results& results, const std::string& design, const std::string& rung) {
  for (const DeviceResult& d : results.devices) {
    if (d.design == design && d.rung == rung) return &d;
  }
  return nullptr;
}

}  // namespace

std::string Table51(const Results& results, const std::string& design, const std::string& rung) {
  const DeviceResult* device = FirstDevice(results, design, rung);
  std::string text;
  for (const auto& [scene, theirs] : TheirTable51()) {
    if (device == nullptr) break;
    const auto capture = std::find_if(
        device->captures.begin(), device->captures.end(),
        [&](const CaptureResult& c) { return DescribeScene(c.name).scene == scene && !c.models.empty(); });
    if (capture == device->captures.end()) continue;
    MarkdownTable table(
        {"model", "RMSE, mm", "the document's", "NRMSE", "the document's", "bias, mm", "points"});
    for (const ModelErrors& m : capture->models) {
      const auto their = theirs.find(m.model);
      const bool known = their != theirs.end();
      table.Row({m.model, Fixed(m.rmse_mm), known ? their->second.rmse : "–", Fixed(m.nrmse),
                 known ? their->second.nrmse : "–", Fixed(m.bias_mm), std::to_string(m.points)});
    }
    text += (text.empty() ? "" : "\n") +
            ("**Box " + scene.substr(3) + " mm** (`" + capture->name + "`)\n\n") + table.text();
  }
  return text;
}

std::string Table52(const Results& results, const std::string& design, const std::string& rung) {
  const DeviceResult* device = FirstDevice(results, design, rung);
  if (device == nullptr) return "";
  std::vector<std::pair<std::string, std::string>> pairs;
  std::vector<std::string> models;
  std::map<std::pair<std::string, std::string>, std::map<std::string, double>> differences;
  for (const RepeatDifference& r : device->repeats) {
    if (DescribeScene(r.first).scene != "box25.5") continue;
    const std::pair pair(r.first, r.second);
    if (!differences.contains(pair)) pairs.push_back(pair);
    if (std::find(models.begin(), models.end(), r.model) == models.end()) models.push_back(r.model);
    differences[pair][r.model] = r.diff_mm;
  }
  if (pairs.size() != kTheirTable52.size()) return "";
  std::vector<std::string> head = {"models"};
  head.insert(head.end(), models.begin(), models.end());
  MarkdownTable table(head);
  constexpr std::array kPairNames = {"1 and 2", "1 and 3", "2 and 3"};
  const std::map<std::string, std::size_t> their_column = {
      {"laser 0", 0}, {"laser 1", 1}, {"laser 2", 2}, {"merged", 3}};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::vector<std::string> row = {kPairNames[i]};
    for (const std::string& model : models) {
      const auto column = their_column.find(model);
      row.push_back(Fixed(differences[pairs[i]][model]) + " (" +
                    (column == their_column.end() ? "–" : kTheirTable52[i][column->second]) + ")");
    }
    table.Row(row);
  }
  return table.text();
}

}  // namespace dorsum::accuracy
