// SPDX-License-Identifier: Apache-2.0
// Each page on a small screen, light and dark: nothing is cut, nothing makes the window larger than the
// screen.
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QPalette>
#include <QScrollArea>
#include <QScrollBar>

#include "jobs/campaign_add.h"
#include "jobs/campaign_create.h"
#include "studio/campaign_page.h"
#include "studio/campaign_people.h"
#include "studio/fixture_scan_test.h"
#include "studio/scan_page.h"
#include "studio/stages_page.h"
#include "studio/window_fixture_test.h"

namespace dorsum {
namespace {

const QSize kSmall(1280, 800);      // at 100 %
const QSize kSmallAt200(640, 400);  // the same screen at 200 %, in the units of widgets

QPalette DarkPalette() {
  QPalette dark(QColor(45, 45, 48), QColor(37, 37, 40));
  dark.setColor(QPalette::Base, QColor(30, 30, 32));
  dark.setColor(QPalette::Link, QColor(120, 180, 255));
  return dark;
}

class PagesTest : public WindowTest {
 protected:
  ~PagesTest() override { QApplication::setPalette(QPalette()); }

  // Something on every page.
  void Fill() {
    Calibrate();
    workbench_.SetScan(FixtureScan(ScanFixture::kHand));
    ASSERT_TRUE(CreateCampaign({dir_ / "study", "study", {}, {}, {}}, {}).ok());
    for (const char* id : {"p01", "p02", "p03"})
      ASSERT_TRUE(
          AddPerson({dir_ / "study", {id, "woman", "20-29", "2024-05-31", false}, false, ""}, {}).ok());
    auto* campaign = GoTo<CampaignPage>();
    campaign->model()->Open(dir_ / "study");
    ASSERT_TRUE(Until([&] { return campaign->model()->view() != nullptr; }));
    campaign->findChild<CampaignPeople*>()->Choose({"p02", 1, CampaignHand::kLeft});
    QSignalSpy frame(&workbench_.device(), &DeviceSession::FrameReady);
    workbench_.device().Open(DeviceFile());
    ASSERT_TRUE(frame.wait(kPatience_ms));
    auto* stages = GoTo<StagesPage>();
    QSignalSpy compared(stages, &StagesPage::Compared);
    ASSERT_TRUE(Until([&] { return stages->comparison() || compared.count() > 0; }));
  }
  void Picture(int page, const QSize& size, const char* light) {
    const QString folder = qEnvironmentVariable("DORSUM_SCREENSHOTS");
    if (folder.isEmpty()) return;
    QTest::qWait(400);
    const double ratio = window_->devicePixelRatioF();
    EXPECT_TRUE(window_->grab().save(QString("%1/page-%2-%3x%4-at%5-%6.png")
                                         .arg(folder)
                                         .arg(page)
                                         .arg(ratio * size.width())
                                         .arg(ratio * size.height())
                                         .arg(100 * ratio)
                                         .arg(light)));
  }
  static QScrollArea* AreaOf(Page* page) {
    return qobject_cast<QScrollArea*>(page->parentWidget()->parentWidget());
  }
  // As the Tab key does, from the inside out.
  static void MoveIntoSight(QWidget* control) {
    for (QWidget* above = control->parentWidget(); above != nullptr; above = above->parentWidget()) {
      if (auto* area = qobject_cast<QScrollArea*>(above)) area->ensureWidgetVisible(control, 2, 2);
    }
    QTest::qWait(1);
  }
};

TEST_F(PagesTest, OnASmallScreenNothingIsCutAndAt200PercentEverythingCanBeReached) {
  ASSERT_NO_FATAL_FAILURE(Fill());
  for (const QSize& size : {kSmall, kSmallAt200}) {
    for (int i = 0; i < window_->pages(); ++i) {
      window_->ShowPage(i);
      window_->resize(size);
      QTest::qWait(100);
      EXPECT_EQ(window_->size(), size) << "page " << i;
      QScrollArea* area = AreaOf(window_->page(i));
      ASSERT_NE(area, nullptr);
      if (size == kSmall || i == 0) {
        EXPECT_FALSE(area->horizontalScrollBar()->isVisible()) << "page " << i;
        EXPECT_FALSE(area->verticalScrollBar()->isVisible()) << "page " << i;
      }
      Picture(i, size, "light");
      for (QWidget* control : window_->page(i)->findChildren<QWidget*>()) {
        const bool pressed = qobject_cast<QAbstractButton*>(control) || qobject_cast<QComboBox*>(control);
        if (!pressed || control->objectName().startsWith("qt_") || !control->isVisible()) continue;
        MoveIntoSight(control);
        EXPECT_EQ(control->visibleRegion().boundingRect(), control->rect())
            << control->objectName().toStdString() << " of page " << i << " at " << size.width();
      }
    }
  }
  EXPECT_EQ(Find<QWidget>(window_.get(), "classic")->width(), Find<QWidget>(window_.get(), "ours")->width());
  const auto* search = Find<QLineEdit>(window_.get(), "search");
  EXPECT_GT(search->width(), search->fontMetrics().horizontalAdvance(search->placeholderText()));
  QApplication::setPalette(DarkPalette());
  for (int i = 0; i < window_->pages(); ++i) {
    window_->ShowPage(i);
    window_->resize(kSmall);
    QTest::qWait(50);
    const QImage seen = window_->grab().toImage();
    EXPECT_LT(qGray(seen.pixel(3, seen.height() / 2)), 80) << "page " << i;
    Picture(i, kSmall, "dark");
  }
}

}  // namespace
}  // namespace dorsum
