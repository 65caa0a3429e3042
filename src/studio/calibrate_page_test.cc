// SPDX-License-Identifier: Apache-2.0
#include "studio/calibrate_page.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>
#include <cmath>

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "captures/image_file.h"
#include "device/device_error.h"
#include "device/hooked_device_test.h"
#include "device/virtual_bench.h"
#include "jobs/scan_fixture_test.h"
#include "studio/coverage_view.h"
#include "studio/patience_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

class CalibratePageTest : public ::testing::Test {
 protected:
  CalibratePageTest() {
    std::string text = ScanFixture::kDevice;
    text.insert(text.find("[camera]\n") + 9, "source = \"virtual:1\"\n");
    EXPECT_TRUE(WriteFile(dir_ / "device.toml", text).ok());
    QObject::connect(&workbench_, &Workbench::Failed, [this](const Error& e) { failed_ = e; });
  }
  void Open() {
    QSignalSpy opened(&workbench_.device(), &DeviceSession::Opened);
    workbench_.device().Open((dir_ / "device.toml").string());
    ASSERT_TRUE(opened.wait(kPatience_ms));
  }
  void SetPlaces(CalibrateModel* model) {
    model->SetFolder(dir_ / "series");
    model->SetFile(dir_ / "out" / "calibration.json");
  }
  // Something done with the device in its own thread while nothing runs there.
  void WithDevice(const std::function<void(Device&)>& act) {
    bool done = false;
    workbench_.device().Run<int>(
        "act",
        [act](Device& device, const Context&) -> Result<int> {
          act(device);
          return 0;
        },
        [&](const Result<int>&) { done = true; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return done; }, kPatience_ms));
  }
  static bool Until(const std::function<bool()>& done) { return QTest::qWaitFor(done, kPatience_ms); }

  TempFolder dir_;
  std::optional<Error> failed_;
  Workbench workbench_;
};

TEST_F(CalibratePageTest, APersonIsLedStepByStepAndMayStopAndGoOn) {
  CalibratePage page(&workbench_, nullptr);
  page.resize(1100, 680);
  page.show();
  page.Enter();
  Open();
  SetPlaces(page.model());
  auto* next = page.findChild<QPushButton*>("next");
  auto* steps = page.findChild<QListWidget*>("steps");
  auto* picture = page.findChild<CoverageView*>("seriesPicture");
  EXPECT_EQ(steps->count(), 24);
  EXPECT_FALSE(next->isEnabled());
  std::shared_ptr<VirtualBench> bench;
  WithDevice([&](Device& device) { bench = device.bench; });
  QTest::mouseClick(page.findChild<QPushButton*>("take"), Qt::LeftButton);
  ASSERT_TRUE(Until([&] { return next->isEnabled(); }));
  EXPECT_TRUE(page.findChild<QLabel*>("words")->text().startsWith("Lay the chessboard flat"));
  ASSERT_TRUE(Until([&] { return !picture->image().isNull(); }));
  EXPECT_TRUE(bench->On().test(1));  // the stripes that guide the board
  page.Leave();
  EXPECT_TRUE(Until([&] { return bench->On().none(); }));  // nobody sees them
  page.Enter();
  EXPECT_TRUE(Until([&] { return bench->On().test(1); }));
  for (int step = 0; step < 2; ++step) {
    ASSERT_TRUE(Until([&] { return next->isEnabled(); }));
    QTest::mouseClick(next, Qt::LeftButton);
    ASSERT_TRUE(Until([&] { return steps->item(step)->text().endsWith("done"); }));
  }
  ASSERT_TRUE(Until([&] { return next->isEnabled(); }));
  EXPECT_EQ(page.model()->boards().size(), 2U);
  EXPECT_GT(page.model()->coverage()->Share(), 0.1);
  QTest::mouseClick(page.findChild<QPushButton*>("stop"), Qt::LeftButton);
  ASSERT_TRUE(Until([&] { return !page.model()->taking(); }));
  EXPECT_TRUE(Until([&] { return bench->On().none(); }));
  EXPECT_EQ(failed_->code, ErrorCode::kCancelled);
  EXPECT_FALSE(fs::exists(dir_ / "out"));

  QTest::mouseClick(page.findChild<QPushButton*>("take"), Qt::LeftButton);
  ASSERT_TRUE(Until([&] { return next->isEnabled(); }));
  EXPECT_TRUE(steps->item(2)->text().endsWith("now"));
  EXPECT_EQ(page.model()->boards().size(), 2U);
  page.model()->Stop();
  ASSERT_TRUE(Until([&] { return !page.model()->taking(); }));
}

TEST_F(CalibratePageTest, AVirtualDeviceCalibratesByItselfAndTheOneBeforeComesBack) {
  CalibratePage page(&workbench_, nullptr);
  page.resize(1100, 680);
  page.show();
  Open();
  SetPlaces(page.model());
  page.model()->GoOnByItself(true);
  QSignalSpy loaded(&workbench_, &Workbench::CalibrationChanged);
  page.model()->Take();
  ASSERT_TRUE(loaded.wait(kPatience_ms)) << (failed_ ? failed_->message : "");
  const auto outcome = page.model()->outcome();
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(outcome->has_before);
  EXPECT_GE(outcome->boards.size(), 12U);
  EXPECT_FALSE(outcome->boards.front().picture.isNull());
  EXPECT_EQ(outcome->sheets.size(), 3U);
  for (const PartReport& part : outcome->parts) EXPECT_NE(part.grade, Grade::kBad) << part.part;
  EXPECT_EQ(workbench_.calibration_path(), dir_ / "out" / "calibration.json");
  EXPECT_EQ(page.findChild<QListWidget*>("boardList")->count(), static_cast<int>(outcome->boards.size()));
  EXPECT_FALSE(page.model()->CanGoBack());

  // Again, from the folder: the same figures, and the way back.
  const std::string first = ReadFile(dir_ / "out" / "calibration.json").value();
  page.model()->Calibrate();
  ASSERT_TRUE(loaded.wait(kPatience_ms));
  ASSERT_TRUE(page.model()->outcome()->has_before);
  for (const FigureChange& change : page.model()->outcome()->changes) {
    ASSERT_TRUE(change.before && change.after);
    EXPECT_NEAR(*change.before, *change.after, 1e-6 * std::abs(*change.after));  // in no digit that is shown
  }
  EXPECT_EQ(page.findChild<QTreeWidget*>("changes")->topLevelItemCount(),
            static_cast<int>(page.model()->outcome()->changes.size()));
  ASSERT_TRUE(page.model()->CanGoBack());
  QTest::mouseClick(page.findChild<QPushButton*>("goBack"), Qt::LeftButton);
  ASSERT_TRUE(loaded.count() == 3 || loaded.wait(kPatience_ms));
  EXPECT_EQ(ReadFile(dir_ / "out" / "calibration.json").value(), first);
  EXPECT_FALSE(fs::exists(dir_ / "out" / "calibration.before.json"));
}

TEST_F(CalibratePageTest, ADeviceThatGoesInTheMiddleIsSaidAndTheSeriesGoesOnAfterwards) {
  CalibrateModel model(&workbench_);
  Open();
  SetPlaces(&model);
  std::shared_ptr<DeviceHooks> hooks;
  WithDevice([&](Device& device) {
    hooks = Hook(device);
    hooks->frame = [](int call, Result<Frame> frame) -> Result<Frame> {
      if (call < 12) return frame;
      return DeviceError("the camera is gone; plug it in again");
    };
  });
  model.GoOnByItself(true);
  model.Take();
  ASSERT_TRUE(Until([&] { return !model.taking(); }));
  EXPECT_EQ(failed_->code, ErrorCode::kDevice);
  EXPECT_TRUE(model.words().contains("broke off"));
  EXPECT_TRUE(FindImage(dir_ / "series", "chess00").has_value());
  Open();
  EXPECT_EQ(model.steps().front().state, StepRow::State::kDone);
  model.GoOnByItself(false);
  model.Take();
  ASSERT_TRUE(Until([&] { return model.waiting(); }));
  EXPECT_FALSE(model.words().startsWith("Lay the chessboard flat on the backplane, its middle"));
  model.Stop();
  ASSERT_TRUE(Until([&] { return !model.taking(); }));
}

TEST_F(CalibratePageTest, AnUnwritableFolderAndAWrongOneAreSentences) {
  CalibrateModel model(&workbench_);
  model.Take();
  EXPECT_NE(failed_->message.find("no device is open"), std::string::npos);
  Open();
  ASSERT_TRUE(WriteFile(dir_ / "junk", "not a folder").ok());
  model.SetFolder(dir_ / "junk" / "series");
  model.Take();
  ASSERT_TRUE(Until([&] { return !model.taking(); }));
  EXPECT_EQ(failed_->code, ErrorCode::kBadInput);
  EXPECT_NE(failed_->message.find("cannot make the folder"), std::string::npos);

  fs::create_directories(dir_ / "empty");
  model.SetFolder(dir_ / "empty");
  model.SetFile(dir_ / "out" / "calibration.json");
  failed_.reset();
  model.Calibrate();
  ASSERT_TRUE(Until([&] { return failed_.has_value(); }));
  EXPECT_EQ(failed_->code, ErrorCode::kBadInput);
  EXPECT_FALSE(model.outcome());
  EXPECT_FALSE(workbench_.calibration());

  failed_.reset();
  model.SetFolder(ScanFixture::CalibrationDir());
  model.SetFile(dir_ / "junk" / "calibration.json");
  model.Calibrate();
  ASSERT_TRUE(Until([&] { return failed_.has_value(); }));
  EXPECT_EQ(failed_->code, ErrorCode::kBadInput);
}

TEST_F(CalibratePageTest, CalibratingIsCancelledAndNothingIsWritten) {
  CalibrateModel model(&workbench_);
  model.SetFolder(ScanFixture::CalibrationDir());
  model.SetFile(dir_ / "calibration.json");
  model.Calibrate();
  workbench_.jobs().Cancel();
  ASSERT_TRUE(Until([&] { return failed_.has_value(); }));
  EXPECT_EQ(failed_->code, ErrorCode::kCancelled);
  EXPECT_FALSE(fs::exists(dir_ / "calibration.json"));
}

TEST_F(CalibratePageTest, ThePageGoesWhileItsSeriesWaits) {
  {
    CalibrateModel model(&workbench_);
    Open();
    SetPlaces(&model);
    model.Take();
    ASSERT_TRUE(Until([&] { return model.waiting(); }));
  }
  EXPECT_TRUE(Until([&] { return !workbench_.device().busy(); }));
}

TEST(CompareFigures, WhatOnlyOneOfBothHasIsKept) {
  const std::vector<PartReport> before = {
      {"camera", Grade::kGood, "", {{"rms", 0.2, "px"}, {"old", 1.0, ""}}}};
  const std::vector<PartReport> after = {
      {"camera", Grade::kGood, "", {{"rms", 0.1, "px"}, {"new", 2.0, ""}}}};
  const auto changes = CompareFigures(before, after);
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_EQ(changes[0].before, 0.2);
  EXPECT_EQ(changes[0].after, 0.1);
  EXPECT_FALSE(changes[1].before.has_value());
  EXPECT_FALSE(changes[2].after.has_value());
}

}  // namespace
}  // namespace dorsum
