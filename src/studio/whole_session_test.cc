// SPDX-License-Identifier: Apache-2.0
// A session as a person would have it, through the window alone.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTabWidget>
#include <QTreeWidget>
#include <cstdio>

#include "studio/calibrate_page.h"
#include "studio/campaign_page.h"
#include "studio/campaign_people.h"
#include "studio/device_page.h"
#include "studio/loop_probe_test.h"
#include "studio/option_panel.h"
#include "studio/patience_test.h"
#include "studio/scan_page.h"
#include "studio/stages_page.h"
#include "studio/surface_page.h"
#include "studio/surface_view.h"
#include "studio/turning_surface.h"
#include "studio/window_fixture_test.h"
#include "surface/ply.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

class WholeSessionTest : public WindowTest {
 protected:
  // Of the calibrate page, with the folders that a person has.
  void CalibrateScreenshot(CalibratePage* page, const char* name, LoopProbe* probe = nullptr) {
    std::vector<QString> before;
    for (const char* edit : {"folder", "file"}) before.push_back(Find<QLineEdit>(page, edit)->text());
    Find<QLineEdit>(page, "folder")->setText("/home/user/Documents/Dorsum/four lasers/calibration");
    Find<QLineEdit>(page, "file")->setText("/home/user/Documents/Dorsum/four lasers/calibration.json");
    Screenshot(name, probe);
    Find<QLineEdit>(page, "folder")->setText(before[0]);
    Find<QLineEdit>(page, "file")->setText(before[1]);
  }
  // For eyes and for the documents: with DORSUM_SCREENSHOTS=FOLDER the window is written there.
  void Screenshot(const char* name, LoopProbe* probe = nullptr) {
    const QString folder = qEnvironmentVariable("DORSUM_SCREENSHOTS");
    if (folder.isEmpty()) return;
    QTest::qWait(300);
    EXPECT_TRUE(window_->grab().save(folder + "/" + name + ".png"));
    if (probe != nullptr) probe->Restart();
  }
  // DORSUM_SESSION_DEVICE=virtual is the device at its full size, which takes minutes.
  std::string Which() {
    const QString which = qEnvironmentVariable("DORSUM_SESSION_DEVICE");
    return which.isEmpty() ? DeviceFile() : which.toStdString();
  }
  // The window answers: not later than five times what it takes at rest, or a tenth of a second. In a run of
  // the tests a machine may be busy otherwise, or draw in software: there the time of painting the window,
  // and what the machine takes from every thread, are the measure too.
  void ExpectFluid(LoopProbe* probe, const char* during) const {
    const double gap = probe->longest_ms(), beside = probe->longest_beside_ms();
    std::printf(
        "[ figure ] longest wait while %s: %.0f ms (at rest %.0f ms, painting %.0f ms, a thread beside it "
        "%.0f ms)\n",
        during, gap, idle_ms_, painting_ms_, beside);
    if (kSanitized) return;
    EXPECT_LE(gap, std::max({5.0 * idle_ms_, 5.0 * painting_ms_, 100.0}) + 2.0 * beside) << during;
  }

  void All();  // one after the other
  void Idle();
  void Paint();
  void OpenTheDevice();
  void CalibrateIt();
  void ScanAHand();
  void MeasureIt();
  void Export();
  void LookAtTheStages();
  void CaptureForACampaign();

  double idle_ms_ = 0.0, painting_ms_ = 0.0;
};

void WholeSessionTest::Idle() {
  LoopProbe probe;
  QTest::qWait(1000);
  idle_ms_ = probe.longest_ms();
  Paint();
}

// What painting this page takes here.
void WholeSessionTest::Paint() {
  LoopProbe probe;
  for (int i = 0; i < 20; ++i) {
    for (QWidget* widget : window_->findChildren<QWidget*>()) widget->update();
    QTest::qWait(20);
  }
  painting_ms_ = std::max(painting_ms_, probe.longest_ms());
}

void WholeSessionTest::OpenTheDevice() {
  auto* page = GoTo<DevicePage>();
  Find<QComboBox>(page, "which")->setCurrentText(QString::fromStdString(Which()));
  LoopProbe probe;
  Click(page, "open");
  auto* picture = Find<FittedPicture>(page, "livePicture");
  ASSERT_TRUE(Until([&] { return !picture->image().isNull(); }));
  Find<QTabWidget>(page, "tables")->setCurrentIndex(1);
  Click(page, "examine");
  ASSERT_TRUE(Until([&] { return Find<QTreeWidget>(page, "findings")->topLevelItemCount() > 0; }));
  ExpectFluid(&probe, "the device is opened and examined");
  Screenshot("studio-device");
}

void WholeSessionTest::CalibrateIt() {
  auto* page = GoTo<CalibratePage>();
  const auto type = [&](const char* name, const fs::path& path) {
    auto* edit = Find<QLineEdit>(page, name);
    edit->setText(QString::fromStdString(path.string()));
    emit edit->editingFinished();
  };
  type("folder", dir_ / "series");
  type("file", dir_ / "calibration.json");
  Find<QCheckBox>(page, "byItself")->setChecked(true);
  LoopProbe probe;
  Click(page, "take");
  ASSERT_TRUE(Until([&] { return page->model()->boards().size() >= 6 || error_; }));
  CalibrateScreenshot(page, "studio-calibrate", &probe);
  ASSERT_TRUE(Until([&] { return workbench_.calibration() || error_; }));
  ExpectFluid(&probe, "it is calibrated");
  ASSERT_FALSE(error_) << error_->message;
  CalibrateScreenshot(page, "studio-calibrate-result");
}

void WholeSessionTest::ScanAHand() {
  auto* page = GoTo<ScanPage>();
  page->model()->SetFolder(dir_ / "kept");
  auto* place = Find<QComboBox>(page, "place");
  place->setCurrentIndex(1);
  emit place->activated(1);
  ASSERT_TRUE(Until([&] { return page->model()->state() == ScanState::kReady; }));
  Screenshot("studio-scan");
  auto* surface = Find<TurningSurface>(page, "surface");
  QSignalSpy drawn(surface, &TurningSurface::Drawn);
  LoopProbe probe;
  Click(page, "scan");
  ASSERT_TRUE(Until([&] { return page->model()->state() == ScanState::kShown || error_; }));
  ASSERT_FALSE(error_) << error_->message;
  ASSERT_TRUE(Until([&] { return drawn.count() > 0; }));
  ExpectFluid(&probe, "a hand is scanned and its surface made");
  Screenshot("studio-scan-shown");
  Click(page, "scan");
  ASSERT_TRUE(Until([&] { return page->model()->state() == ScanState::kKept; }));
  EXPECT_TRUE(LoadCapture(workbench_.scan()->folder, {}, {0, 1, 2}).ok());
}

void WholeSessionTest::MeasureIt() {
  auto* page = GoTo<SurfacePage>();
  ASSERT_TRUE(Until([&] { return !page->busy(); }));
  auto* view = Find<SurfaceView>(page, "surfaceView");
  QTest::qWait(200);
  Paint();
  LoopProbe probe;
  Click(page, "modeDistance");
  const QPoint middle = view->rect().center(), aside(view->height() / 20, view->height() / 40);
  QTest::mouseClick(view, Qt::LeftButton, {}, middle - aside);
  QTest::mouseClick(view, Qt::LeftButton, {}, middle + aside);
  ASSERT_EQ(page->places().size(), 2U);
  ASSERT_TRUE(Until([&] { return page->distance().has_value() || error_; }));
  ASSERT_FALSE(error_) << error_->message;
  const double straight = (page->places()[0].position - page->places()[1].position).norm();
  EXPECT_GE(page->distance()->along_mm, straight);
  EXPECT_LT(page->distance()->along_mm, 2.0 * straight);
  Click(page, "modeSection");
  ASSERT_TRUE(page->section());
  ExpectFluid(&probe, "the surface is measured");
  Screenshot("studio-surface");
}

void WholeSessionTest::Export() {
  auto* page = GoTo<SurfacePage>();
  LoopProbe probe;
  for (const char* name : {"hand.ply", "hand.glb", "hand.png"}) {
    page->ExportTo(dir_ / name);
    ASSERT_TRUE(Until([&] { return !workbench_.jobs().busy(); }));
    EXPECT_GT(fs::file_size(dir_ / name), 1000U) << name;
  }
  ExpectFluid(&probe, "it is exported");
  const auto mesh = ReadMeshPly(dir_ / "hand.ply");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(mesh->faces.size(), workbench_.scan()->surface.mesh.faces.size());
}

void WholeSessionTest::LookAtTheStages() {
  auto* page = GoTo<StagesPage>();
  QSignalSpy compared(page, &StagesPage::Compared);
  LoopProbe probe;
  ASSERT_TRUE(Until([&] { return compared.count() > 0 || error_; }));
  ASSERT_FALSE(error_) << error_->message;
  auto* offset = qobject_cast<QDoubleSpinBox*>(page->options()->Editor("stripe-offset"));
  ASSERT_NE(offset, nullptr);
  offset->setValue(offset->value() + 6.0);
  ASSERT_TRUE(Until([&] { return compared.count() > 1 || error_; }));
  ASSERT_FALSE(error_) << error_->message;
  auto* list = Find<QListWidget>(page, "stages");
  for (int i = 0; i < list->count(); ++i) {
    list->setCurrentRow(i);
    QTest::qWait(20);
  }
  ExpectFluid(&probe, "the stages are looked at");
  EXPECT_FALSE(page->comparison()->changed.empty());
  EXPECT_EQ(page->comparison()->ours.points, workbench_.scan()->surface.points.size());
  Screenshot("studio-stages");
}

void WholeSessionTest::CaptureForACampaign() {
  auto* page = GoTo<CampaignPage>();
  CampaignModel* model = page->model();
  CreateCampaignRequest request{dir_ / "study", "study", {}, {}, {}};
  request.plan.people = 1;
  request.plan.captures = 1;
  LoopProbe probe;
  model->Create(request);
  ASSERT_TRUE(Until([&] { return model->view() != nullptr; }));
  ASSERT_TRUE(Rests());
  model->AddPerson({"p01", "woman", "20-29", "2024-05-31", false}, false);
  ASSERT_TRUE(Until([&] { return !model->view()->people.empty(); }));
  ASSERT_TRUE(Rests());
  for (int captures = 1; captures <= 2; ++captures) {  // one hand, then the other by itself
    if (captures == 1) page->findChild<CampaignPeople*>()->Choose({"p01", 1, CampaignHand::kLeft});
    ASSERT_TRUE(Until([&] { return Find<QPushButton>(page, "next")->isEnabled(); }));
    Click(page, "next");
    ASSERT_TRUE(Until([&] { return model->view()->status.captures == captures || error_; }));
    ASSERT_FALSE(error_) << error_->message;
    ASSERT_TRUE(Rests());
  }
  Screenshot("session-campaign", &probe);
  Click(page, "verify");
  auto* said = Find<QLabel>(page, "said");
  ASSERT_TRUE(Until([&] { return said->text().contains("as they were stored"); })) << Said();
  ASSERT_TRUE(Until([&] { return Find<QPushButton>(page, "look")->isEnabled(); }));
  Click(page, "look");
  ASSERT_TRUE(Until([&] { return workbench_.scan()->name.starts_with("p01") || error_; }));
  ASSERT_FALSE(error_) << error_->message;
  ExpectFluid(&probe, "a campaign is captured and verified");
}

void WholeSessionTest::All() {
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  QTest::qWait(200);
  using Self = WholeSessionTest;
  for (const auto step :
       {&Self::Idle, &Self::OpenTheDevice, &Self::CalibrateIt, &Self::ScanAHand, &Self::MeasureIt,
        &Self::Export, &Self::LookAtTheStages, &Self::CaptureForACampaign}) {
    ASSERT_NO_FATAL_FAILURE((this->*step)());
  }
}

TEST_F(WholeSessionTest, CalibratesScansKeepsMeasuresExportsAndClosesWithoutAWordOnTheConsole) {
  ASSERT_NO_FATAL_FAILURE(All());
  EXPECT_EQ(Said(), "");
  EXPECT_LE(window_->minimumSizeHint().width(), 1280);
  EXPECT_LE(window_->minimumSizeHint().height(), 800);
  window_->close();
  window_.reset();
  EXPECT_EQ(console_.said().join('\n').toStdString(), "");
}

// As the README leads a new user: the virtual device, its calibration, a hand, its surface. What it takes is
// told; two minutes are wished for at full size (DORSUM_SESSION_DEVICE=virtual).
TEST_F(WholeSessionTest, ANewUserComesToTheFirstSurfaceOnTheScanPageAlone) {
  QElapsedTimer clock;
  clock.start();
  const auto tell = [&](const char* what) {
    std::printf("[ figure ] %5.1f s: %s\n", 1e-3 * static_cast<double>(clock.elapsed()), what);
    std::fflush(stdout);
  };
  auto* page = GoTo<ScanPage>();
  page->model()->SetCache(dir_ / "cache");
  page->model()->SetFolder(dir_ / "kept");
  const auto reaches = [&](ScanState state) {
    return Until([&, state] { return page->model()->state() == state || error_; });
  };
  workbench_.device().Open(Which());
  ASSERT_TRUE(reaches(ScanState::kNoCalibration));
  tell("the device is open");
  EXPECT_EQ(Find<QPushButton>(page, "scan")->text(), "&Calibrate this virtual device");
  Click(page, "scan");
  ASSERT_TRUE(reaches(ScanState::kPreview));
  ASSERT_FALSE(error_) << error_->message;
  tell("it is calibrated");
  auto* place = Find<QComboBox>(page, "place");
  place->setCurrentIndex(1);
  emit place->activated(1);
  ASSERT_TRUE(reaches(ScanState::kReady));
  tell("the hand lies well");
  QSignalSpy drawn(Find<TurningSurface>(page, "surface"), &TurningSurface::Drawn);
  Click(page, "scan");
  ASSERT_TRUE(reaches(ScanState::kShown));
  ASSERT_FALSE(error_) << error_->message;
  ASSERT_TRUE(Until([&] { return drawn.count() > 0; }));
  tell("its surface is on the screen");
  std::printf("[ figure ] %.2f s from the last picture to the surface, which took %.2f s to compute\n",
              page->model()->wait_s(), page->model()->taken()->seconds);
}

}  // namespace
}  // namespace dorsum
