// SPDX-License-Identifier: Apache-2.0
// What goes wrong in ordinary use is a sentence in the window, and the next step works.
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QUrl>
#include <atomic>
#include <csignal>
#include <functional>
#include <limits>
#include <vector>

#include <sys/resource.h>

#include "device/device_error.h"
#include "jobs/campaign_add.h"
#include "jobs/campaign_fixture_test.h"
#include "jobs/campaign_verify.h"
#include "studio/calibrate_page.h"
#include "studio/campaign_page.h"
#include "studio/campaign_people.h"
#include "studio/device_page.h"
#include "studio/fitted_picture.h"
#include "studio/picture_view.h"
#include "studio/scan_page.h"
#include "studio/shapes_test.h"
#include "studio/stages_page.h"
#include "studio/surface_page.h"
#include "studio/window_fixture_test.h"
#include "surface/ply.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// No file of this process may become larger, as on a disk that is full.
class FullDisk {
 public:
  FullDisk() {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{1000, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TriangleMesh Plane(double height) {
  return PlaneMesh(21, 1.0, [=](double, double) { return height; });
}

class BadInputTest : public WindowTest {
 protected:
  void Drop(const QUrl& url) {
    QMimeData data;
    data.setUrls({url});
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &drop);
    ASSERT_TRUE(Rests());
  }
  void Drop(const fs::path& path) { Drop(QUrl::fromLocalFile(QString::fromStdString(path.string()))); }
  void Write(const std::string& name, const std::string& content) {
    ASSERT_TRUE(WriteFile(dir_ / name, content).ok());
  }
  // A campaign with one person of whom all is missing, chosen.
  void OpenCampaign() {
    ASSERT_TRUE(CreateCampaign({dir_ / "study", "study", {}, {}, {}}, {}).ok());
    ASSERT_TRUE(
        AddPerson({dir_ / "study", {"p01", "woman", "20-29", "2024-05-31", false}, false, ""}, {}).ok());
    auto* page = GoTo<CampaignPage>();
    page->model()->Open(dir_ / "study");
    ASSERT_TRUE(Until([&] { return page->model()->view() != nullptr; }));
    ASSERT_TRUE(Rests());
    page->findChild<CampaignPeople*>()->Choose({"p01", 1, CampaignHand::kLeft});
  }
  // A good surface, which opens after everything that did not.
  void ExpectAWayOn() {
    const fs::path good = dir_ / "good.ply";
    ASSERT_TRUE(WriteMeshPly(good, Plane(1.0)).ok());
    Drop(good);
    ASSERT_TRUE(workbench_.scan());
    EXPECT_EQ(workbench_.scan()->name, "good.ply");
    workbench_.SetScan(nullptr);
  }
  void ExpectSaid(const std::string& words, const std::string& what) {
    EXPECT_TRUE(Said().find(words) != std::string::npos) << what << ": " << Said();
    EXPECT_TRUE(Said().ends_with('.')) << what << ": " << Said();
    window_->findChild<Banner*>("banner")->hide();
  }
};

TEST_F(BadInputTest, JunkThatIsDroppedIsSaidAndTheNextFileOpens) {
  Write("text.txt", "hello");
  Write("text.ply", "hello");
  Write("empty.ply", "");
  Write("ascii.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n");
  Write(
      "huge.ply",
      "ply\nformat binary_little_endian 1.0\nelement vertex 4294967295\nproperty float x\nproperty float y\n"
      "property float z\nelement face 4294967295\nproperty list uchar int vertex_indices\nend_header\n");
  Write("large.ply",
        "ply\nformat binary_little_endian 1.0\nelement vertex 199999999\nproperty float x\nproperty float y\n"
        "property float z\nelement face 199999999\nproperty list uchar int vertex_indices\nend_header\n");
  ASSERT_TRUE(WriteMeshPly(dir_ / "whole.ply", Plane(1.0)).ok());
  const std::string whole = ReadFile(dir_ / "whole.ply").value();
  Write("cut.ply", whole.substr(0, whole.size() / 2));
  TriangleMesh broken = Plane(1.0);
  broken.vertices[7].z() = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(WriteMeshPly(dir_ / "nan.ply", broken).ok());
  Write("text.json", "hello");
  Write("other.json", "{\"a\": [1, 2, 3]}");
  fs::create_directories(dir_ / "folder");
  fs::create_directories(dir_ / "folder.ply");
  Write("folder/note.txt", "no capture");
  struct Case {
    const char* name;
    const char* words;
  };
  for (const Case& one :
       {Case{"text.txt", "neither a capture folder nor a PLY"}, Case{"text.ply", "not a PLY file"},
        Case{"empty.ply", "not a PLY file"}, Case{"ascii.ply", "not binary_little_endian"},
        Case{"huge.ply", "header is damaged"}, Case{"large.ply", "cut off"}, Case{"cut.ply", "cut off"},
        Case{"nan.ply", "not a number"}, Case{"text.json", "text.json"}, Case{"other.json", "other.json"},
        Case{"missing", "missing"}, Case{"missing.ply", "missing.ply"}, Case{"missing.json", "missing.json"},
        Case{"folder", "needs the calibration"}, Case{"folder.ply", "calibration"}}) {
    Drop(dir_ / one.name);
    ExpectSaid(one.words, one.name);
    EXPECT_EQ(workbench_.scan(), nullptr) << one.name;
    ExpectAWayOn();
  }
  EXPECT_EQ(console_.said().join('\n').toStdString(), "");
}

TEST_F(BadInputTest, WhatIsNoFileIsSaid) {
  Drop(QUrl("https://example.org/a.ply"));
  ExpectSaid("no file of this machine", "address");
}

TEST_F(BadInputTest, ACaptureWithoutPicturesOrOfAnotherDeviceIsSaid) {
  Calibrate();
  fs::create_directories(dir_ / "empty");
  Drop(dir_ / "empty");
  ExpectSaid("empty", "empty folder");
  const fs::path hand = ScanFixture::CaptureDir(ScanFixture::kHand);
  ScanFixture::CopyFolder(hand, dir_ / "junk");
  for (const auto& file : fs::directory_iterator(dir_ / "junk")) {
    ASSERT_TRUE(WriteFile(file.path(), "no picture").ok());
  }
  Drop(dir_ / "junk");
  ExpectSaid("junk", "pictures that are none");
  ScanFixture::CopyFolder(hand, dir_ / "other");
  fs::copy_file("docs/images/studio-scan.png", dir_ / "other" / "stripesHand1.png",
                fs::copy_options::overwrite_existing);
  Drop(dir_ / "other");
  ExpectSaid("stripesHand1", "a picture of another size");
  EXPECT_EQ(workbench_.scan(), nullptr);
  Drop(hand);
  EXPECT_NE(workbench_.scan(), nullptr);
}

TEST_F(BadInputTest, ACalibrationOfAnotherDeviceIsSaidOnTheScanPage) {
  Calibrate();
  std::string text = ReadFile(DeviceFile()).value();
  auto* page = GoTo<ScanPage>();
  for (const auto& [from, to] : {std::pair<std::string, std::string>("[560, 420]", "[640, 480]"),
                                 {"[[laser]]\nposition_mm = [11.15, 0.0, 395.0]\n", ""}}) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    Write("other.toml", other);
    QSignalSpy opened(&workbench_.device(), &DeviceSession::Opened);
    workbench_.device().Open((dir_ / "other.toml").string());
    ASSERT_TRUE(opened.wait(kPatience_ms));
    EXPECT_EQ(page->model()->state(), ScanState::kNoCalibration) << from;
    EXPECT_EQ(Find<QLabel>(page, "sentence")->text().toStdString(), "The calibration is of another device");
    EXPECT_EQ(Find<QPushButton>(page, "scan")->text().toStdString(), "&Calibrate this virtual device");
  }
}

TEST_F(BadInputTest, ADeviceUnpluggedOnEachPageIsSaidAndOpensAgain) {
  Calibrate();
  struct Case {
    const char* page;
    std::function<void()> go, work;
  };
  ASSERT_NO_FATAL_FAILURE(OpenCampaign());
  auto* calibrate = GoTo<CalibratePage>()->model();
  calibrate->SetFolder(dir_ / "series");
  calibrate->GoOnByItself(true);
  const auto nothing = [] {};
  for (const Case& one :
       std::vector<Case>{{"Scan", [&] { GoTo<ScanPage>(); }, nothing},
                         {"Calibrate", [&] { GoTo<CalibratePage>(); }, [&] { calibrate->Take(); }},
                         {"Stages, then Scan", [&] { GoTo<StagesPage>(); }, [&] { GoTo<ScanPage>(); }},
                         {"Campaign", [&] { GoTo<CampaignPage>(); }, nothing},
                         {"Device", [&] { GoTo<DevicePage>(); }, nothing},
                         {"Device, examined", [&] { GoTo<DevicePage>(); },
                          [&] { GoTo<DevicePage>()->model()->Examine(""); }}}) {
    GoTo<SurfacePage>();
    QSignalSpy opened(&workbench_.device(), &DeviceSession::Opened);
    workbench_.device().Open(DeviceFile());
    ASSERT_TRUE(opened.wait(kPatience_ms));
    window_->findChild<Banner*>("banner")->hide();
    WithHooks([](DeviceHooks& hooks) {
      hooks.frame = [](int, const Result<Frame>&) {
        return Result<Frame>(DeviceError("the camera is gone; plug it in"));
      };
      hooks.set = [](int, const ChannelSet&) {
        return Status(DeviceError("the controller is gone; plug it in"));
      };
    });
    one.go();
    one.work();
    const bool examined = std::string(one.page) == "Device, examined";
    ASSERT_TRUE(Until([&] { return !Said().empty(); })) << one.page;
    ASSERT_TRUE(Rests());
    ExpectSaid("is gone; plug it in", one.page);
    EXPECT_TRUE(!examined || GoTo<DevicePage>()->model()->report()) << one.page;
    workbench_.device().Open(DeviceFile());
    ASSERT_TRUE(opened.wait(kPatience_ms)) << one.page;
    auto* picture = Find<FittedPicture>(GoTo<DevicePage>(), "livePicture");
    EXPECT_TRUE(Until([&] { return !picture->image().isNull(); })) << one.page;
  }
}

TEST_F(BadInputTest, ADeviceUnpluggedInTheMidstOfACampaignsCaptureIsSaidAndTheNextOneIsStored) {
  Calibrate();
  ASSERT_NO_FATAL_FAILURE(OpenCampaign());
  auto* page = GoTo<CampaignPage>();
  QSignalSpy opened(&workbench_.device(), &DeviceSession::Opened);
  workbench_.device().Open(DeviceFile());
  ASSERT_TRUE(opened.wait(kPatience_ms));
  const ChannelSet leds = LedChannels(workbench_.device().facts()->description);
  auto gone = std::make_shared<std::atomic<bool>>(false);
  WithHooks([leds, gone](DeviceHooks& hooks) {
    hooks.set = [leds, gone](int, const ChannelSet& on) {
      if ((on & ~leds).any()) *gone = true;  // as soon as the first laser is on
      return *gone ? Status(DeviceError("the controller is gone; plug it in")) : Status();
    };
    hooks.frame = [gone](int, Result<Frame> frame) {
      return *gone ? Result<Frame>(DeviceError("the camera is gone; plug it in")) : std::move(frame);
    };
  });
  ASSERT_TRUE(Until([&] { return Find<QPushButton>(page, "next")->isEnabled(); }));
  Click(page, "next");
  ASSERT_TRUE(Until([&] { return !Said().empty(); }));
  ASSERT_TRUE(Rests());
  EXPECT_TRUE(*gone);
  ExpectSaid("is gone; plug it in", "a campaign's capture");
  EXPECT_EQ(page->model()->view()->status.captures, 0);
  EXPECT_EQ(VerifyCampaign(page->model()->dir(), {})->findings.size(), 0U);
  workbench_.device().Open(DeviceFile());
  ASSERT_TRUE(opened.wait(kPatience_ms));
  ASSERT_TRUE(Until([&] { return Find<QPushButton>(page, "next")->isEnabled(); }));
  Click(page, "next");
  EXPECT_TRUE(Until([&] { return page->model()->view()->status.captures == 1; })) << Said();
  EXPECT_EQ(Said(), "");
}

TEST_F(BadInputTest, StagesAndLooksOfWhatHasNoCalibrationAreSaidAndTheNextOneIsShown) {
  auto* page = GoTo<StagesPage>();
  const auto words = [&] { return Find<PictureView>(page, "ours")->words().toStdString(); };
  EXPECT_NE(words().find("Scan a hand"), std::string::npos) << words();
  auto mesh = std::make_shared<Scan>();
  mesh->surface.mesh = Plane(1.0);
  workbench_.SetScan(mesh);
  EXPECT_NE(words().find("Only a surface is open"), std::string::npos) << words();
  ASSERT_NO_FATAL_FAILURE(OpenCampaign());
  auto* campaign = GoTo<CampaignPage>();
  campaign->model()->Import({"p01", 1, CampaignHand::kLeft, 1}, ScanFixture::CaptureDir(ScanFixture::kHand));
  ASSERT_TRUE(Until([&] { return campaign->model()->view()->status.captures == 1; })) << Said();
  ASSERT_TRUE(Rests());
  campaign->findChild<CampaignPeople*>()->Choose({"p01", 1, CampaignHand::kLeft});
  ASSERT_TRUE(Until([&] { return Find<QPushButton>(campaign, "look")->isEnabled(); }));
  Click(campaign, "look");
  ASSERT_TRUE(Until([&] { return !Said().empty(); }));
  ExpectSaid("no calibration", "a capture of a campaign");
  ASSERT_TRUE(Rests());
  GoTo<StagesPage>();
  QSignalSpy compared(page, &StagesPage::Compared);
  Calibrate();
  Drop(ScanFixture::CaptureDir(ScanFixture::kHand));
  EXPECT_TRUE(Until([&] { return compared.count() > 0; })) << words();
}

TEST_F(BadInputTest, ABrokenCampaignThatIsDroppedLeavesTheOneThatIsOpen) {
  ASSERT_NO_FATAL_FAILURE(OpenCampaign());
  auto* page = GoTo<CampaignPage>();
  for (const char* text : {"hello", "{}", "", "{\"format\": 99}"}) {
    fs::create_directories(dir_ / "broken");
    Write("broken/campaign.json", text);
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QString::fromStdString((dir_ / "broken").string()))});
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(page, &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(page, &drop);
    ASSERT_TRUE(Rests());
    ExpectSaid("campaign.json", text);
    EXPECT_EQ(page->model()->dir(), dir_ / "study");
    EXPECT_EQ(page->model()->view()->people.size(), 1U);
  }
}

TEST_F(BadInputTest, AFullDiskLeavesACampaignWhole) {
  ASSERT_NO_FATAL_FAILURE(OpenCampaign());
  auto* page = GoTo<CampaignPage>();
  WriteNoiseCapture(dir_ / "source", 1);
  const auto import = [&] {
    page->model()->Import({"p01", 1, CampaignHand::kLeft, 1}, dir_ / "source");
    ASSERT_TRUE(Rests());
  };
  {
    const FullDisk full;
    import();
  }
  ExpectSaid("annot write", "a campaign's capture");
  EXPECT_EQ(page->model()->view()->status.captures, 0);
  EXPECT_EQ(VerifyCampaign(dir_ / "study", {})->findings.size(), 0U);
  import();
  ASSERT_TRUE(Until([&] { return page->model()->view()->status.captures == 1; })) << Said();
  ASSERT_TRUE(Rests());
  ExportRequest request;
  request.out_dir = dir_ / "others";
  {
    const FullDisk full;
    page->model()->Export(request);
    ASSERT_TRUE(Rests());
  }
  ExpectSaid("annot write", "an export");
  EXPECT_FALSE(fs::exists(dir_ / "others"));
  page->model()->Export(request);
  ASSERT_TRUE(Rests());
  EXPECT_TRUE(fs::exists(dir_ / "others" / "SHA256SUMS"));
}

TEST_F(BadInputTest, AFullDiskAtExportIsSaidAndLeavesNoHalfAFile) {
  auto scan = std::make_shared<Scan>();
  scan->surface.mesh = Plane(1.0);
  workbench_.SetScan(scan);
  auto* page = GoTo<SurfacePage>();
  ASSERT_TRUE(Until([&] { return !page->busy(); }));
  fs::create_directories(dir_ / "out");
  for (const char* name : {"a.ply", "a.obj", "a.stl", "a.glb", "a.png"}) {
    {
      const FullDisk full;
      page->ExportTo(dir_ / "out" / name);
      ASSERT_TRUE(Rests());
    }
    ExpectSaid("annot write", name);
    EXPECT_TRUE(fs::is_empty(dir_ / "out")) << name;
  }
  page->ExportTo(dir_ / "out" / "a.glb");
  ASSERT_TRUE(Rests());
  EXPECT_GT(fs::file_size(dir_ / "out" / "a.glb"), 1000U);
  EXPECT_EQ(Said(), "");
}

TEST_F(BadInputTest, AFullDiskWhenACalibrationIsWrittenLeavesTheOneBefore) {
  auto* model = GoTo<CalibratePage>()->model();
  Write("calibration.json", "before");
  model->SetFolder(ScanFixture::CalibrationDir());
  model->SetFile(dir_ / "calibration.json");
  {
    const FullDisk full;
    model->Calibrate();
    ASSERT_TRUE(Rests());
  }
  ExpectSaid("annot write", "calibration");
  EXPECT_EQ(ReadFile(dir_ / "calibration.json").value(), "before");
  EXPECT_FALSE(workbench_.calibration());
  EXPECT_TRUE(Find<QPushButton>(GoTo<CalibratePage>(), "calibrate")->isEnabled());
}

TEST_F(BadInputTest, AFullDiskAtKeepLosesNoScan) {
  Calibrate();
  auto* page = GoTo<ScanPage>();
  ScanModel* model = page->model();
  Prepare(model);
  OpenDeviceOf(model);
  model->Place("hand:woman:right:anna");
  ASSERT_TRUE(Reaches(*model, ScanState::kReady));
  Click(page, "scan");
  ASSERT_TRUE(Reaches(*model, ScanState::kShown)) << Said();
  {
    const FullDisk full;
    Click(page, "scan");
    ASSERT_TRUE(Until([&] { return !Said().empty(); }));
  }
  ExpectSaid("annot write", "keep");
  EXPECT_EQ(model->state(), ScanState::kShown);
  EXPECT_FALSE(fs::exists(dir_ / "kept" / model->taken()->name));
  Click(page, "scan");
  EXPECT_TRUE(Reaches(*model, ScanState::kKept)) << Said();
}

}  // namespace
}  // namespace dorsum
