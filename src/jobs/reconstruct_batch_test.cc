// SPDX-License-Identifier: Apache-2.0
#include "jobs/reconstruct_batch.h"

#include <atomic>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "jobs/scan_fixture_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// A folder of captures: a box, one that is refused, one that cannot be read, and things that are no captures.
class BatchTest : public ::testing::Test {
 protected:
  BatchTest() {
    const fs::path captures = dir_ / "captures";
    ScanFixture::CopyFolder(ScanFixture::CaptureDir(ScanFixture::kBox), captures / "box, first");
    ScanFixture::CopyFolder(ScanFixture::CaptureDir(ScanFixture::kKnocked), captures / "knocked");
    ScanFixture::CopyFolder(ScanFixture::CaptureDir(ScanFixture::kBox), captures / "torn");
    fs::resize_file(captures / "torn" / "stripesHand1.png", 1000);
    fs::create_directories(captures / "empty");
    std::ofstream(captures / "notes.txt") << "nothing";
    request_.capture_dir = captures;
    request_.calibration_path = ScanFixture::CalibrationJson();
    request_.out_dir = dir_ / "out";
    request_.report = false;
  }

  BatchSummary Run() {
    const auto summary = ReconstructBatch(request_, {});
    EXPECT_TRUE(summary.ok()) << (summary.ok() ? "" : summary.error().message);
    return summary.ok() ? *summary : BatchSummary{};
  }

  TempFolder dir_;
  ReconstructRequest request_;
};

TEST_F(BatchTest, FailuresAreListedAndNotFatal) {
  const BatchSummary summary = Run();
  ASSERT_EQ(summary.captures.size(), 3U);
  const BatchCapture &box = summary.captures[0], &knocked = summary.captures[1], &torn = summary.captures[2];
  EXPECT_EQ(box.name, "box, first");
  EXPECT_EQ(box.outcome, BatchOutcome::kDone);
  EXPECT_GT(box.points, 500U);
  EXPECT_EQ(knocked.outcome, BatchOutcome::kFailed);
  EXPECT_THAT(knocked.error, HasSubstr("calibrate again"));
  EXPECT_EQ(torn.outcome, BatchOutcome::kFailed);
  EXPECT_THAT(torn.error, HasSubstr("stripesHand1"));
  EXPECT_FALSE(fs::exists(request_.out_dir / "knocked"));
  EXPECT_FALSE(fs::exists(request_.out_dir / "empty"));

  const auto table = ReadFile(request_.out_dir / kBatchTable);
  ASSERT_TRUE(table.ok());
  EXPECT_THAT(*table, HasSubstr("\"box, first\",done," + std::to_string(box.points) + ","));
  EXPECT_THAT(*table, HasSubstr("\nknocked,failed,,,"));

  ReconstructRequest alone = request_;
  alone.capture_dir = request_.capture_dir / "box, first";
  alone.out_dir = dir_ / "alone";
  ASSERT_TRUE(ReconstructFolder(alone, {}).ok());
  for (const char* file : {"points.ply", "surface.ply", "report.json", "mask.png", "height.tiff"}) {
    EXPECT_EQ(*ReadFile(dir_ / "alone" / file), *ReadFile(request_.out_dir / "box, first" / file)) << file;
  }
}

TEST_F(BatchTest, WhatWasDoneInTheSameWayIsKept) {
  fs::remove_all(request_.capture_dir / "knocked");
  fs::remove_all(request_.capture_dir / "torn");
  const std::size_t points = Run().captures[0].points;
  const fs::path surface = request_.out_dir / "box, first" / "surface.ply";
  const auto first = fs::last_write_time(surface);
  const BatchSummary again = Run();
  EXPECT_EQ(again.captures[0].outcome, BatchOutcome::kKept);
  EXPECT_EQ(again.captures[0].points, points);
  EXPECT_EQ(fs::last_write_time(surface), first);

  request_.options.lasers = {0, 1};
  EXPECT_EQ(Run().captures[0].outcome, BatchOutcome::kDone) << "other options";
  fs::remove(surface);
  EXPECT_EQ(Run().captures[0].outcome, BatchOutcome::kDone) << "a file is gone";
  ASSERT_TRUE(WriteFile(request_.out_dir / "box, first" / "report.json", "{\"program\": [").ok());
  EXPECT_EQ(Run().captures[0].outcome, BatchOutcome::kDone) << "a torn record";
  ASSERT_TRUE(WriteFile(request_.out_dir / "box, first" / "report.json", "[1, null]").ok());
  EXPECT_EQ(Run().captures[0].outcome, BatchOutcome::kDone) << "a record of something else";
  fs::remove(request_.capture_dir / "box, first" / "stripesHand2.png");
  EXPECT_EQ(Run().captures[0].outcome, BatchOutcome::kDone) << "a picture is gone";
  fs::last_write_time(request_.capture_dir / "box, first" / "bgHand.png",
                      fs::file_time_type::clock::now() + std::chrono::hours(1));
  EXPECT_EQ(Run().captures[0].outcome, BatchOutcome::kDone) << "another picture";
}

TEST_F(BatchTest, AnInterruptKeepsWhatIsDone) {
  std::atomic<bool> cancel{false};
  Context context;
  context.threads = 1;
  context.cancel = &cancel;
  context.progress = [&](std::string_view, double share) { cancel = share > 0.0; };
  const auto summary = ReconstructBatch(request_, context);
  ASSERT_FALSE(summary.ok());
  EXPECT_EQ(summary.error().code, ErrorCode::kCancelled);
  EXPECT_THAT(summary.error().message, HasSubstr("of 3 captures; the same command goes on from there"));
  EXPECT_TRUE(fs::exists(request_.out_dir / "box, first" / "surface.ply"));
  EXPECT_EQ(Run().captures[0].outcome, BatchOutcome::kKept);
}

TEST_F(BatchTest, FoldersThatCannotBeRight) {
  const auto error = [&] {
    const auto summary = ReconstructBatch(request_, {});
    EXPECT_FALSE(summary.ok());
    return summary.ok() ? "" : summary.error().message;
  };
  const fs::path captures = request_.capture_dir;
  request_.out_dir = captures;
  EXPECT_THAT(error(), HasSubstr("name another folder"));
  EXPECT_FALSE(fs::exists(captures / kBatchTable));
  request_.out_dir = captures / "notes.txt" / "out";
  EXPECT_THAT(error(), HasSubstr("notes.txt"));
  request_.out_dir = dir_ / "out";
  request_.capture_dir = captures / "empty";
  EXPECT_THAT(error(), HasSubstr("holds an image bgHand"));
  request_.capture_dir = captures / "nowhere";
  EXPECT_THAT(error(), HasSubstr("nowhere"));
  EXPECT_FALSE(fs::exists(dir_ / "out"));
}

}  // namespace
}  // namespace dorsum
