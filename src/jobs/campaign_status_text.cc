// SPDX-License-Identifier: Apache-2.0
#include "jobs/campaign_names.h"
#include "jobs/campaign_status.h"

namespace dorsum {
namespace {

std::string Count(int n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

// "18 men, 2 women", in the order of the words.
std::string Groups(const std::map<std::string, int>& counts, const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    const auto it = counts.find(word);
    if (it == counts.end()) continue;
    const std::string many = word == "man" ? "men" : word == "woman" ? "women" : word;
    text += (text.empty() ? "" : ", ") + Count(it->second, word, many);
  }
  return text.empty() ? "none" : text;
}

std::string Row(const std::string& name, const std::string& value) {
  return name + std::string(name.size() < 14 ? 14 - name.size() : 1, ' ') + value + "\n";
}

std::string Of(int done, int planned) {
  return std::to_string(done) + (planned > 0 ? " of " + std::to_string(planned) : "");
}

Json QualityToJson(const CampaignQuality& q) {
  return {{"reconstructed", q.reconstructed},
          {"failed", q.failed},
          {"not_tried", q.not_tried},
          {"with_warnings", q.with_warnings},
          {"least_points", q.least_points},
          {"median_points", q.median_points},
          {"failures", q.failures}};
}

std::string QualityToText(const CampaignQuality& q) {
  const int tried = q.reconstructed + q.failed;
  std::string text =
      Row("surfaces", std::to_string(q.reconstructed) + " of " + std::to_string(tried) +
                          " captures that were tried, " + std::to_string(q.with_warnings) +
                          " of them with warnings; " + std::to_string(q.not_tried) + " not tried");
  if (q.reconstructed > 0) {
    text += Row("points",
                "median " + std::to_string(q.median_points) + ", least " + std::to_string(q.least_points));
  }
  for (const std::string& name : q.failures) text += Row("failed", name);
  return text;
}

}  // namespace

Json StatusToJson(const CampaignStatus& s) {
  Json missing = Json::array();
  for (const MissingCaptures& m : s.missing) {
    missing.push_back(
        {{"id", m.id}, {"session", m.session}, {"hand", HandWord(m.hand)}, {"captures", m.count}});
  }
  const CampaignPlan& plan = s.campaign.plan;
  Json hands = Json::array();
  for (const CampaignHand hand : plan.hands) hands.push_back(HandWord(hand));
  const CampaignDevice& device = s.campaign.device;
  Json json = {
      {"name", s.campaign.name},
      {"virtual", s.campaign.virtual_people.has_value()},
      {"plan",
       {{"people", plan.people}, {"sessions", plan.sessions}, {"captures", plan.captures}, {"hands", hands}}},
      {"device",
       {{"name", device.name}, {"resolution_px", {device.width, device.height}}, {"lasers", device.lasers}}},
      {"people", s.people},
      {"people_complete", s.complete},
      {"sexes", Json(s.sexes)},
      {"age_groups", Json(s.age_groups)},
      {"hands", s.hands},
      {"sessions", s.sessions},
      {"captures", s.captures},
      {"captures_planned", s.planned_captures},
      {"captures_lacking_a_laser", s.lacking_laser},
      {"captures_without_calibration", s.without_calibration},
      {"calibrations", s.calibrations},
      {"bytes", s.bytes},
      {"missing", missing},
      {"problems", s.problems}};
  if (s.quality) json["quality"] = QualityToJson(*s.quality);
  return json;
}

std::string StatusToText(const CampaignStatus& s) {
  const CampaignPlan& plan = s.campaign.plan;
  std::string text = s.campaign.name;
  if (s.campaign.virtual_people) {
    text += " (virtual people, seed " + s.campaign.virtual_people->seed + ")";
  }
  text += "\n";
  std::string hands;
  for (const CampaignHand hand : plan.hands)
    hands += (hands.empty() ? "" : " and ") + std::string(HandWord(hand));
  text += Row("plan", Count(plan.sessions, "session", "sessions") + " of each person, in each " +
                          Count(plan.captures, "capture", "captures") + " of the " + hands + " hand");
  text += Row("people", Of(s.people, plan.people) + ", " + std::to_string(s.complete) + " complete");
  text += Row("sexes", Groups(s.sexes, CampaignSexes()));
  text += Row("age groups", Groups(s.age_groups, CampaignAgeGroups()));
  text += Row("hands", std::to_string(s.hands));
  text += Row("sessions", std::to_string(s.sessions));
  text += Row("captures", Of(s.captures, s.planned_captures) + ", " + std::to_string(s.lacking_laser) +
                              " lacking a laser, " + std::to_string(s.without_calibration) +
                              " without calibration");
  text += Row("calibrations", std::to_string(s.calibrations));
  for (const MissingCaptures& m : s.missing) {
    text += Row("missing", m.id + ", session " + std::to_string(m.session) + ", " + HandWord(m.hand) + ": " +
                               Count(m.count, "capture", "captures"));
  }
  if (s.quality) text += QualityToText(*s.quality);
  for (const std::string& problem : s.problems) text += Row("problem", problem);
  return text;
}

}  // namespace dorsum
