// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/result.h"
#include "calibration/calibration_file.h"
#include "captures/capture.h"
#include "geometry/mesh.h"
#include "imaging/hand_mask.h"
#include "jobs/reconstruct_options.h"
#include "stripes/stripes.h"
#include "surface/height_field.h"
#include "surface/robust_fusion.h"
#include "surface/surface_point.h"

namespace dorsum {

// Everything that one capture gives, stage by stage.
struct Reconstruction {
  HandMask mask;
  IndexedStripes stripes;
  SurfacePoints points;
  HeightField height_field;
  TriangleMesh mesh;
  int without_order = 0, without_sheet = 0;   // stripe points that gave no surface point
  std::vector<LaserConsistency> consistency;  // each laser against the surface of the others (robust fusion)
  std::vector<LaserOffset> offsets;           // heights of each laser against the mean of all (robust fusion)
  int contradicted = 0;                       // surface points left out, since the others contradict them
  std::vector<std::string> warnings;
};

// A calibration with its background image decoded and its orders laid out, ready for many captures.
struct ReadyCalibration {
  Calibration calibration;
  cv::Mat background, green_background;  // BGR, and its green channel
  std::shared_ptr<const DeviceOrders> orders;
};
Result<ReadyCalibration> PrepareCalibration(Calibration calibration, const std::string& where);

// CaptureImages -> Mask -> StripePoints -> StripeSegments -> IndexedStripes -> SurfacePoints -> Surface.
Result<Reconstruction> Reconstruct(const CaptureImages& capture, const ReadyCalibration& ready,
                                   const ReconstructOptions& options, const Context& context);

// Only the stages up to the points: what calibrating and evaluating need.
Result<Reconstruction> ReconstructPoints(const CaptureImages& capture, const ReadyCalibration& ready,
                                         const ReconstructOptions& options, const Context& context);

struct ReconstructRequest {
  std::filesystem::path capture_dir, calibration_path, out_dir;
  ReconstructOptions options;
  std::vector<std::string> mesh_formats = {"ply"};
  bool report = true;
  bool stages = false;  // also every stage's intermediate image, under OUT_DIR/stages
};

struct ReconstructSummary {
  std::size_t points = 0, faces = 0;
  std::vector<std::size_t> points_by_laser;  // by laser number
  std::vector<std::string> files;            // written, relative to out_dir
  std::vector<std::string> warnings;
};

// The job behind `dorsum reconstruct`: capture folder in, DESIGN §4's outputs out, all or nothing.
Result<ReconstructSummary> ReconstructFolder(const ReconstructRequest& request, const Context& context);

}  // namespace dorsum
