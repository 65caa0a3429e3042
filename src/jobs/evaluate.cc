// SPDX-License-Identifier: Apache-2.0
#include "jobs/evaluate.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <opencv2/imgproc.hpp>

#include "base/files.h"
#include "captures/green_channel.h"
#include "captures/image_file.h"
#include "captures/image_header.h"
#include "captures/jpeg_image.h"
#include "captures/png_image.h"
#include "surface/mesh_height.h"
#include "surface/ply.h"

namespace dorsum {
namespace {

// A point with its error against the reference, if the reference says anything there.
struct Judged {
  int laser = 0;
  double z = 0.0;
  std::optional<double> error;
};

Result<cv::Mat> ReadShrunkMask(const std::filesystem::path& dir, double shrink_px) {
  const std::filesystem::path path = dir / "mask.png";
  DORSUM_ASSIGN_OR_RETURN(const std::string bytes, ReadFile(path, std::size_t{256} << 20));
  const Result<ImageHeader> header = ReadImageHeader(bytes);
  const bool usable = header.ok() && header->complete && header->intact &&
                      static_cast<long>(header->width) * header->height <= kMaxPixels;
  if (!usable) return BadInput(path.string() + " is no image; reconstruct again");
  cv::Mat mask =
      header->format == "JPEG" ? DecodeJpeg(bytes, {header->width, header->height}) : DecodePng(bytes);
  if (mask.channels() == 3) mask = GreenChannel(mask);
  if (mask.empty()) return BadInput(path.string() + " is no image; reconstruct again");
  cv::Mat distance;
  cv::copyMakeBorder(mask, mask, 1, 1, 1, 1, cv::BORDER_REPLICATE);  // the image's edge is not the object's
  cv::distanceTransform(mask != 0, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  const cv::Mat shrunk = distance > shrink_px;
  return shrunk(cv::Rect(1, 1, mask.cols - 2, mask.rows - 2)).clone();
}

Result<SurfacePoints> ReadPointsOnMask(const std::filesystem::path& dir, double shrink_px) {
  DORSUM_ASSIGN_OR_RETURN(const SurfacePoints all, ReadPointsPly(dir / "points.ply"));
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat mask, ReadShrunkMask(dir, shrink_px));
  SurfacePoints kept;
  for (const SurfacePoint& p : all) {
    const auto u = static_cast<int>(std::lround(p.u)), v = static_cast<int>(std::lround(p.v));
    if (u < 0 || v < 0 || u >= mask.cols || v >= mask.rows || mask.at<std::uint8_t>(v, u) == 0) continue;
    kept.push_back(p);
  }
  if (kept.empty()) return BadInput("no point of " + dir.string() + " lies on the object's mask");
  return kept;
}

ModelErrors Summarise(const std::string& model, const std::vector<Judged>& judged, int laser) {
  ModelErrors m;
  m.model = model;
  std::vector<double> magnitudes;
  double low = 1e18, high = -1e18, squares = 0.0;
  for (const Judged& j : judged) {
    if (laser >= 0 && j.laser != laser) continue;
    ++m.points;
    if (!j.error) {
      ++m.outside;
      continue;
    }
    low = std::min(low, j.z);
    high = std::max(high, j.z);
    squares += *j.error * *j.error;
    m.bias_mm += *j.error;
    magnitudes.push_back(std::abs(*j.error));
  }
  if (magnitudes.empty()) return m;
  const auto n = static_cast<double>(magnitudes.size());
  m.rmse_mm = std::sqrt(squares / n);
  m.bias_mm /= n;
  m.range_mm = high - low;
  m.nrmse = m.range_mm > 0.0 ? m.rmse_mm / m.range_mm : 0.0;
  std::sort(magnitudes.begin(), magnitudes.end());
  m.median_abs_mm = magnitudes[magnitudes.size() / 2];
  m.p95_abs_mm = magnitudes[static_cast<std::size_t>(0.95 * (n - 1.0))];
  return m;
}

Result<CaptureErrors> EvaluateOne(const std::filesystem::path& dir, const EvaluateRequest& request,
                                  const MeshHeight* reference) {
  DORSUM_ASSIGN_OR_RETURN(const SurfacePoints points, ReadPointsOnMask(dir, request.shrink_px));
  CaptureErrors out;
  const std::filesystem::path clean = std::filesystem::absolute(dir).lexically_normal();
  out.name = (clean.has_filename() ? clean : clean.parent_path()).filename().string();
  if (request.fit) {
    std::vector<Eigen::Vector3d> positions;
    for (const SurfacePoint& p : points) positions.push_back(p.position);
    const Result<ShapeFit> shape = FitShape(*request.fit, positions);
    if (!shape.ok()) return BadInput(dir.string() + ": " + shape.error().message);
    out.shape = *shape;
  }
  std::vector<Judged> judged;
  std::set<int> lasers;
  for (const SurfacePoint& p : points) {
    Judged j{p.laser, p.position.z(), std::nullopt};
    if (out.shape) {
      j.error = out.shape->Distance(p.position);
    } else if (reference != nullptr) {
      if (const auto z = reference->At(p.position.x(), p.position.y())) j.error = p.position.z() - *z;
    } else {
      j.error = p.position.z() - *request.plane_height_mm;
    }
    judged.push_back(j);
    lasers.insert(p.laser);
  }
  for (const int laser : lasers)
    out.models.push_back(Summarise("laser " + std::to_string(laser), judged, laser));
  out.models.push_back(Summarise("merged", judged, -1));
  if (out.models.back().outside == out.models.back().points) {
    return BadInput("no point of " + dir.string() +
                    " lies over the reference mesh; are both in the same frame?");
  }
  return out;
}

}  // namespace

Result<Evaluation> Evaluate(const EvaluateRequest& request, const Context& context) {
  const int ways = (request.plane_height_mm ? 1 : 0) + (request.fit ? 1 : 0) + (request.against ? 1 : 0);
  if (ways != 1) return UsageError("evaluate takes one of --plane-height, --fit and --against");
  TriangleMesh mesh;
  std::optional<MeshHeight> reference;
  if (request.against) {
    DORSUM_ASSIGN_OR_RETURN(mesh, ReadMeshPly(*request.against));
    if (mesh.faces.empty())
      return BadInput(request.against->string() + " holds no triangles to compare with");
    reference.emplace(mesh);
  }
  Evaluation out;
  for (const auto& dir : request.out_dirs) {
    DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
    DORSUM_ASSIGN_OR_RETURN(CaptureErrors one, EvaluateOne(dir, request, reference ? &*reference : nullptr));
    out.captures.push_back(std::move(one));
  }
  for (std::size_t i = 0; i < out.captures.size(); ++i) {
    for (std::size_t k = i + 1; k < out.captures.size(); ++k) {
      for (const ModelErrors& a : out.captures[i].models) {
        for (const ModelErrors& b : out.captures[k].models) {
          if (a.model != b.model) continue;
          out.differences.push_back(
              {out.captures[i].name, out.captures[k].name, a.model, std::abs(b.rmse_mm - a.rmse_mm)});
        }
      }
    }
  }
  return out;
}

}  // namespace dorsum
