// SPDX-License-Identifier: Apache-2.0
#include "studio/scan_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <cstdlib>

#include "studio/main_window.h"
#include "studio/scan_fixture_studio_test.h"
#include "studio/turning_surface.h"

namespace dorsum {
namespace {

class ScanPageTest : public ScanTest {
 protected:
  // Pictures for people, where DORSUM_SCREENSHOTS names a folder.
  static void Picture(QWidget& window, const char* name) {
    const char* dir = std::getenv("DORSUM_SCREENSHOTS");
    if (dir == nullptr) return;
    QTest::qWait(50);
    window.grab().save(QString("%1/scan-%2.png").arg(dir, name));
  }
};

TEST_F(ScanPageTest, ANewcomerScansAVirtualHandFromOpeningToTheKeptFolder) {
  MainWindow window(&workbench_);
  window.resize(1280, 800);
  window.ShowPage(0);
  window.show();
  auto* page = qobject_cast<ScanPage*>(window.page(0));
  ASSERT_NE(page, nullptr);
  page->Enter();
  Prepare(page->model());
  auto* button = page->findChild<QPushButton*>("scan");
  auto* sentence = page->findChild<QLabel*>("sentence");
  auto* place = page->findChild<QComboBox*>("place");
  EXPECT_EQ(sentence->text(), "No device is open");
  EXPECT_FALSE(place->isVisible());
  Picture(window, "closed");
  OpenDeviceOf(page->model());
  EXPECT_EQ(button->text(), "&Calibrate this virtual device");
  QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_TRUE(Reaches(*page->model(), ScanState::kPreview)) << error_.value_or(Error{}).message;
  ASSERT_TRUE(QTest::qWaitFor([&] { return sentence->text() == "Put your hand down"; }, kPatience_ms));
  ASSERT_TRUE(place->isVisible() && place->isEnabled());
  place->setCurrentIndex(1);
  emit place->activated(1);
  ASSERT_TRUE(Reaches(*page->model(), ScanState::kReady)) << sentence->text().toStdString();
  Picture(window, "ready");
  button->setFocus();
  QTest::keyClick(button, Qt::Key_Space);
  ASSERT_TRUE(QTest::qWaitFor([&] { return page->model()->steps_done() == 3; }, kPatience_ms));
  EXPECT_TRUE(page->findChild<QLabel*>("steps")->isVisible());
  EXPECT_EQ(button->text(), "&Cancel");
  Picture(window, "capturing");
  auto* surface = page->findChild<TurningSurface*>("surface");
  QSignalSpy drawn(surface, &TurningSurface::Drawn);
  ASSERT_TRUE(Reaches(*page->model(), ScanState::kShown)) << error_.value_or(Error{}).message;
  ASSERT_TRUE(drawn.count() > 0 || drawn.wait(kPatience_ms));
  EXPECT_TRUE(
      page->findChild<QLabel*>("quality")->text().contains(QString("finger") + QChar(QChar::Nbsp) + "5"));
  EXPECT_LE(window.minimumSizeHint().width(), 1280);
  Picture(window, "shown");
  QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_TRUE(Reaches(*page->model(), ScanState::kKept));
  EXPECT_TRUE(std::filesystem::exists(workbench_.scan()->folder / "bgHand.png"));
  Picture(window, "kept");
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(page->model()->state(), ScanState::kPreview);
  page->Leave();
}

TEST_F(ScanPageTest, EveryControlHasANameAndItFitsASmallScreen) {
  MainWindow window(&workbench_);
  for (QWidget* control : window.page(0)->findChildren<QWidget*>()) {
    const bool is_control =
        qobject_cast<QAbstractButton*>(control) != nullptr || qobject_cast<QComboBox*>(control) != nullptr;
    if (is_control && control->parentWidget() == window.page(0)) {
      EXPECT_FALSE(control->objectName().isEmpty());
    }
  }
  EXPECT_LE(window.minimumSizeHint().width(), 1280);
  EXPECT_LE(window.minimumSizeHint().height(), 800);
}

}  // namespace
}  // namespace dorsum
