// SPDX-License-Identifier: Apache-2.0
#include "studio/stages_page.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include <gtest/gtest.h>

#include "studio/fixture_scan_test.h"
#include "studio/main_window.h"
#include "studio/option_panel.h"
#include "studio/patience_test.h"
#include "studio/picture_view.h"

namespace dorsum {
namespace {

class StagesPageTest : public ::testing::Test {
 protected:
  StagesPageTest() {
    page_.resize(1180, 700);
    page_.show();
  }
  PictureView* View(const char* name) { return page_.findChild<PictureView*>(name); }

  Workbench workbench_;
  StagesPage page_{&workbench_, nullptr};
};

TEST_F(StagesPageTest, WithoutACaptureItSaysWhatToDo) {
  page_.Enter();
  EXPECT_TRUE(View("ours")->words().contains("capture folder"));
  auto scan = std::make_shared<Scan>();
  workbench_.SetScan(scan);
  EXPECT_TRUE(View("classic")->words().contains("Only a surface"));
  EXPECT_FALSE(workbench_.jobs().busy());
}

TEST_F(StagesPageTest, ItRunsOnlyWhereItIsSeenAndAnewWhenAParameterChanges) {
  workbench_.SetScan(FixtureScan(ScanFixture::kHand));
  EXPECT_FALSE(workbench_.jobs().busy()) << "nobody looks at it";
  QSignalSpy compared(&page_, &StagesPage::Compared);
  page_.Enter();
  ASSERT_TRUE(compared.wait(kPatience_ms));
  auto* list = page_.findChild<QListWidget*>("stages");
  ASSERT_EQ(list->count(), static_cast<int>(page_.comparison()->keys.size()));
  for (int i = 0; i < list->count(); ++i)
    EXPECT_FALSE(list->item(i)->text().contains('/'))
        << list->item(i)->text().toStdString() << " has no title";
  for (int i = 0; i < list->count(); ++i) {
    if (list->item(i)->text().contains("Laser 1: orders")) list->setCurrentRow(i);
  }
  EXPECT_FALSE(View("ours")->picture().isNull());
  EXPECT_FALSE(View("classic")->picture().isNull());
  EXPECT_TRUE(page_.findChild<QLabel*>("oursFigures")->text().contains("points"));
  const auto before = page_.comparison();

  auto* area = qobject_cast<QSpinBox*>(page_.options()->Editor("stripe-min-rows"));
  area->setValue(area->value() + 60);
  ASSERT_TRUE(compared.wait(kPatience_ms));
  EXPECT_NE(page_.comparison(), before);
  EXPECT_LT(page_.comparison()->classic.points, before->classic.points);
  EXPECT_TRUE(page_.findChild<QLabel*>("classicFigures")->text().contains(QChar(0x2212)));
  EXPECT_TRUE(list->currentItem()->text().contains("Laser 1: orders")) << "the stage stays";
  EXPECT_TRUE(list->currentItem()->text().startsWith(QChar(0x2022)));
  QTest::mouseClick(page_.findChild<QPushButton*>("undo"), Qt::LeftButton);
  ASSERT_TRUE(compared.wait(kPatience_ms));
  EXPECT_EQ(page_.comparison()->classic.points, before->classic.points);
}

TEST_F(StagesPageTest, AChangeCancelsTheRunThatIsUnderWay) {
  workbench_.SetScan(FixtureScan(ScanFixture::kHand));
  QSignalSpy compared(&page_, &StagesPage::Compared);
  QSignalSpy finished(&workbench_.jobs(), &JobRunner::Finished);
  page_.Enter();
  ASSERT_TRUE(workbench_.jobs().busy());
  page_.Leave();
  ASSERT_TRUE(finished.wait(kPatience_ms));
  EXPECT_EQ(page_.comparison(), nullptr);
  page_.Enter();
  ASSERT_TRUE(workbench_.jobs().busy());
  workbench_.SetScan(FixtureScan(ScanFixture::kBox));
  ASSERT_TRUE(compared.wait(kPatience_ms));
  EXPECT_EQ(page_.comparison()->ours.points, workbench_.scan()->surface.points.size());
}

TEST_F(StagesPageTest, ItWaitsForTheWorkOfOthers) {
  workbench_.SetScan(FixtureScan(ScanFixture::kBox));
  std::atomic<bool> go = false;
  workbench_.jobs().Run<int>(
      "other",
      [&](const Context&) -> Result<int> {
        while (!go) std::this_thread::yield();
        return 1;
      },
      [](const Result<int>&) {});
  QSignalSpy compared(&page_, &StagesPage::Compared);
  page_.Enter();
  EXPECT_TRUE(View("ours")->words().contains("other work"));
  go = true;
  ASSERT_TRUE(compared.wait(kPatience_ms));
}

TEST_F(StagesPageTest, TheTwoViewsLookAtTheSamePart) {
  PictureView* one = View("classic");
  PictureView* other = View("ours");
  one->SetPicture(cv::Mat(300, 400, CV_8UC3, cv::Scalar(10, 200, 30)));
  other->SetPicture(cv::Mat(600, 800, CV_8UC1, cv::Scalar(90)));
  QTest::keyClick(one, Qt::Key_Plus);
  QTest::keyClick(one, Qt::Key_Plus);
  QTest::keyClick(one, Qt::Key_Right);
  EXPECT_GT(other->look().zoom, 1.5);
  EXPECT_GT(other->look().centre.x(), 0.5);
  EXPECT_EQ(one->look(), other->look());
  const QColor middle = one->grab().toImage().pixelColor(one->width() / 2, one->height() / 2);
  EXPECT_EQ(middle, QColor(30, 200, 10));
  QTest::keyClick(other, Qt::Key_0);
  EXPECT_EQ(one->look(), PictureView::Look());
}

TEST_F(StagesPageTest, AComputationThatThePersonStoppedCanBeBegunAgain) {
  workbench_.SetScan(FixtureScan(ScanFixture::kBox));
  QSignalSpy compared(&page_, &StagesPage::Compared);
  QSignalSpy finished(&workbench_.jobs(), &JobRunner::Finished);
  page_.Enter();
  ASSERT_TRUE(workbench_.jobs().busy());
  workbench_.jobs().Cancel();
  ASSERT_TRUE(finished.wait(kPatience_ms));
  EXPECT_EQ(page_.comparison(), nullptr);
  EXPECT_TRUE(View("ours")->words().contains("stopped"));
  auto* again = page_.findChild<QPushButton*>("again");
  ASSERT_TRUE(again->isVisible());
  QTest::mouseClick(again, Qt::LeftButton);
  ASSERT_TRUE(compared.wait(kPatience_ms));
  EXPECT_FALSE(again->isVisible());
  EXPECT_FALSE(View("ours")->picture().isNull());
}

TEST_F(StagesPageTest, WhatWasBeforeTheChangeIsShownAgainOnRequest) {
  workbench_.SetScan(FixtureScan(ScanFixture::kBox));
  QSignalSpy compared(&page_, &StagesPage::Compared);
  page_.Enter();
  ASSERT_TRUE(compared.wait(kPatience_ms));
  auto* button = page_.findChild<QPushButton*>("before");
  auto* state = page_.findChild<QLabel*>("state");
  EXPECT_FALSE(button->isEnabled());
  auto* list = page_.findChild<QListWidget*>("stages");
  for (int i = 0; i < list->count(); ++i) {
    if (list->item(i)->text().endsWith("Laser 1: stripes")) list->setCurrentRow(i);
  }
  const QImage before = View("classic")->picture();
  auto* offset = qobject_cast<QDoubleSpinBox*>(page_.options()->Editor("stripe-offset"));
  offset->setValue(offset->value() + 6.0);
  EXPECT_TRUE(state->text().contains("parameters changed")) << state->text().toStdString();
  ASSERT_TRUE(compared.wait(kPatience_ms));
  EXPECT_TRUE(state->text().contains("a dot marks them")) << state->text().toStdString();
  EXPECT_NE(View("classic")->picture(), before);
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(View("classic")->picture(), before);
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_NE(View("classic")->picture(), before);
}

TEST_F(StagesPageTest, AChainThatFailsSaysWhyAndWhatToDo) {
  workbench_.SetScan(FixtureScan(ScanFixture::kBox));
  QSignalSpy compared(&page_, &StagesPage::Compared);
  page_.Enter();
  ASSERT_TRUE(compared.wait(kPatience_ms));
  qobject_cast<QDoubleSpinBox*>(page_.options()->Editor("mask-min-contrast"))->setValue(255.0);
  ASSERT_TRUE(compared.wait(kPatience_ms));
  EXPECT_TRUE(page_.findChild<QLabel*>("classicFigures")->text().contains("Take the last change back"));
  EXPECT_FALSE(page_.findChild<QLabel*>("oursFigures")->text().contains("ended early"));
}

// A picture for people, where DORSUM_SCREENSHOTS names a folder: the default device's own camera, so that it
// shows what a person sees.
TEST(StagesPagePicture, TheWindowAtItsUsualSize) {
  const QString folder = qEnvironmentVariable("DORSUM_SCREENSHOTS");
  if (folder.isEmpty()) GTEST_SKIP() << "DORSUM_SCREENSHOTS names no folder";
  Workbench workbench;
  MainWindow window(&workbench);
  window.resize(1280, 800);
  StagesPage* page = nullptr;
  for (int i = 0; i < window.pages(); ++i) {
    page = qobject_cast<StagesPage*>(window.page(i));
    if (page != nullptr) {
      window.ShowPage(i);
      break;
    }
  }
  ASSERT_NE(page, nullptr);
  window.show();
  QTest::qWait(100);
  EXPECT_TRUE(window.grab().save(folder + "/studio-stages-empty.png"));
  QSignalSpy compared(page, &StagesPage::Compared);
  workbench.SetScan(FixtureScan(ScanFixture::kHand));
  ASSERT_TRUE(compared.wait(kPatience_ms));
  qobject_cast<QSpinBox*>(page->options()->Editor("stripe-min-rows"))->setValue(40);
  ASSERT_TRUE(compared.wait(kPatience_ms));
  auto* list = page->findChild<QListWidget*>("stages");
  for (int i = 0; i < list->count(); ++i) {
    if (list->item(i)->text().contains("Laser 1: orders")) list->setCurrentRow(i);
  }
  QTest::qWait(100);
  EXPECT_TRUE(window.grab().save(folder + "/studio-stages-orders.png"));
}

}  // namespace
}  // namespace dorsum
