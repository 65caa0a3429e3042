// SPDX-License-Identifier: Apache-2.0
// The window is found as it was left, and a settings file that is broken does no harm.
#include <QComboBox>
#include <QFile>
#include <QSplitter>
#include <map>

#include "jobs/campaign_create.h"
#include "studio/campaign_page.h"
#include "studio/shapes_test.h"
#include "studio/surface_page.h"
#include "studio/window_fixture_test.h"

namespace dorsum {
namespace {

class LayoutTest : public WindowTest {
 protected:
  void OpenAgain() {
    if (window_) window_->close();
    window_.reset();
    window_ = std::make_unique<MainWindow>(&workbench_);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  }
  void ShowPlane() {
    auto scan = std::make_shared<Scan>();
    scan->surface.mesh = PlaneMesh(21, 1.0, [](double x, double) { return x; });
    for (int i = 0; i < 3; ++i) {
      scan->surface.points.emplace_back();
      scan->surface.points.back().position = {static_cast<double>(i), 0.0, 0.0};
    }
    workbench_.SetScan(scan);
  }
  static void Choose(QComboBox* box, int value) {
    box->setCurrentIndex(box->findData(value));
    emit box->activated(box->currentIndex());
  }
};

TEST_F(LayoutTest, SizePageSplittersAndChosenColoursAreAsTheyWereLeft) {
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  ShowPlane();
  auto* page = GoTo<SurfacePage>();
  window_->resize(1111, 707);
  QTest::qWait(50);
  auto* split = Find<QSplitter>(page, "surfaceSplit");
  split->setSizes({300, 600});
  const QList<int> sizes = split->sizes();
  Choose(Find<QComboBox>(page, "colours"), static_cast<int>(ColourBy::kOrder));
  Choose(Find<QComboBox>(page, "show"), static_cast<int>(Shown::kBoth));
  OpenAgain();
  EXPECT_EQ(window_->size(), QSize(1111, 707));
  page = window_->findChild<SurfacePage*>();
  EXPECT_TRUE(page->isVisible());
  QTest::qWait(50);
  const QList<int> now = Find<QSplitter>(page, "surfaceSplit")->sizes();
  ASSERT_EQ(now.size(), 2);
  EXPECT_NEAR(now[0], sizes[0], 4);
  EXPECT_EQ(Find<QComboBox>(page, "colours")->currentData().toInt(), static_cast<int>(ColourBy::kOrder));
  EXPECT_EQ(Find<QComboBox>(page, "show")->currentData().toInt(), static_cast<int>(Shown::kBoth));
  // A surface that has no orders takes heights, and the next that has them takes orders again.
  auto mesh = std::make_shared<Scan>();
  mesh->surface.mesh = PlaneMesh(5, 1.0, [](double, double) { return 0.0; });
  workbench_.SetScan(mesh);
  EXPECT_EQ(Find<QComboBox>(page, "colours")->currentData().toInt(), static_cast<int>(ColourBy::kHeight));
  ShowPlane();
  EXPECT_EQ(Find<QComboBox>(page, "colours")->currentData().toInt(), static_cast<int>(ColourBy::kOrder));
}

TEST_F(LayoutTest, EverySplitterOfEveryPageIsAsItWasLeft) {
  ASSERT_TRUE(CreateCampaign({dir_ / "study", "study", {}, {}, {}}, {}).ok());
  ShowPlane();
  GoTo<CampaignPage>()->model()->Open(dir_ / "study");
  ASSERT_TRUE(Until([&] { return GoTo<CampaignPage>()->model()->view() != nullptr; }));
  ASSERT_TRUE(Rests());
  const auto sizes = [&](bool move) {
    std::map<QString, QList<int>> found;
    for (int i = 0; i < window_->pages(); ++i) {
      window_->ShowPage(i);
      QTest::qWait(50);
      for (auto* split : window_->page(i)->findChildren<QSplitter*>()) {
        EXPECT_FALSE(split->objectName().isEmpty()) << "a splitter of page " << i << " has no name";
        QList<int> now = split->sizes();
        if (move) {
          const int by = now.front() / 4;
          now.front() -= by;
          now.back() += by;
          split->setSizes(now);
        }
        found[split->objectName()] = split->sizes();
      }
    }
    return found;
  };
  const auto usual = sizes(false), left = sizes(true);
  EXPECT_GE(left.size(), 5U);
  EXPECT_NE(usual, left);
  OpenAgain();
  window_->resize(1280, 800);
  GoTo<CampaignPage>();
  ASSERT_TRUE(Until([&] { return GoTo<CampaignPage>()->model()->view() != nullptr; }));
  for (const auto& [name, now] : sizes(false)) {
    ASSERT_EQ(now.size(), left.at(name).size()) << name.toStdString();
    for (int i = 0; i < now.size(); ++i) EXPECT_NEAR(now[i], left.at(name)[i], 4) << name.toStdString();
  }
}

TEST_F(LayoutTest, BrokenSettingsAreAsNone) {
  window_->close();
  window_.reset();
  const QString name = [] {
    QSettings settings;
    settings.setValue("a", 1);
    settings.sync();
    return settings.fileName();
  }();
  const QByteArray noise("\x00\xff[[[\n=\n%%%\n@ByteArray(", 20);
  const QByteArray wrong(
      "[window]\ngeometry=@ByteArray(\\x1\\xd9)\npage=nine\nsurfaceSplit=@ByteArray(junk)\ndeviceSplit=7\n"
      "[surface]\ncolours=99\nshow=-4\nlanguage=xx\n[device]\nrecent=@Variant(\\0\\0)\n[studio]\nlanguage="
      "12\n");
  for (const QByteArray& content : {noise, wrong, QByteArray("[window]\npage=-3\n"), QByteArray()}) {
    QFile file(name);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    file.write(content);
    file.close();
    QSettings().sync();
    OpenAgain();
    ShowPlane();
    auto* page = GoTo<SurfacePage>();
    EXPECT_TRUE(page->isVisible());
    EXPECT_GE(Find<QComboBox>(page, "colours")->currentIndex(), 0);
    EXPECT_GE(Find<QComboBox>(page, "show")->currentIndex(), 0);
    EXPECT_GE(window_->width(), 400);
    window_->close();
    window_.reset();
  }
}

}  // namespace
}  // namespace dorsum
