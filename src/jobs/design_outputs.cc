// SPDX-License-Identifier: Apache-2.0
#include "jobs/design_outputs.h"

#include "base/files.h"
#include "captures/device_description_toml.h"
#include "captures/png_image.h"
#include "jobs/design_page.h"

namespace dorsum {

Result<std::vector<std::string>> WriteDesign(const DesignSummary& summary,
                                             const std::filesystem::path& out_dir) {
  DORSUM_ASSIGN_OR_RETURN(StagedFolder staged, StagedFolder::Create(out_dir));
  const DesignPictures pictures = DrawDesign(summary.report);
  const std::filesystem::path& dir = staged.path();
  DORSUM_RETURN_IF_ERROR(
      WriteFile(dir / "device.toml", DeviceDescriptionToToml(summary.report.device.description)));
  DORSUM_RETURN_IF_ERROR(WriteJson(dir / "design.json", SummaryToJson(summary)));
  DORSUM_RETURN_IF_ERROR(WriteFile(dir / "design.png", EncodePng(Overview(summary.report, pictures), 6)));
  DORSUM_RETURN_IF_ERROR(WriteFile(dir / "design.html", DesignPage(summary, pictures)));
  DORSUM_RETURN_IF_ERROR(staged.Commit());
  return std::vector<std::string>{"device.toml", "design.json", "design.png", "design.html"};
}

}  // namespace dorsum
