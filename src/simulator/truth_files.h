// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "base/json.h"
#include "base/result.h"
#include "geometry/mesh.h"
#include "simulator/truth.h"
#include "simulator/view.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// Ground truth in the layout of rendered captures that tests and scoring tools read.

// 16-bit PNG: 0 where nothing is, otherwise z = (code - 1) * 0.002 mm at the pixel's centre.
Status WriteHeights(const View& view, const std::filesystem::path& path);

// 8-bit PNG of the Material at each pixel's centre.
Status WriteMaterials(const View& view, const std::filesystem::path& path);

// Gzipped table: order,v,u,z,material,irradiance.
Status WriteStripes(const std::vector<TrueStripePoint>& points, const std::filesystem::path& path);

// Binary little-endian PLY of the faces that rise above the backplane, in mm and the world frame.
Status WriteReferencePly(const TriangleMesh& mesh, const std::filesystem::path& path);

// The true device: truth/device.json.
Json DeviceToJson(const VirtualDevice& device);

// An 8-bit picture in the format that the device's camera delivers; `stem` lacks the extension.
Status WritePicture(const CameraDesign& camera, const cv::Mat& picture, const std::filesystem::path& stem);

}  // namespace dorsum
