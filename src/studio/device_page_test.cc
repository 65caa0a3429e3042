// SPDX-License-Identifier: Apache-2.0
#include "studio/device_page.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "device/device_error.h"
#include "device/hooked_device_test.h"
#include "device/virtual_bench.h"
#include "jobs/scan_fixture_test.h"
#include "studio/patience_test.h"

namespace dorsum {
namespace {

class DevicePageTest : public ::testing::Test {
 protected:
  DevicePageTest() {
    QSettings().remove("device");
    std::string text = ScanFixture::kDevice;
    text.insert(text.find("[camera]\n") + 9, "source = \"virtual:1\"\n");
    EXPECT_TRUE(WriteFile(dir_ / "device.toml", text).ok());
    QObject::connect(&workbench_, &Workbench::Failed, [this](const Error& e) { failed_ = e.message; });
    QObject::connect(&workbench_.device(), &DeviceSession::Failed,
                     [this](const Error& e) { failed_ = e.message; });
  }
  QString Path() const { return QString::fromStdString((dir_ / "device.toml").string()); }
  void Open(DeviceModel* model) {
    QSignalSpy opened(&workbench_.device(), &DeviceSession::Opened);
    model->Open(Path());
    ASSERT_TRUE(opened.wait(kPatience_ms));
  }
  // What the bench says is lit, past all models.
  ChannelSet Lit() { return bench_ ? bench_->On() : ChannelSet(); }
  void FindBench() {
    std::shared_ptr<VirtualBench> bench;
    bool done = false;
    workbench_.device().Run<int>(
        "look",
        [&bench](Device& device, const Context&) -> Result<int> {
          bench = device.bench;
          return 0;
        },
        [&](const Result<int>&) { done = true; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return done; }, kPatience_ms));
    bench_ = bench;
  }
  template <class T>
  static T* Find(QWidget& page, const char* name) {
    T* found = page.findChild<T*>(name);
    if (found == nullptr) throw std::runtime_error(std::string("no widget ") + name);
    return found;
  }

  TempFolder dir_;
  std::string failed_;
  std::shared_ptr<VirtualBench> bench_;
  Workbench workbench_;
};

TEST_F(DevicePageTest, ALaserLitByHandGoesOffByItself) {
  DeviceModel model(&workbench_, 3.0);
  model.Watch(true);
  Open(&model);
  FindBench();
  ASSERT_EQ(model.switches().size(), 4U);
  EXPECT_TRUE(model.switches()[0].on);  // the LEDs: a picture to begin with
  model.Switch(2, true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return Lit().test(1); }, kPatience_ms));
  EXPECT_GT(model.SecondsLeft(2), 0.0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !Lit().test(1); }, kPatience_ms));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !model.switches()[2].on; }, kPatience_ms));
  EXPECT_TRUE(model.switches()[0].on);
}

TEST_F(DevicePageTest, WhatIsLitIsAskedFromTheController) {
  DeviceModel model(&workbench_);
  model.Watch(true);
  Open(&model);
  FindBench();
  ASSERT_TRUE(QTest::qWaitFor([&] { return model.LitWords().contains("LEDs"); }, kPatience_ms));
  bench_->Switch(ChannelSet(4));  // behind everybody's back
  EXPECT_TRUE(QTest::qWaitFor([&] { return model.LitWords().contains("Laser 2"); }, kPatience_ms));
  model.AllOff();
  EXPECT_TRUE(QTest::qWaitFor([&] { return model.LitWords().contains("all lights are off"); }, kPatience_ms));
}

TEST_F(DevicePageTest, LeavingThePagePutsAllOut) {
  DevicePage page(&workbench_, nullptr);
  page.Enter();
  Open(page.model());
  FindBench();
  page.model()->Switch(1, true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return Lit().test(0); }, kPatience_ms));
  page.Leave();
  EXPECT_TRUE(QTest::qWaitFor([&] { return Lit().none(); }, kPatience_ms));
  page.model()->Switch(1, true);
  QTest::qWait(50);
  EXPECT_TRUE(Lit().none());
}

TEST_F(DevicePageTest, ADeviceIsOpenedSeenExaminedAndClosed) {
  DevicePage page(&workbench_, nullptr);
  page.resize(1100, 680);
  page.show();
  page.Enter();
  Find<QComboBox>(page, "which")->setCurrentText(Path());
  QTest::mouseClick(Find<QPushButton>(page, "open"), Qt::LeftButton);
  auto* picture = Find<FittedPicture>(page, "livePicture");
  ASSERT_TRUE(QTest::qWaitFor([&] { return picture->image().width() == 560; }, kPatience_ms));
  QTest::mouseClick(Find<QPushButton>(page, "light2"), Qt::LeftButton);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return Find<QLabel>(page, "lit")->text().contains("Laser 1"); }, kPatience_ms));
  EXPECT_EQ(Find<QTreeWidget>(page, "settings")->topLevelItemCount(), 9);
  QTest::mouseClick(Find<QPushButton>(page, "allOff"), Qt::LeftButton);
  EXPECT_FALSE(Find<QPushButton>(page, "light2")->isChecked());
  QTest::mouseClick(Find<QPushButton>(page, "examine"), Qt::LeftButton);
  auto* findings = Find<QTreeWidget>(page, "findings");
  ASSERT_TRUE(QTest::qWaitFor([&] { return findings->topLevelItemCount() > 0; }, kPatience_ms));
  EXPECT_EQ(findings->findItems("laser 2", Qt::MatchExactly).size(), 1);
  QTest::mouseClick(Find<QPushButton>(page, "close"), Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !workbench_.device().facts(); }, kPatience_ms));
  EXPECT_EQ(page.findChild<QLabel*>("state")->text(), "No device is open.");
  EXPECT_EQ(DeviceModel::Recent().front(), Path());
  EXPECT_EQ(failed_, "");
}

TEST_F(DevicePageTest, ACameraThatGoesIsSaidAndOpensAgain) {
  DevicePage page(&workbench_, nullptr);
  page.Enter();
  Open(page.model());
  workbench_.device().Run<int>(
      "unplug",
      [](Device& device, const Context&) -> Result<int> {
        Hook(device)->frame = [](int call, Result<Frame> frame) -> Result<Frame> {
          if (call < 3) return frame;
          return DeviceError("the camera is gone; plug it in again");
        };
        return 0;
      },
      [](const Result<int>&) {});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !failed_.empty(); }, kPatience_ms));
  EXPECT_NE(failed_.find("gone"), std::string::npos);
  EXPECT_TRUE(Find<QLabel>(page, "state")->text().contains("Open it again"));
  EXPECT_FALSE(page.model()->switches()[0].on);
  Open(page.model());
  EXPECT_TRUE(page.model()->switches()[0].on);
  auto* picture = Find<FittedPicture>(page, "livePicture");
  EXPECT_TRUE(QTest::qWaitFor([&] { return !picture->image().isNull(); }, kPatience_ms));
}

TEST_F(DevicePageTest, WithoutADeviceTheMachineIsExaminedAndWhyTheDeviceDoesNotOpen) {
  DeviceModel model(&workbench_);
  QSignalSpy examined(&model, &DeviceModel::Examined);
  model.Examine("/nowhere/device.toml");
  ASSERT_TRUE(examined.wait(kPatience_ms));
  ASSERT_TRUE(model.report().has_value());
  EXPECT_EQ(model.report()->findings.back().subject, "device");
  EXPECT_NE(model.report()->findings.back().sentence.find("/nowhere"), std::string::npos);
}

TEST_F(DevicePageTest, NoNameIsNoDevice) {
  DeviceModel model(&workbench_);
  model.Open("  ");
  EXPECT_NE(failed_.find("no device is named"), std::string::npos);
}

}  // namespace
}  // namespace dorsum
