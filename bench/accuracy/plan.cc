// SPDX-License-Identifier: Apache-2.0
#include "accuracy/plan.h"

#include <algorithm>

#include "base/toml.h"

namespace dorsum::accuracy {
namespace {

Result<std::vector<std::string>> Texts(const toml::table& table, const char* key, const std::string& where) {
  std::vector<std::string> texts;
  const toml::array* array = table[key].as_array();
  if (array == nullptr) return BadInput(where + ": " + key + " must be a list of texts");
  for (const toml::node& node : *array) {
    const auto text = node.value<std::string>();
    if (!text) return BadInput(where + ": " + key + " must be a list of texts");
    texts.push_back(*text);
  }
  return texts;
}

}  // namespace

Result<std::vector<DesignPlan>> ReadPlan(const std::filesystem::path& path) {
  DORSUM_ASSIGN_OR_RETURN(const toml::table file, ReadTomlFile(path));
  const toml::array* designs = file["design"].as_array();
  if (designs == nullptr) return BadInput(path.string() + ": there is no [[design]]");
  std::vector<DesignPlan> plan;
  for (const toml::node& node : *designs) {
    const toml::table* table = node.as_table();
    if (table == nullptr) return BadInput(path.string() + ": design must be a list of tables");
    DesignPlan design;
    design.name = (*table)["name"].value_or("");
    const std::string device = (*table)["device"].value_or("");
    if (design.name.empty() || device.empty())
      return BadInput(path.string() + ": a design lacks its name or device");
    const std::string where = path.string() + ": " + design.name;
    design.device = path.parent_path() / device;
    design.in_default_run = (*table)["in_default_run"].value_or(true);
    DORSUM_ASSIGN_OR_RETURN(design.tuning, Texts(*table, "tuning", where));
    DORSUM_ASSIGN_OR_RETURN(design.held_out, Texts(*table, "held_out", where));
    DORSUM_ASSIGN_OR_RETURN(design.scenes, Texts(*table, "scenes", where));
    for (const std::string& seed : design.held_out) {
      if (std::find(design.tuning.begin(), design.tuning.end(), seed) != design.tuning.end())
        return BadInput(where + ": seed " + seed + " cannot be both for tuning and held out");
    }
    plan.push_back(std::move(design));
  }
  return plan;
}

}  // namespace dorsum::accuracy
