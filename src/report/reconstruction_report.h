// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "base/context.h"
#include "calibration/verdict.h"
#include "geometry/mesh.h"
#include "report/evaluation_table.h"
#include "stripes/stripes.h"
#include "surface/height_field.h"
#include "surface/surface_point.h"

namespace dorsum {

// What is known of one reconstruction. Anything may be empty; the report then leaves it out and says so.
struct ReconstructionReportData {
  std::string title;                   // the capture's name
  cv::Mat photo;                       // bgHand, BGR
  std::vector<cv::Mat> stripe_photos;  // by laser number; an empty Mat for a missing one
  cv::Mat mask;                        // CV_8UC1, the photo's size
  IndexedStripes stripes;
  SurfacePoints points;
  HeightField height_field;
  TriangleMesh mesh;
  std::vector<ReportRow> facts;           // shown large at the top
  std::vector<ReportRow> settings;        // which way each stage went
  std::vector<EvaluationRow> evaluation;  // if the object's shape is known
  std::vector<PartReport> calibration;    // parts of the calibration that was used
  std::vector<std::string> warnings;
  std::string version;  // of the program
};

struct ReportPages {
  std::string html;
  std::string overview_png;
};

// The page of a reconstruction, self-contained, and the same in one picture. Holds no date: the same data
// give the same bytes.
ReportPages MakeReconstructionReport(const ReconstructionReportData& data, const Context& context = {});

}  // namespace dorsum
