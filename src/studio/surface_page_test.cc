// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_page.h"

#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/temp_folder_test.h"
#include "jobs/scan_fixture_test.h"
#include "studio/image_view.h"
#include "studio/main_window.h"
#include "studio/patience_test.h"
#include "studio/shapes_test.h"
#include "studio/surface_view.h"
#include "surface/ply.h"

namespace dorsum {
namespace {

// A hill under stripes of two lasers, as they would be seen from straight above.
std::shared_ptr<Scan> Hill() {
  auto scan = std::make_shared<Scan>();
  const auto height = [](double x, double y) { return 20.0 * std::exp(-(x * x + y * y) / 900.0); };
  scan->name = "hill";
  scan->surface.mesh = PlaneMesh(121, 0.5, height);
  for (int laser = 0; laser < 2; ++laser) {
    for (int order = -5; order <= 5; ++order) {
      for (int row = 0; row < 200; ++row) {
        SurfacePoint p;
        const double x = 5.0 * order + 2.5 * laser, y = 0.25 * (100 - row);
        p.position = {x, y, height(x, y)};
        p.laser = static_cast<std::uint8_t>(laser);
        p.order = static_cast<std::int16_t>(order);
        p.u = static_cast<float>(200.0 + 6.0 * x);
        p.v = static_cast<float>(20 + row);
        p.sigma = 0.03F + 0.001F * static_cast<float>(std::abs(order));
        scan->surface.points.push_back(p);
      }
    }
  }
  scan->capture.hand = cv::Mat(240, 400, CV_8UC3, cv::Scalar(60, 70, 90));
  scan->capture.stripes = {cv::Mat(240, 400, CV_8UC3, cv::Scalar(10, 30, 10)),
                           cv::Mat(240, 400, CV_8UC3, cv::Scalar(10, 40, 10))};
  return scan;
}

class SurfacePageTest : public ::testing::Test {
 protected:
  void SetUp() override {
    window_.resize(1280, 800);
    for (int i = 0; i < window_.pages(); ++i) {
      if (auto* found = qobject_cast<SurfacePage*>(window_.page(i))) {
        page_ = found;
        window_.ShowPage(i);
      }
    }
    ASSERT_NE(page_, nullptr);
    QObject::connect(&workbench_, &Workbench::Failed, [this](const Error& e) { errors_.push_back(e); });
    window_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_));
  }
  template <class T>
  T* Find(const char* name) {
    return page_->findChild<T*>(name);
  }
  void Wait() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !page_->busy() && !workbench_.jobs().busy(); }, kPatience_ms));
  }
  void Show(std::shared_ptr<const Scan> scan) {
    workbench_.SetScan(std::move(scan));
    Wait();
  }
  void Choose(const char* box, int value) {
    auto* combo = Find<QComboBox>(box);
    combo->setCurrentIndex(combo->findData(value));
    Wait();
  }
  QString Readout() { return Find<QLabel>("readout")->text(); }
  // For eyes: with DORSUM_SCREENSHOTS=FOLDER the window is written there, light and dark.
  void Screenshot(const char* name) {
    const QString folder = qEnvironmentVariable("DORSUM_SCREENSHOTS");
    if (folder.isEmpty()) return;
    const QPalette light = QApplication::palette();
    for (const bool dark : {false, true}) {
      if (dark) QApplication::setPalette(QPalette(QColor(56, 58, 62), QColor(40, 42, 46)));
      QTest::qWait(300);
      EXPECT_TRUE(window_.grab().save(folder + "/" + name + (dark ? "_dark.png" : ".png")));
    }
    QApplication::setPalette(light);
  }

  Workbench workbench_;
  MainWindow window_{&workbench_};
  SurfacePage* page_ = nullptr;
  std::vector<Error> errors_;
};

TEST_F(SurfacePageTest, AClickOnTheSurfaceSaysWhereAndMarksTheStripeInTheImage) {
  Show(Hill());
  Choose("images", 0);
  auto* view = Find<SurfaceView>("surfaceView");
  QTest::mouseClick(view, Qt::LeftButton, {}, view->rect().center());
  ASSERT_EQ(page_->places().size(), 1U);
  ASSERT_TRUE(page_->places()[0].face && page_->places()[0].point);
  EXPECT_TRUE(Readout().contains("mm; stripe of laser")) << Readout().toStdString();
  const std::uint8_t laser = workbench_.scan()->surface.points[*page_->places()[0].point].laser;
  EXPECT_EQ(Find<QComboBox>("images")->currentData().toInt(), laser);
  Screenshot("surface_pick");
}

TEST_F(SurfacePageTest, AClickOnAStripeOfTheImagePicksItOnTheSurface) {
  Show(Hill());
  Choose("images", 1);
  auto* image = Find<ImageView>("imageView");
  EXPECT_EQ(image->stripes(), 11U);
  QTest::mouseClick(image, Qt::LeftButton, {}, image->ToWidget({200.0 + 6.0 * 12.5, 120.0}).toPoint());
  ASSERT_EQ(page_->places().size(), 1U);
  const SurfacePoint& p = workbench_.scan()->surface.points[*page_->places()[0].point];
  EXPECT_EQ(p.laser, 1);
  EXPECT_EQ(p.order, 2);
  EXPECT_NEAR(p.v, 120.0, 2.0);
}

TEST_F(SurfacePageTest, TwoPlacesGiveADistanceAndASection) {
  Show(Hill());
  const auto above = [&](double x, double y) {
    return *Pick(*workbench_.scan(), {{x, y, 300.0}, {0, 0, -1}}, Shown::kMesh, 0.0);
  };
  page_->SetMode(SurfacePage::Mode::kDistance);
  page_->Take(above(-25.0, 0.3));
  page_->Take(above(25.0, 0.3));
  Wait();
  ASSERT_TRUE(page_->distance());
  EXPECT_NEAR(page_->distance()->straight_mm, 50.0, 1e-6);
  EXPECT_GT(page_->distance()->along_mm, 51.0);
  EXPECT_TRUE(Readout().contains("Straight 50.00 mm, along the surface")) << Readout().toStdString();
  Screenshot("surface_distance");
  QTest::mouseClick(Find<QPushButton>("modeSection"), Qt::LeftButton);
  ASSERT_TRUE(page_->section());
  EXPECT_FALSE(page_->distance());
  ASSERT_EQ(page_->section()->curves.size(), 1U);
  double top = 0.0;
  for (const Eigen::Vector2d& p : page_->section()->curves[0]) top = std::max(top, p.y());
  EXPECT_NEAR(top, 20.0, 0.1);
  Screenshot("surface_section");
  QTest::mouseClick(Find<QPushButton>("clear"), Qt::LeftButton);
  EXPECT_TRUE(page_->places().empty());
  EXPECT_FALSE(page_->section());
}

TEST_F(SurfacePageTest, ComparedWithAnotherFileTheDifferenceIsSaid) {
  const TempFolder folder;
  TriangleMesh lower = Hill()->surface.mesh;
  for (Eigen::Vector3d& v : lower.vertices) v.z() -= 0.4;
  ASSERT_TRUE(WriteMeshPly(folder / "lower.ply", lower).ok());
  Show(Hill());
  page_->CompareWith(folder / "lower.ply");
  Wait();
  Wait();
  EXPECT_TRUE(Readout().contains("Against lower.ply: mean 0.400 mm, RMS 0.400 mm"))
      << Readout().toStdString();
  page_->CompareWith(folder / "missing.ply");
  Wait();
  ASSERT_EQ(errors_.size(), 1U);
  EXPECT_EQ(errors_[0].code, ErrorCode::kBadInput);
}

TEST_F(SurfacePageTest, ExportsWhatItsEndingSaysAndRefusesOthersInASentence) {
  const TempFolder folder;
  page_->ExportTo(folder / "nothing.ply");
  ASSERT_EQ(errors_.size(), 1U);
  Show(Hill());
  for (const char* name : {"a.ply", "a.obj", "a.stl", "a.glb", "a.png"}) {
    page_->ExportTo(folder / name);
    Wait();
    EXPECT_GT(std::filesystem::file_size(folder / name), 1000U) << name;
  }
  EXPECT_EQ(ReadMeshPly(folder / "a.ply")->faces.size(), 28800U);
  const QImage picture(QString::fromStdString((folder / "a.png").string()));
  EXPECT_NE(picture.pixelColor(picture.rect().center()), picture.pixelColor(1, 1));
  ASSERT_EQ(errors_.size(), 1U);
  page_->ExportTo(folder / "a.doc");
  Wait();
  page_->ExportTo(folder / "missing" / "a.ply");
  Wait();
  EXPECT_EQ(errors_.size(), 3U);
}

TEST_F(SurfacePageTest, AMeshAloneAndPointsAloneAreLookedAtToo) {
  auto mesh = std::make_shared<Scan>(), points = std::make_shared<Scan>();
  mesh->surface.mesh = Hill()->surface.mesh;
  points->surface.points = Hill()->surface.points;
  Show(mesh);
  EXPECT_FALSE(Find<ImageView>("imageView")->isVisible());
  auto* view = Find<SurfaceView>("surfaceView");
  QTest::keyClick(view, Qt::Key_Return);
  ASSERT_EQ(page_->places().size(), 1U);
  EXPECT_FALSE(page_->places()[0].image);
  Screenshot("surface_mesh_alone");
  Show(points);
  EXPECT_TRUE(page_->places().empty());
  Choose("colours", static_cast<int>(ColourBy::kOrder));
  EXPECT_EQ(Find<ImageView>("imageView")->stripes(), 22U);
  page_->SetMode(SurfacePage::Mode::kSection);
  for (const std::uint32_t i : {100U, 1900U}) {
    Picked picked;
    picked.point = i;
    picked.position = points->surface.points[i].position;
    page_->Take(picked);
  }
  ASSERT_TRUE(page_->section());
  EXPECT_GE(page_->section()->dots.size(), 20U);
  Screenshot("surface_points_alone");
  const TempFolder folder;
  page_->ExportTo(folder / "p.ply");
  Wait();
  EXPECT_EQ(ReadPointsPly(folder / "p.ply")->size(), points->surface.points.size());
  page_->ExportTo(folder / "p.stl");
  Wait();
  EXPECT_EQ(errors_.size(), 1U);
  Show(nullptr);
  EXPECT_TRUE(Find<QLabel>("emptyHint")->isVisible());
  Screenshot("surface_empty");
}

TEST_F(SurfacePageTest, KeysTurnMoveZoomAndGoHome) {
  Show(Hill());
  auto* view = Find<SurfaceView>("surfaceView");
  const double distance = view->camera().distance();
  QTest::keyClick(view, Qt::Key_Left);
  QTest::keyClick(view, Qt::Key_Plus);
  QTest::keyClick(view, Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_NE(view->camera().yaw_deg(), 0.0);
  EXPECT_LT(view->camera().distance(), distance);
  EXPECT_TRUE(page_->places().empty());
  QTest::keyClick(view, Qt::Key_Home);
  EXPECT_EQ(view->camera().yaw_deg(), 0.0);
  EXPECT_EQ(view->camera().distance(), distance);
}

// The accepted ratio is 3. Least times of several frames: what else the machine does only adds to them.
TEST_F(SurfacePageTest, AMillionPointsTurnAsFluidlyAsTenThousand) {
  auto* view = Find<SurfaceView>("surfaceView");
  std::vector<double> least_ms;
  for (const int count : {10'000, 1'000'000}) {
    auto scan = std::make_shared<Scan>();
    for (int i = 0; i < count; ++i) {
      SurfacePoint p;
      const double x = 100.0 * i / count - 50.0, y = std::fmod(0.6180339887 * i, 1.0) * 100.0 - 50.0;
      p.position = {x, y, 10.0 * std::cos(0.06 * x) * std::cos(0.06 * y)};
      scan->surface.points.push_back(p);
    }
    Show(scan);
    QTest::qWait(300);
    EXPECT_EQ(view->points_drawn(), static_cast<std::size_t>(count));
    double least = 1e9;
    for (int frame = 0; frame < 12; ++frame) {
      QElapsedTimer timer;
      timer.start();
      QSignalSpy shown(view, &SurfaceView::Drawn);
      view->Turn(3.0, 0.5);
      while (shown.isEmpty()) QCoreApplication::processEvents();
      least = std::min(least, 1e-6 * static_cast<double>(timer.nsecsElapsed()));
    }
    least_ms.push_back(least);
    if (count > 10'000) RecordProperty("points_while_turning", std::to_string(view->points_drawn()));
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return view->points_drawn() == static_cast<std::size_t>(count); }, 5000));
  }
  RecordProperty("ten_thousand_ms", std::to_string(least_ms[0]));
  RecordProperty("million_ms", std::to_string(least_ms[1]));
  EXPECT_LE(least_ms[1], 3.0 * least_ms[0]);
  Screenshot("surface_million");
}

TEST_F(SurfacePageTest, ACaptureOpensWithItsSurfaceItsImagesAndItsStripes) {
  workbench_.LoadCalibration(ScanFixture::CalibrationJson());
  Wait();
  workbench_.OpenPath(ScanFixture::CaptureDir(ScanFixture::kHand));
  Wait();
  Wait();
  ASSERT_TRUE(workbench_.scan());
  EXPECT_EQ(Find<QComboBox>("images")->count(), 4);
  // A stripe point, clicked in the image, lies on the surface where the camera sees it.
  const SurfacePoints& points = workbench_.scan()->surface.points;
  const SurfacePoint& p = points[points.size() / 2];
  auto* image = Find<ImageView>("imageView");
  QTest::mouseClick(image, Qt::LeftButton, {}, image->ToWidget({p.u, p.v}).toPoint());
  ASSERT_EQ(page_->places().size(), 1U);
  const Picked& picked = page_->places()[0];
  ASSERT_TRUE(picked.point && picked.image);
  const Camera& camera = workbench_.scan()->calibration->calibration.device.camera;
  EXPECT_LT((Project(camera, points[*picked.point].position) - *picked.image).norm(), 1.0);
  const Ray ray = CastRay(camera, *picked.image);
  const std::optional<Picked> back = Pick(*workbench_.scan(), ray, Shown::kBoth, 1e-3);
  ASSERT_TRUE(back && back->image);
  EXPECT_LT((*back->image - *picked.image).norm(), 2.0);
  Screenshot("surface_hand");
  Choose("show", static_cast<int>(Shown::kPoints));
  Choose("colours", static_cast<int>(ColourBy::kOrder));
  Choose("images", 1);
  Screenshot("surface_hand_orders");
  Choose("show", static_cast<int>(Shown::kBoth));
  Choose("colours", static_cast<int>(ColourBy::kUncertainty));
  Screenshot("surface_hand_sigma");
  EXPECT_TRUE(errors_.empty());
}

}  // namespace
}  // namespace dorsum
