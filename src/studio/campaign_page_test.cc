// SPDX-License-Identifier: Apache-2.0
#include "studio/campaign_page.h"

#include <QCheckBox>
#include <QDragEnterEvent>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QTableView>
#include <QTimer>
#include <QUrl>

#include "device/device_error.h"
#include "jobs/campaign_disk.h"
#include "jobs/campaign_fixture_test.h"
#include "studio/campaign_dialogs.h"
#include "studio/campaign_people.h"
#include "studio/main_window.h"
#include "studio/scan_fixture_studio_test.h"

namespace dorsum {
namespace {

class CampaignPageTest : public ScanTest {
 protected:
  CampaignPageTest() {
    QSettings().remove("campaign");
    page_ = std::make_unique<CampaignPage>(&workbench_, nullptr);
    page_->resize(1180, 740);
    page_->show();
    page_->Enter();
  }
  template <class T>
  T* Find(const char* name) {
    T* found = page_->findChild<T*>(name);
    if (found == nullptr) throw std::runtime_error(std::string("no widget ") + name);
    return found;
  }
  QString Said() { return Find<QLabel>("said")->text(); }
  void Click(const char* name) { QTest::mouseClick(Find<QPushButton>(name), Qt::LeftButton); }
  bool Idle() {
    return QTest::qWaitFor(
        [&] {
          QCoreApplication::processEvents();
          return !workbench_.jobs().busy() && !workbench_.device().busy();
        },
        kPatience_ms);
  }
  void Create(int captures = 1) {
    CreateCampaignRequest request{dir_ / "study", "study", {}, {}, {}};
    request.plan.captures = captures;
    request.plan.people = 2;
    page_->model()->Create(request);
    ASSERT_TRUE(QTest::qWaitFor([&] { return page_->model()->view() != nullptr && Idle(); }, kPatience_ms));
  }
  void Person(const std::string& id) {
    page_->model()->AddPerson({id, "woman", "20-29", "2024-05-31", false}, false);
    ASSERT_TRUE(Idle());
    page_->findChild<CampaignPeople*>()->Choose({id, 1, CampaignHand::kLeft});
  }
  void Import(const std::string& id, int seed, CampaignHand hand = CampaignHand::kLeft) {
    WriteNoiseCapture(dir_ / ("source" + std::to_string(seed)), seed);
    page_->model()->Import({id, 1, hand, 1}, dir_ / ("source" + std::to_string(seed)));
    ASSERT_TRUE(Idle());
  }
  // Answers the box that is about to ask.
  void Answer(bool remove, QString* asked) {
    QTimer::singleShot(50, page_.get(), [this, remove, asked] {
      auto* box = page_->findChild<QMessageBox*>("askToRemove");
      ASSERT_NE(box, nullptr);
      *asked = box->text() + ' ' + box->informativeText();
      QTest::mouseClick(remove ? box->findChild<QPushButton*>("remove") : box->button(QMessageBox::Cancel),
                        Qt::LeftButton);
    });
  }

  std::unique_ptr<CampaignPage> page_;
};

TEST_F(CampaignPageTest, WithoutACampaignItSaysWhatToDoAndAForeignFolderIsRefused) {
  EXPECT_TRUE(Find<QLabel>("emptyHint")->isVisible());
  page_->model()->Open(dir_.path());
  ASSERT_TRUE(Idle());
  ASSERT_TRUE(error_);
  EXPECT_EQ(error_->code, ErrorCode::kBadInput);
  EXPECT_TRUE(Find<QPushButton>("newFirst")->isVisible());
}

TEST_F(CampaignPageTest, AHandIsCapturedWithTheOpenDeviceAndTheNextOneIsChosen) {
  Calibrate();
  Create();
  Person("p01");
  EXPECT_FALSE(Find<QPushButton>("next")->isEnabled());
  EXPECT_TRUE(Find<QLabel>("next words")->text().contains("Device page"));
  QSignalSpy opened(&workbench_.device(), &DeviceSession::Opened);
  workbench_.device().Open(DeviceFile());
  ASSERT_TRUE(opened.wait(kPatience_ms));
  ASSERT_TRUE(QTest::qWaitFor([&] { return Find<QPushButton>("next")->isEnabled(); }, kPatience_ms));
  Click("next");
  ASSERT_TRUE(QTest::qWaitFor([&] { return Said().contains("capture 1 of 1 is stored"); }, kPatience_ms))
      << error_.value_or(Error{}).message;
  ASSERT_TRUE(Idle());
  EXPECT_EQ(page_->model()->view()->status.captures, 1);
  EXPECT_EQ(page_->model()->view()->status.without_calibration, 0) << "it took the one that was open";
  EXPECT_EQ(page_->chosen().hand, CampaignHand::kRight);
  EXPECT_EQ(Find<QPushButton>("next")->text(), "Capture the right hand");
  page_->findChild<CampaignPeople*>()->Choose({"p01", 1, CampaignHand::kLeft});
  Click("look");
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.scan() != nullptr; }, kPatience_ms))
      << error_.value_or(Error{}).message;
  EXPECT_EQ(workbench_.scan()->name, "p01_s1_left_k1");
  EXPECT_GT(workbench_.scan()->surface.points.size(), 1000U);
}

TEST_F(CampaignPageTest, ADeviceThatIsUnpluggedIsSaidAndNothingIsStored) {
  Create();
  Person("p01");
  QSignalSpy opened(&workbench_.device(), &DeviceSession::Opened);
  workbench_.device().Open(DeviceFile());
  ASSERT_TRUE(opened.wait(kPatience_ms));
  WithHooks([](DeviceHooks& hooks) {
    hooks.frame = [](int, const Result<Frame>&) -> Result<Frame> {
      return DeviceError("the camera is gone; plug it in again");
    };
  });
  error_.reset();
  page_->model()->Capture({"p01", 1, CampaignHand::kLeft, 1});
  ASSERT_TRUE(QTest::qWaitFor([&] { return error_.has_value(); }, kPatience_ms));
  EXPECT_EQ(error_->code, ErrorCode::kDevice);
  ASSERT_TRUE(Idle());
  EXPECT_EQ(page_->model()->view()->status.captures, 0);
  EXPECT_EQ(VerifyCampaign(dir_ / "study", {})->findings.size(), 0U);
  page_->Leave();
}

TEST_F(CampaignPageTest, TheSamePicturesTwiceAreRefusedAndNothingIsLost) {
  Create(2);
  Person("p01");
  Import("p01", 1);
  EXPECT_FALSE(error_);
  EXPECT_TRUE(Find<QListWidget>("warnings")->isVisible()) << "there is no calibration, which is said";
  Import("p01", 1);
  ASSERT_TRUE(error_);
  EXPECT_NE(error_->message.find("already"), std::string::npos);
  EXPECT_EQ(page_->model()->view()->status.captures, 1);
}

TEST_F(CampaignPageTest, RemovingAsksFirstSaysWhatIsLostAndNoIsTheDefault) {
  Create(2);
  Person("p01");
  Import("p01", 1);
  QString asked;
  Answer(false, &asked);
  Click("removePerson");
  EXPECT_TRUE(asked.contains("Remove p01") && asked.contains("1 capture") && asked.contains("for good"))
      << asked.toStdString();
  ASSERT_TRUE(Idle());
  EXPECT_EQ(page_->model()->view()->status.captures, 1);
  Answer(true, &asked);
  Click("removeCapture");
  ASSERT_TRUE(Idle());
  EXPECT_EQ(page_->model()->view()->status.captures, 0);
  EXPECT_EQ(page_->model()->view()->status.people, 1);
  Answer(true, &asked);
  Click("removePerson");
  ASSERT_TRUE(Idle());
  EXPECT_EQ(page_->model()->view()->status.people, 0);
  EXPECT_FALSE(Find<QPushButton>("removePerson")->isEnabled());
  EXPECT_FALSE(error_);
}

TEST_F(CampaignPageTest, VerifyingShowsEachFindingAndExportingSaysWhere) {
  Create();
  Person("p01");
  Import("p01", 1);
  Click("verify");
  ASSERT_TRUE(QTest::qWaitFor([&] { return Said().contains("as they were stored"); }, kPatience_ms));
  EXPECT_FALSE(Find<QListWidget>("warnings")->isVisible());
  ExportRequest request;
  request.out_dir = dir_ / "others";
  page_->model()->Export(request);
  ASSERT_TRUE(QTest::qWaitFor([&] { return Said().contains("Exported 1 people"); }, kPatience_ms));
  EXPECT_TRUE(std::filesystem::exists(dir_ / "others" / "SHA256SUMS"));
  ASSERT_TRUE(Idle());
  const auto capture = CaptureFolder(dir_ / "study", "p01", 1, {CampaignHand::kLeft, 1});
  ASSERT_TRUE(WriteFile(capture / "bgHand.png", "x").ok());
  Click("verify");
  ASSERT_TRUE(QTest::qWaitFor([&] { return Said().contains("not as it was stored"); }, kPatience_ms));
  ASSERT_EQ(Find<QListWidget>("warnings")->count(), 1);
  EXPECT_TRUE(Find<QListWidget>("warnings")->item(0)->text().contains("bgHand.png"));
}

TEST_F(CampaignPageTest, TheCampaignOfTheLastTimeIsOpenAgainAndADroppedOneIsOpened) {
  Create();
  auto again = std::make_unique<CampaignPage>(&workbench_, nullptr);
  again->Enter();
  ASSERT_TRUE(QTest::qWaitFor([&] { return again->model()->view() != nullptr; }, kPatience_ms));
  ASSERT_TRUE(Idle());
  ASSERT_TRUE(CreateCampaign({dir_ / "other", "other", {}, {}, {}}, {}).ok());
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QString::fromStdString((dir_ / "other").string()))});
  QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(again.get(), &enter);
  ASSERT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(again.get(), &drop);
  ASSERT_TRUE(Idle());
  EXPECT_EQ(again->model()->view()->status.campaign.name, "other");
}

// Opening and scrolling through many people on the disk. How long the window waits is told, not asserted,
// since it hangs on what else the machine does.
TEST_F(CampaignPageTest, ManyPeopleAreOpenedBesideTheWindow) {
  constexpr int kPeople = 300;
  Create();
  const auto dir = dir_ / "study";
  for (int i = 0; i < kPeople; ++i) {
    const std::string id = "p" + std::to_string(1000 + i);
    ASSERT_TRUE(MakeCampaignFolder(SessionFolder(dir, id, 1)).ok());
    ASSERT_TRUE(WritePerson(dir, {id, "man", "20-29", "2024-05-31", false}).ok());
    CampaignSession session{1, {}, {}};
    session.captures.push_back(
        {CampaignHand::kLeft, 1, "", {0, 1}, {{"bgHand.png", 9, std::string(64, 'a')}}});
    ASSERT_TRUE(WriteSession(dir, id, session).ok());
  }
  double longest_ms = 0.0;
  QElapsedTimer since;
  QTimer probe;
  QObject::connect(&probe, &QTimer::timeout, [&] {
    longest_ms = std::max(longest_ms, 1e-6 * static_cast<double>(since.nsecsElapsed()));
    since.start();
  });
  since.start();
  probe.start(0);
  QElapsedTimer reading;
  reading.start();
  page_->model()->Open(dir);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return page_->model()->view()->people.size() == kPeople; }, kPatience_ms));
  RecordProperty("open_ms", std::to_string(reading.elapsed()));
  RecordProperty("longest_wait_while_opening_ms", std::to_string(longest_ms));
  auto* table = Find<QTableView>("people");
  longest_ms = 0.0;
  for (int row = 0; row < kPeople; row += 25) {
    table->scrollTo(table->model()->index(row, 0));
    QTest::qWait(1);
  }
  RecordProperty("longest_wait_while_scrolling_ms", std::to_string(longest_ms));
  EXPECT_EQ(table->model()->rowCount(), kPeople);
  Click("gap");
  EXPECT_EQ(page_->chosen().id, "p1000");
  EXPECT_EQ(page_->chosen().hand, CampaignHand::kRight);
}

TEST_F(CampaignPageTest, TheDialogsSayWhatIsWrongBeforeAnythingIsDone) {
  PersonDialog person(std::nullopt, {"p01"}, nullptr);
  auto* accept = person.findChild<QPushButton*>("accept");
  auto* id = person.findChild<QLineEdit*>("id");
  EXPECT_FALSE(accept->isEnabled());
  id->setText("Anna");
  EXPECT_TRUE(person.problem().contains("never a name")) << person.problem().toStdString();
  id->setText("P01");
  EXPECT_TRUE(person.problem().contains("already"));
  id->setText("p02");
  EXPECT_FALSE(accept->isEnabled());
  EXPECT_TRUE(person.problem().contains("consent")) << person.problem().toStdString();
  person.findChild<QCheckBox*>("signed")->setChecked(true);
  EXPECT_TRUE(accept->isEnabled()) << person.problem().toStdString();
  NewCampaignDialog campaign({}, nullptr);
  campaign.findChild<QLineEdit*>("parent")->setText(QString::fromStdString(dir_.path().string()));
  std::filesystem::create_directories(dir_ / "there" / "inside");
  campaign.findChild<QLineEdit*>("name")->setText("there");
  EXPECT_TRUE(campaign.problem().contains("there already"));
  campaign.findChild<QLineEdit*>("name")->setText("../away");
  EXPECT_FALSE(campaign.problem().isEmpty());
  campaign.findChild<QLineEdit*>("name")->setText("new");
  EXPECT_EQ(campaign.problem(), "");
  EXPECT_EQ(campaign.request().dir, dir_ / "new");
}

// A picture for people, where DORSUM_SCREENSHOTS names a folder.
TEST(CampaignPagePicture, TheWindowAtItsUsualSize) {
  const QString folder = qEnvironmentVariable("DORSUM_SCREENSHOTS");
  if (folder.isEmpty()) GTEST_SKIP() << "DORSUM_SCREENSHOTS names no folder";
  QSettings().remove("campaign");
  const TempFolder dir;
  Workbench workbench;
  MainWindow window(&workbench);
  window.resize(1280, 800);
  CampaignPage* page = nullptr;
  for (int i = 0; i < window.pages() && page == nullptr; ++i) {
    page = qobject_cast<CampaignPage*>(window.page(i));
    if (page != nullptr) window.ShowPage(i);
  }
  ASSERT_NE(page, nullptr);
  window.show();
  QTest::qWait(100);
  EXPECT_TRUE(window.grab().save(folder + "/studio-campaign-empty.png"));
  ASSERT_TRUE(WriteFile(dir / "device.toml", ScanFixture::kDevice).ok());
  VirtualCampaignRequest request;
  request.dir = dir / "study";
  request.plan.people = 8;
  request.device = dir / "device.toml";
  request.calibration = ScanFixture::CalibrationJson();
  ASSERT_TRUE(MakeVirtualCampaign(request, {}).ok());
  for (const int number : {3, 5, 6}) {  // some gaps
    const std::string id = (*ListPeople(request.dir))[static_cast<std::size_t>(number)];
    ASSERT_TRUE(RemoveFromCampaign({request.dir, id, 1, CaptureKey{CampaignHand::kRight, 1}}, {}).ok());
  }
  page->model()->Open(request.dir);
  ASSERT_TRUE(QTest::qWaitFor([&] { return page->model()->view() != nullptr; }, kPatience_ms));
  page->findChild<CampaignPeople*>()->Choose({(*ListPeople(request.dir))[2], 1, CampaignHand::kLeft});
  QTest::qWait(4000);
  EXPECT_TRUE(window.grab().save(folder + "/studio-campaign.png"));
  std::string text = ScanFixture::kDevice;
  text.insert(text.find("[camera]\n") + 9, "source = \"virtual:1\"\n");
  ASSERT_TRUE(WriteFile(dir / "open.toml", text).ok());
  QSignalSpy frame(&workbench.device(), &DeviceSession::FrameReady);
  workbench.device().Open((dir / "open.toml").string());
  ASSERT_TRUE(frame.wait(kPatience_ms));
  ASSERT_TRUE(WriteFile(request.dir / "people" / (*ListPeople(request.dir))[0] / "note.txt", "x").ok());
  QSignalSpy warned(page->model(), &CampaignModel::Warned);
  page->model()->Verify();
  ASSERT_TRUE(warned.wait(kPatience_ms));
  QTest::qWait(200);
  EXPECT_TRUE(window.grab().save(folder + "/studio-campaign-device.png"));
  PersonDialog person(std::nullopt, {}, &window);
  NewCampaignDialog campaign({}, &window);
  ExportDialog others(request.dir, &window);
  for (FormDialog* dialog : {static_cast<FormDialog*>(&person), static_cast<FormDialog*>(&campaign),
                             static_cast<FormDialog*>(&others)}) {
    dialog->show();
    QTest::qWait(100);
    EXPECT_TRUE(dialog->grab().save(folder + "/" + dialog->metaObject()->className() + ".png"));
  }
}

}  // namespace
}  // namespace dorsum
