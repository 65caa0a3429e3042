// SPDX-License-Identifier: Apache-2.0
#include "simulator/simulate.h"

#include <set>

#include "base/files.h"
#include "base/json.h"
#include "base/random.h"
#include "captures/device_description.h"
#include "simulator/calibration_writer.h"
#include "simulator/capture_writer.h"
#include "simulator/disturbance.h"
#include "simulator/named_scene.h"
#include "simulator/population.h"
#include "simulator/truth_files.h"
#include "simulator/virtual_device.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPeopleName = "people.json";

Json SceneToJson(const SceneName& name, const std::optional<Motion>& motion) {
  Json json;
  json["schema"] = "dorsum.true_scene";
  json["version"] = 1;
  json["scene"] = name.folder;
  for (const SceneModifier& modifier : name.modifiers) {
    const ModifierRule& rule = RuleOf(modifier.kind);
    Json entry = {{"name", rule.word}};
    if (rule.number != ModifierRule::Number::kNone) entry["value"] = modifier.value;
    json["modifiers"].push_back(entry);
  }
  if (motion) {
    json["motion"] = {{"offset_mm", {motion->offset_mm.x(), motion->offset_mm.y(), motion->offset_mm.z()}},
                      {"from_laser", motion->from_laser}};
  }
  return json;
}

Status CheckTarget(const fs::path& out_dir, bool overwrite) {
  std::error_code ec;
  const bool in_use = fs::is_directory(out_dir, ec) && !fs::is_empty(out_dir, ec);
  if (!in_use || overwrite) return {};
  return BadInput(out_dir.string() + " is not empty; choose another folder, or allow to overwrite it");
}

// What an earlier run wrote belongs to another device and must not stay beside this one's.
Status RemoveEarlierRun(const fs::path& out_dir) {
  std::error_code ec;
  for (const char* name : {"calibration", "captures", "truth", kPeopleName}) {
    fs::remove_all(out_dir / name, ec);
    if (ec) return BadInput("cannot replace " + (out_dir / name).string() + ": " + ec.message());
  }
  return {};
}

// All captures that are asked for, each folder once.
Result<std::vector<SceneName>> PlanCaptures(const SimulateOptions& options,
                                            const std::vector<Person>& people) {
  std::vector<SceneName> plan;
  for (const std::string& text : options.scenes) {
    DORSUM_ASSIGN_OR_RETURN(SceneName name, ParseSceneName(text));
    plan.push_back(std::move(name));
  }
  for (const Person& person : people) {
    for (const PersonCapture& capture : person.captures) plan.push_back(SceneOf(person, capture));
  }
  std::set<std::string> folders;
  for (const SceneName& name : plan) {
    if (!folders.insert(name.folder).second)
      return UsageError("scene " + name.folder + " is asked for twice");
  }
  return plan;
}

// One capture with its truth; with modifiers, also what they did: scene.json and, where the device itself was
// another than at its calibration, that device.
Status WriteOneCapture(const VirtualDevice& device, const SceneName& name, Scene scene, std::uint64_t seed,
                       const fs::path& root, const Context& context) {
  const std::uint64_t capture_seed = NamedSeed("capture/" + name.folder, seed);
  const VirtualDevice now = Disturb(device, name.modifiers, capture_seed);
  CaptureExtras extras;
  extras.motion = MotionOf(name.modifiers, static_cast<int>(device.lasers.size()), capture_seed);
  extras.after = Has(name.modifiers, Modifier::kAfter);
  const fs::path truth = root / "truth" / name.folder;
  DORSUM_RETURN_IF_ERROR(WriteCapture(now, std::move(scene), extras, capture_seed,
                                      root / "captures" / name.folder, truth, context));
  if (DisturbsDevice(name.modifiers)) {
    DORSUM_RETURN_IF_ERROR(WriteJson(truth / "device.json", DeviceToJson(now)));
  }
  if (name.modifiers.empty()) return {};
  return WriteJson(truth / "scene.json", SceneToJson(name, extras.motion));
}

}  // namespace

Result<SimulateReport> Simulate(const SimulateOptions& options, const fs::path& out_dir,
                                const Context& context) {
  if (options.population < 0 || options.population > 10000)
    return UsageError("population must be 0 to 10000");
  if (options.sessions < 1 || options.sessions > 100) return UsageError("sessions must be 1 to 100");
  const std::vector<Person> people = DrawPopulation(options.population, options.sessions);
  DORSUM_ASSIGN_OR_RETURN(const std::vector<SceneName> plan, PlanCaptures(options, people));
  DeviceDescription description = DefaultDevice();
  if (!options.device_path.empty()) {
    DORSUM_ASSIGN_OR_RETURN(description, ReadDeviceDescription(options.device_path));
  }
  DORSUM_RETURN_IF_ERROR(CheckTarget(out_dir, options.overwrite));
  const std::uint64_t seed = NamedSeed(options.seed);
  const std::uint64_t people_seed = options.people_seed.empty() ? seed : NamedSeed(options.people_seed);
  const VirtualDevice device = BuildVirtualDevice(description, seed);
  for (const SceneName& name : plan) {
    DORSUM_RETURN_IF_ERROR(CheckLasers(name.modifiers, static_cast<int>(device.lasers.size())));
  }

  DORSUM_ASSIGN_OR_RETURN(StagedFolder staged, StagedFolder::Create(out_dir));
  const fs::path& root = staged.path();
  SimulateReport report;
  if (options.calibration) {
    DORSUM_RETURN_IF_ERROR(WriteCalibrationSeries(device, root / "calibration", context));
    report.calibration = true;
  }
  DORSUM_RETURN_IF_ERROR(MakeFolder(root / "truth"));
  DORSUM_RETURN_IF_ERROR(WriteJson(root / "truth" / "device.json", DeviceToJson(device)));
  for (const SceneName& name : plan) {
    context.Report("capture " + name.folder,
                   static_cast<double>(report.captures) / static_cast<double>(plan.size()));
    Scene scene = BuildNamedScene(device, name, seed, people_seed);
    DORSUM_RETURN_IF_ERROR(WriteOneCapture(device, name, std::move(scene), seed, root, context));
    ++report.captures;
    report.capture_names.push_back(name.folder);
  }
  if (!people.empty()) DORSUM_RETURN_IF_ERROR(WriteJson(root / kPeopleName, PeopleToJson(people)));
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
  if (options.overwrite) DORSUM_RETURN_IF_ERROR(RemoveEarlierRun(out_dir));
  DORSUM_RETURN_IF_ERROR(staged.Commit());
  return report;
}

}  // namespace dorsum
