// SPDX-License-Identifier: Apache-2.0
#include "jobs/live_series.h"

#include <atomic>
#include <filesystem>

#include <gtest/gtest.h>

#include "captures/calibration_series.h"
#include "captures/image_file.h"
#include "device/hooked_device_test.h"
#include "jobs/calibrate.h"
#include "jobs/capture.h"
#include "jobs/evaluate.h"
#include "jobs/reconstruct.h"
#include "jobs/virtual_device_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// The virtual attendant, with hooks for what a person gets wrong.
class HookedAttendant : public Attendant {
 public:
  explicit HookedAttendant(Device& device) : device_(device), inner_(MakeVirtualAttendant(device.bench)) {}

  Status Arrange(const SeriesStep& step, const std::string& words, const std::function<Status()>& keep_lit,
                 const Context& context) override {
    said.push_back(words);
    DORSUM_RETURN_IF_ERROR(keep_lit());
    guided.push_back(device_.bench->On());
    if (before) DORSUM_RETURN_IF_ERROR(before(static_cast<int>(said.size()) - 1));
    if (skip && skip(step, static_cast<int>(said.size()) - 1)) return {};
    return inner_->Arrange(step, words, keep_lit, context);
  }
  void Tell(const std::string& words) override { told.push_back(words); }
  void SawBoard(const std::vector<cv::Point2f>& corners) override { boards.push_back(corners.size()); }
  void StepDone(const SeriesStep& step) override { done.push_back(step.pictures.front().name); }

  std::vector<std::string> said, told;
  std::vector<ChannelSet> guided;
  std::vector<std::size_t> boards;
  std::vector<std::string> done;
  std::function<Status(int call)> before;
  std::function<bool(const SeriesStep& step, int call)> skip;  // the person leaves all as it lies

 private:
  Device& device_;
  std::unique_ptr<Attendant> inner_;
};

class LiveSeriesTest : public ::testing::Test {
 protected:
  LiveSeriesTest() : device_(OpenFixtureDevice(dir_)), attendant_(device_) { request_.dir = dir_ / "series"; }
  Result<LiveSeriesSummary> Take(const Context& context = {}) {
    return TakeCalibrationSeries(device_, attendant_, request_, context);
  }

  TempFolder dir_;
  Device device_;
  HookedAttendant attendant_;
  LiveSeriesRequest request_;
};

TEST_F(LiveSeriesTest, AWholeSeriesCalibratesAndEveryLaserGuidesItsBoard) {
  const auto summary = Take();
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_EQ(summary->steps, 12 + 2 + 1 + 6 + 3);
  EXPECT_EQ(summary->kept, 0);
  EXPECT_GT(summary->board_coverage, 0.6);
  EXPECT_EQ(attendant_.told.size(), 12U);
  EXPECT_NE(attendant_.told.back().find("Chessboard 12 of 12"), std::string::npos);
  EXPECT_TRUE(attendant_.guided[0].test(1));
  EXPECT_TRUE(attendant_.guided[5].none());
  EXPECT_TRUE(device_.bench->On().none());
  EXPECT_EQ(attendant_.boards, std::vector<std::size_t>(12, 88));
  EXPECT_EQ(attendant_.done.size(), 24U);
  const auto series = LoadCalibrationSeries(request_.dir);
  ASSERT_TRUE(series.ok()) << series.error().message;
  EXPECT_TRUE(series->warnings.empty());
  const auto run = CalibrateFolder(request_.dir, dir_ / "calibration.json", {}, {});
  ASSERT_TRUE(run.ok()) << run.error().message;
  for (const PartReport& part : run->calibration.parts) EXPECT_NE(part.grade, Grade::kBad) << part.part;

  // A second run has nothing to do.
  attendant_.said.clear();
  const auto again = Take();
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->kept, again->steps);
  EXPECT_TRUE(attendant_.said.empty());
  EXPECT_EQ(attendant_.boards.size(), 24U);
  EXPECT_EQ(attendant_.done.size(), 48U);
  EXPECT_EQ(again->board_coverage, summary->board_coverage);
}

// RMSE of a box of 25.5 mm (5.1), all lasers.
double BoxError(const fs::path& capture, const fs::path& calibration, const fs::path& out) {
  ReconstructRequest request;
  request.capture_dir = capture;
  request.calibration_path = calibration;
  request.out_dir = out;
  request.report = false;
  const auto summary = ReconstructFolder(request, {});
  if (!summary.ok()) throw std::runtime_error(summary.error().message);
  EvaluateRequest how;
  how.out_dirs = {out};
  how.plane_height_mm = 25.5;
  return Evaluate(how, {}).value().captures.at(0).models.back().rmse_mm;
}

TEST_F(LiveSeriesTest, TheLiveWayIsAsAccurateAsFolders) {
  const auto taken = Take();
  ASSERT_TRUE(taken.ok()) << taken.error().message;
  const auto run = CalibrateFolder(request_.dir, dir_ / "calibration.json", {}, {});
  ASSERT_TRUE(run.ok()) << run.error().message;
  ASSERT_TRUE(device_.bench->PlaceNamed(ScanFixture::kBox).ok());
  CaptureRequest capture;
  capture.out_dir = dir_ / "box";
  capture.calibration_path = dir_ / "calibration.json";
  const auto captured = CaptureToFolder(device_, capture, {});
  ASSERT_TRUE(captured.ok()) << captured.error().message;
  const double live = BoxError(dir_ / "box", dir_ / "calibration.json", dir_ / "live"),
               folders = BoxError(ScanFixture::CaptureDir(ScanFixture::kBox), ScanFixture::CalibrationJson(),
                                  dir_ / "folders");
  EXPECT_LT(live, 1.25 * folders) << folders;
  EXPECT_GT(live, 0.8 * folders) << folders;
}

TEST_F(LiveSeriesTest, AnInterruptedSeriesGoesOnWhereItEnded) {
  attendant_.before = [](int call) { return call == 14 ? Status(Cancelled()) : Status(); };
  const auto broken = Take();
  ASSERT_FALSE(broken.ok());
  EXPECT_EQ(broken.error().code, ErrorCode::kCancelled);
  EXPECT_TRUE(device_.bench->On().none());
  EXPECT_TRUE(FindImage(request_.dir, "chess11").has_value());
  EXPECT_TRUE(FindImage(request_.dir, "bgNoHand").has_value());
  attendant_.before = [](int call) { return call == 16 ? Status(Cancelled()) : Status(); };
  const auto further = Take();
  ASSERT_FALSE(further.ok());
  // The step that was broken off is asked for again, and none before it.
  EXPECT_EQ(attendant_.said[15], attendant_.said[14]);
}

TEST_F(LiveSeriesTest, ABoardThatIsNotThereIsAskedForAgain) {
  attendant_.skip = [](const SeriesStep&, int call) { return call == 0; };
  attendant_.before = [](int call) { return call == 2 ? Status(Cancelled()) : Status(); };
  EXPECT_EQ(Take().error().code, ErrorCode::kCancelled);
  ASSERT_EQ(attendant_.said.size(), 3U);
  EXPECT_EQ(attendant_.said[1].rfind("Again: the chessboard of 11 x 8 inner corners is not seen whole", 0),
            0U)
      << attendant_.said[1];
  EXPECT_TRUE(FindImage(request_.dir, "chess00").has_value());
}

TEST_F(LiveSeriesTest, ABoardThatWasNotMovedIsAskedForAgain) {
  attendant_.skip = [](const SeriesStep& step, int call) { return step.number == 1 && call == 1; };
  attendant_.before = [](int call) { return call == 3 ? Status(Cancelled()) : Status(); };
  EXPECT_EQ(Take().error().code, ErrorCode::kCancelled);
  EXPECT_NE(attendant_.said[2].find("lies as it did before"), std::string::npos) << attendant_.said[2];
}

TEST_F(LiveSeriesTest, AStepThatNeverSucceedsIsGivenUpInASentence) {
  attendant_.skip = [](const SeriesStep&, int) { return true; };
  request_.tries = 3;
  const auto result = Take();
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kBadInput);
  EXPECT_EQ(attendant_.said.size(), 3U);
  EXPECT_FALSE(FindImage(request_.dir, "chess00").has_value());
}

TEST_F(LiveSeriesTest, ASeriesOfAnotherDeviceIsNotContinued) {
  fs::create_directories(request_.dir);
  ASSERT_TRUE(WriteFile(request_.dir / "setup.json", R"({"chessboard": {"square_mm": 3.0}})").ok());
  const auto result = Take();
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kBadInput);
  EXPECT_TRUE(attendant_.said.empty());
}

TEST_F(LiveSeriesTest, ATruncatedPictureOfAnEarlierRunIsTakenAgain) {
  attendant_.before = [](int call) { return call == 2 ? Status(Cancelled()) : Status(); };
  ASSERT_FALSE(Take().ok());
  fs::resize_file(request_.dir / "chess01.png", 1000);
  attendant_.before = [](int call) { return call == 4 ? Status(Cancelled()) : Status(); };
  ASSERT_FALSE(Take().ok());
  EXPECT_TRUE(ReadImage(request_.dir / "chess01.png").ok());
}

TEST_F(LiveSeriesTest, ALaserThatStaysDarkStopsTheSeriesBeforeItsPicturesAreWritten) {
  attendant_.before = [&](int call) {
    if (call == 12)
      Hook(device_)->set = [](int, const ChannelSet& on) {
        return on.test(2) ? Status(Error{ErrorCode::kDevice, "laser 2 burnt out; replace it"}) : Status();
      };
    return Status();
  };
  const auto result = Take();
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kDevice);
  EXPECT_FALSE(FindImage(request_.dir, "bgNoHand").has_value());
  EXPECT_TRUE(device_.bench->On().none());
}

}  // namespace
}  // namespace dorsum
