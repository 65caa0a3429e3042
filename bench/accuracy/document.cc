// SPDX-License-Identifier: Apache-2.0
#include "accuracy/document.h"

#include "accuracy/document_tables.h"
#include "accuracy/limits.h"
#include "accuracy/results.h"
#include "accuracy/summary.h"
#include "accuracy/synthetic_stripes.h"
#include "accuracy/tables.h"
#include "base/files.h"

namespace dorsum::accuracy {
namespace {

// The tables of one set of results, by the names of their places.
void AddTables(const std::string& prefix, const Results& results, const std::string& group_of_all,
               const LimitTable& asked, std::map<std::string, std::string>* places) {
  const auto add = [&](const std::string& name, const std::string& design, const std::string& text) {
    std::string& place = (*places)[prefix + "/" + name];
    if (text.empty()) return;
    if (!place.empty()) place += "\n";
    if (group_of_all.empty()) place += "**" + design + "**\n\n";
    place += text;
  };
  for (const std::string& design : DesignsOf(results)) {
    const std::vector<std::string> rungs = RungsOf(results, design);
    const std::string acceptance =
        AcceptanceTable(results, design, group_of_all.empty() ? design : group_of_all, asked);
    add("acceptance", design, acceptance);
    for (const auto& [name, rung] :
         {std::pair("classic", rungs.front()), std::pair("default", rungs.back())}) {
      add(name + std::string(" captures"), design, CaptureTable(results, design, rung));
      add(name + std::string(" table 5.1"), design, Table51(results, design, rung));
      add(name + std::string(" table 5.2"), design, Table52(results, design, rung));
    }
    if (acceptance.empty()) continue;  // hard cases have no mean
    add("ladder", design, LadderTable(results, design));
    add("budget", design, BudgetTable(results, design));
  }
}

}  // namespace

Result<std::string> FillTemplate(const std::string& text, const std::map<std::string, std::string>& places) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = text.find("{{", at);
    out += text.substr(at, open - at);
    if (open == std::string::npos) break;
    const std::size_t close = text.find("}}", open);
    if (close == std::string::npos) return BadInput("the template has a {{ without its }}");
    const std::string name = text.substr(open + 2, close - open - 2);
    const auto place = places.find(name);
    if (place == places.end())
      return BadInput("the template asks for {{" + name + "}}, which is not measured");
    std::string filling = place->second;
    while (filling.ends_with('\n')) filling.pop_back();
    out += filling;
    at = close + 2;
  }
  return out;
}

Result<std::string> MakeDocument(const std::filesystem::path& bench) {
  DORSUM_ASSIGN_OR_RETURN(const std::string text, ReadFile(bench / "accuracy.md.in"));
  DORSUM_ASSIGN_OR_RETURN(const LimitTable asked, ReadLimits(bench / "asked.toml"));
  DORSUM_ASSIGN_OR_RETURN(const Results captures, ReadResults(bench / "results/captures.json"));
  DORSUM_ASSIGN_OR_RETURN(const Results devices, ReadResults(bench / "results/devices.json"));
  DORSUM_ASSIGN_OR_RETURN(const Results stripes, ReadResults(bench / "results/stripes.json"));
  std::map<std::string, std::string> places;
  if (!stripes.devices.empty()) places["stripes"] = SyntheticTable(stripes.devices.front());
  AddTables("captures", captures, "four lasers", asked, &places);
  AddTables("devices", devices, "", asked, &places);
  return FillTemplate(text, places);
}

}  // namespace dorsum::accuracy
