// SPDX-License-Identifier: Apache-2.0
#include "surface/height_file.h"

#include "base/files.h"
#include "base/json.h"
#include "surface/tiff_image.h"

namespace dorsum {

Status WriteHeightField(const std::filesystem::path& folder, const HeightField& field) {
  if (field.z.empty()) return {};
  DORSUM_RETURN_IF_ERROR(WriteFile(folder / "height.tiff", EncodeTiff(field.z)));
  const Json json = {{"schema", "dorsum/height"},
                     {"version", 1},
                     {"file", "height.tiff"},
                     {"frame", "world: x along columns, y along rows, z up from the backplane"},
                     {"unit", "mm"},
                     {"origin_mm", {field.origin_mm.x(), field.origin_mm.y()}},
                     {"pitch_mm", field.pitch_mm},
                     {"columns", field.z.cols},
                     {"rows", field.z.rows}};
  return WriteJson(folder / "height.json", json);
}

}  // namespace dorsum
