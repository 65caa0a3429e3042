// SPDX-License-Identifier: Apache-2.0
#include "calibration/bundle_verdicts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "calibration/dim_stripes.h"

namespace dorsum {
namespace {

std::string Fixed(double value, int decimals) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

double Sd(const Eigen::MatrixXd& covariance, int index) {
  return covariance.rows() > index ? std::sqrt(std::max(0.0, covariance(index, index))) : 0.0;
}

PartReport JudgeCamera(const BundleCalibration& c, const BundleVerdictOptions& o) {
  const std::vector<double>& views = c.view_rms_px;
  double square = 0.0;
  for (const double rms : views) square += rms * rms;
  const double rms = std::sqrt(square / static_cast<double>(views.size()));
  const auto worst = std::max_element(views.begin(), views.end());
  const Camera& camera = c.device.camera;
  PartReport report;
  report.part = "camera";
  const auto lying = std::count_if(c.data.boards.begin() + 1, c.data.boards.end(),
                                   [](const BoardView& board) { return board.plane >= 0; });
  report.figures = {{"views", static_cast<double>(views.size()) - static_cast<double>(lying), ""},
                    {"boards that lie on known heights", static_cast<double>(lying), ""},
                    {"reprojection error", rms, "px"},
                    {"worst view", *worst, "px"},
                    {"focal length", camera.fx, "px"},
                    {"focal length, uncertainty", Sd(c.solution.covariance, 0), "px"},
                    {"principal point, uncertainty",
                     std::hypot(Sd(c.solution.covariance, 2), Sd(c.solution.covariance, 3)), "px"},
                    {"camera height", camera.Center().z(), "mm"}};
  if (rms <= o.good_rms_px) {
    report.verdict = "the camera model explains all chessboards";
  } else if (rms <= o.doubtful_rms_px) {
    report.grade = Grade::kDoubtful;
    report.verdict = "the corners do not fit well, worst in " +
                     c.data.boards[static_cast<std::size_t>(worst - views.begin())].name +
                     "; is the board flat, sharp and still?";
  } else {
    report.grade = Grade::kBad;
    report.verdict =
        "the corners do not fit; capture the chessboards again with a flat board and a sharp picture";
  }
  return report;
}

struct Scatter {
  double n = 0.0, sum = 0.0, square = 0.0;
  void Add(double value) {
    n += 1.0;
    sum += value;
    square += value * value;
  }
  double Mean() const { return n > 0.0 ? sum / n : 0.0; }
  double Rms() const { return n > 0.0 ? std::sqrt(square / n) : 0.0; }
};

std::string FormSentence(const DiffractedFan& fan, double bow_sd) {
  const double flat = std::sin(fan.tilt), bow = fan.bow;
  const double clear = std::max(3.0 * bow_sd, 5e-4);
  const std::string lean = "the fan leans by " + Fixed(fan.tilt * 57.29578, 2) + " degrees";
  if (std::abs(flat) <= 2.0 * clear) return lean + ", too little to tell its form";
  if (std::abs(bow - flat) <= clear && std::abs(bow - flat) <= 0.3 * std::abs(flat))
    return lean + " and is flat, as it leaves a laser";
  if (std::abs(bow) <= clear && std::abs(bow) <= 0.3 * std::abs(flat))
    return lean + " and has one cosine all along (a cone before the grating)";
  return lean + " and is bowed, neither flat nor a cone";
}

// What is wrong with a laser, worst first; raises the grade.
std::vector<std::string> Complaints(const BundleCalibration& c, std::size_t index,
                                    const BundleVerdictOptions& o, Grade* grade) {
  const LaserGeometry& laser = c.device.lasers[index];
  const auto raise = [grade](Grade g) { *grade = std::max(*grade, g); };
  std::vector<std::string> complaints;
  for (const SeriesCheck& s : c.left_out) {
    if (s.laser != static_cast<int>(index)) continue;
    raise(s.off_mm > 4.0 * o.moved_mm ? Grade::kBad : Grade::kDoubtful);
    complaints.push_back(
        "laser " + std::to_string(laser.laser) + " moved between the series: its stripes in " +
        c.pictures[static_cast<std::size_t>(s.source)] + " lie " + Fixed(s.off_mm, 2) +
        " mm off what its other pictures say; that picture was left out, so fix the laser and "
        "capture the series again");
  }
  for (std::size_t i = 0; i < c.pictures.size(); ++i) {
    if (c.laser_of_picture[i] != static_cast<int>(index) || c.assigned[i] >= o.assigned_share) continue;
    raise(Grade::kDoubtful);
    complaints.push_back("only " + Fixed(100.0 * c.assigned[i], 0) + " % of the stripes in " + c.pictures[i] +
                         " fit its light sheets; did the laser move, or does something else stand there?");
  }
  if (c.pattern_mm[index] > o.pattern_mm) {
    raise(c.pattern_mm[index] > 3.0 * o.pattern_mm ? Grade::kBad : Grade::kDoubtful);
    complaints.push_back("the cones leave a pattern of " + Fixed(c.pattern_mm[index], 3) +
                         " mm along the stripes, so the model does not explain this laser");
  }
  const std::vector<std::string> dim =
      FindDimStripes(c.data.points, static_cast<int>(index), c.device.camera.height);
  for (std::size_t i = 0; i < std::min<std::size_t>(3, dim.size()); ++i) complaints.push_back(dim[i]);
  if (!dim.empty()) {
    raise(Grade::kDoubtful);
    complaints.back() += " (dirt on the grating, or too short an exposure?)";
  }
  return complaints;
}

PartReport JudgeLaser(const BundleCalibration& c, std::size_t index, const BundleVerdictOptions& o) {
  const LaserGeometry& laser = c.device.lasers[index];
  const DiffractedFan& fan = *laser.fan;
  const int first = kLensSize + kPoseSize + kFanSize * static_cast<int>(index);
  const auto sd = [&](int parameter) { return Sd(c.solution.covariance, first + parameter); };
  Scatter all;
  for (const SheetResidual& r : c.residuals) {
    if (r.laser == laser.laser && std::abs(r.miss_mm) < 0.3) all.Add(r.miss_mm);
  }
  PartReport report;
  report.part = "laser " + std::to_string(laser.laser);
  report.figures = {{"stripe points", all.n, ""},
                    {"sheet residual", all.Rms(), "mm"},
                    {"pattern left", c.pattern_mm[index], "mm"},
                    {"height uncertainty by calibration", laser.residual_mm, "mm"},
                    {"grating x", fan.origin.x(), "mm"},
                    {"grating x, uncertainty", sd(kFanOrigin), "mm"},
                    {"grating height", fan.origin.z(), "mm"},
                    {"grating height, uncertainty", sd(kFanOrigin + 2), "mm"},
                    {"order step", fan.step, ""},
                    {"order step, uncertainty", sd(kFanStep), ""},
                    {"fan distance", fan.fan_distance_mm, "mm"},
                    {"fan distance, uncertainty", sd(kFanDistance), "mm"},
                    {"fan tilt", fan.tilt, "rad"},
                    {"fan tilt, uncertainty", sd(kFanAlpha), "rad"},
                    {"fan bow", fan.bow, ""},
                    {"fan bow, uncertainty", sd(kFanBow), ""}};
  std::vector<std::string> complaints = Complaints(c, index, o, &report.grade);
  std::string text = complaints.empty() ? "cones explain all stripes" : "";
  for (const std::string& complaint : complaints) text += (text.empty() ? "" : "; ") + complaint;
  report.verdict = text + "; " + FormSentence(fan, sd(kFanBow));
  return report;
}

PartReport JudgeBoard(const BundleCalibration& c, const BundleVerdictOptions& o) {
  PartReport report;
  report.part = "chessboard";
  report.figures = {{"sag of the corners", c.board.sag_mm, "mm"},
                    {"sag, in standard deviations", c.board.significance, ""}};
  report.verdict = "the board is flat";
  if (BoardIsBent(c.board, o)) {
    report.grade = Grade::kDoubtful;
    report.verdict =
        "the board is not flat: its corners lie " + Fixed(c.board.sag_mm, 2) +
        " mm off its middle; that bow was taken into account, but mount the board on something flat";
  }
  return report;
}

PartReport JudgeHeights(const BundleCalibration& c, const BundleVerdictOptions& o) {
  PartReport report;
  report.part = "known heights";
  report.verdict = "all heights fit as they were given";
  std::string wrong;
  for (const HeightCheck& h : c.heights) {
    const std::string& name = c.data.planes[static_cast<std::size_t>(h.plane)].name;
    report.figures.push_back({name + ": given", h.given_mm, "mm"});
    report.figures.push_back({name + ": fits", h.fitted_mm, "mm"});
    report.figures.push_back({name + ": uncertainty", h.sd_mm, "mm"});
    if (!HeightIsWrong(h, o)) continue;
    wrong += (wrong.empty() ? "" : "; ") + ("the height of " + name + " is given as " + Fixed(h.given_mm, 1) +
                                            " mm, fits " + Fixed(h.fitted_mm, 1) + " mm");
  }
  if (!wrong.empty()) {
    report.grade = Grade::kDoubtful;
    report.verdict = wrong + "; what fits was used, so measure it and correct setup.json";
  }
  return report;
}

}  // namespace

bool HeightIsWrong(const HeightCheck& check, const BundleVerdictOptions& options) {
  const double off = std::abs(check.fitted_mm - check.given_mm);
  return off > options.height_off_mm && off > options.significant * check.sd_mm;
}

bool BoardIsBent(const BoardCheck& check, const BundleVerdictOptions& options) {
  return check.sag_mm > options.board_sag_mm && check.significance > options.significant;
}

std::vector<std::vector<Eigen::Vector2d>> ExpectedCorners(const BundleData& data, const BundleState& state) {
  const Camera camera = state.GetCamera();
  Eigen::Vector2d half(1e-9, 1e-9);
  for (const auto& p : data.board_points) half = half.cwiseMax(p.head<2>().cwiseAbs());
  std::vector<std::vector<Eigen::Vector2d>> views(data.boards.size());
  for (std::size_t i = 0; i < data.boards.size(); ++i) {
    const Rigid3 world_from_board = RigidFromPose(state.world_from_board[i]);
    for (Eigen::Vector3d p : data.board_points) {
      const Eigen::Vector2d share = p.head<2>().cwiseQuotient(half);
      p.z() += state.board_bow[0] * share.x() * share.x() + state.board_bow[1] * share.x() * share.y() +
               state.board_bow[2] * share.y() * share.y();
      views[i].push_back(Project(camera, world_from_board * p));
    }
  }
  return views;
}

std::vector<double> ViewErrors(const BundleData& data, const BundleState& state) {
  const auto views = ExpectedCorners(data, state);
  std::vector<double> errors;
  for (std::size_t i = 0; i < views.size(); ++i) {
    double square = 0.0;
    for (std::size_t k = 0; k < views[i].size(); ++k) {
      square += (views[i][k] - data.boards[i].corners[k]).squaredNorm();
    }
    errors.push_back(std::sqrt(square / static_cast<double>(data.board_points.size())));
  }
  return errors;
}

std::vector<PartReport> JudgeBundle(const BundleCalibration& c, const BundleVerdictOptions& options) {
  std::vector<PartReport> parts = {JudgeCamera(c, options), JudgeBoard(c, options), JudgeHeights(c, options)};
  for (std::size_t i = 0; i < c.device.lasers.size(); ++i) parts.push_back(JudgeLaser(c, i, options));
  return parts;
}

}  // namespace dorsum
