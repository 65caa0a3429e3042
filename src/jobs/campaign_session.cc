// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "jobs/campaign_files.h"
#include "jobs/campaign_json.h"
#include "jobs/campaign_names.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSessionSchema = "dorsum/campaign_session";

Result<StoredCapture> CaptureFromJson(const Json& json, const std::string& where) {
  JsonReader reader(json, where);
  StoredCapture c;
  c.hand = HandOf(&reader);
  c.number = reader.Integer("capture", 1, kMaxCaptures);
  c.calibration = HashOrNone(&reader, "calibration");
  c.lasers = LasersOf(&reader);
  for (const Json& item : reader.Array("files", 64)) {
    JsonReader file(item, where + ", files");
    StoredPicture p;
    p.name = file.Text("name");
    p.bytes = static_cast<std::uint64_t>(file.Number("bytes", 1, 1e10));
    p.sha256 = file.Text("sha256");
    if (!IsPictureName(p.name)) file.Fail("name", "is no name of a capture's picture");
    if (!IsSha256(p.sha256)) file.Fail("sha256", "must be a SHA-256");
    if (!c.pictures.empty() && p.name <= c.pictures.back().name) file.Fail("name", "is out of order");
    DORSUM_RETURN_IF_ERROR(file.status());
    c.pictures.push_back(std::move(p));
  }
  if (c.pictures.empty()) reader.Fail("files", "must not be empty");
  DORSUM_RETURN_IF_ERROR(reader.status());
  return c;
}

Json CaptureToJson(const StoredCapture& c) {
  Json files = Json::array();
  for (const StoredPicture& p : c.pictures) {
    files.push_back({{"name", p.name}, {"bytes", p.bytes}, {"sha256", p.sha256}});
  }
  return {{"hand", HandWord(c.hand)},
          {"capture", c.number},
          {"calibration", c.calibration},
          {"lasers", c.lasers},
          {"files", files}};
}

}  // namespace

Status WriteSession(const fs::path& dir, const std::string& id, const CampaignSession& session) {
  Json json = StartSealed(kSessionSchema);
  json["session"] = session.number;
  if (session.unfinished) {
    json["unfinished"] = {{"hand", HandWord(session.unfinished->hand)},
                          {"capture", session.unfinished->number}};
  }
  json["captures"] = Json::array();
  for (const StoredCapture& c : session.captures) json["captures"].push_back(CaptureToJson(c));
  return WriteSealed(SessionFolder(dir, id, session.number) / kSessionManifest, std::move(json));
}

Result<CampaignSession> ReadSession(const fs::path& dir, const std::string& id, int session) {
  const fs::path path = SessionFolder(dir, id, session) / kSessionManifest;
  DORSUM_ASSIGN_OR_RETURN(const Json json, ReadSealed(path));
  JsonReader reader(json, path.string());
  reader.Schema(kSessionSchema, kCampaignSchemaVersion);
  CampaignSession s;
  s.number = reader.Integer("session", 1, kMaxSessions);
  if (s.number != session) reader.Fail("session", "is not the name of the session's folder");
  if (reader.Has("unfinished")) {
    JsonReader key(reader.Object("unfinished"), path.string() + ", unfinished");
    s.unfinished = CaptureKey{HandOf(&key), key.Integer("capture", 1, kMaxCaptures)};
    DORSUM_RETURN_IF_ERROR(key.status());
  }
  const Json& captures = reader.Array("captures", 2 * kMaxCaptures);
  DORSUM_RETURN_IF_ERROR(reader.status());
  for (const Json& item : captures) {
    DORSUM_ASSIGN_OR_RETURN(StoredCapture capture, CaptureFromJson(item, path.string() + ", captures"));
    if (s.Find(capture.hand, capture.number) != nullptr)
      return BadInput(path.string() + " names a capture twice; restore it from a copy");
    s.captures.push_back(std::move(capture));
  }
  return s;
}

}  // namespace dorsum
