// SPDX-License-Identifier: Apache-2.0
#include "studio/library_words.h"

#include <QApplication>
#include <QRegularExpression>
#include <cerrno>
#include <cstring>
#include <functional>

#include "calibration/calibration_file.h"
#include "captures/device_description.h"
#include "device/camera_source.h"
#include "device/serial_lights.h"
#include "device/serial_port.h"
#include "jobs/campaign_add.h"
#include "jobs/campaign_names.h"
#include "jobs/capture_checks.h"
#include "studio/language.h"
#include "studio/library_texts.h"
#include "studio/window_fixture_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

template <class T>
std::string InGerman(const T& result) {
  return result.ok() ? "no error" : InOwnWords(result.error().message).toStdString();
}

class LibraryWordsTest : public WindowTest {
 protected:
  LibraryWordsTest() { SpeakLanguage(qApp, "de"); }
  ~LibraryWordsTest() override { SpeakLanguage(qApp, "en"); }

  fs::path Write(const std::string& name, const std::string& content) {
    EXPECT_TRUE(WriteFile(dir_ / name, content).ok());
    return dir_ / name;
  }
};

// A text that another one takes for its own would be said wrongly, or half in English.
TEST_F(LibraryWordsTest, EveryTextIsSaidByItsOwnTranslationWithItsValues) {
  std::size_t known = 0;
  for (const auto& texts : {LibraryTextsOfUse(), LibraryErrorsOfFiles(), LibraryErrorsOfDevices(),
                            LibraryErrorsOfCaptures(), LibraryErrorsOfCampaigns()}) {
    for (const char* text : texts) {
      QString english = QString::fromUtf8(text);
      QString german = QCoreApplication::translate("library", text);
      EXPECT_NE(english, german.isEmpty() ? english : QString()) << text;
      for (int i = 9; i >= 1; --i) {
        const QString value = QString("w%1.5").arg(i);
        english.replace("%" + QString::number(i), value);
        german.replace("%" + QString::number(i), value);
      }
      EXPECT_EQ(InOwnWords(english.toStdString()).toStdString(), german.toStdString());
      ++known;
    }
  }
  EXPECT_GT(known, 400U);
}

TEST_F(LibraryWordsTest, ErrorsOfFilesAreSaidInGermanWithTheirValues) {
  const std::string none = (dir_ / "my files" / "a: b.json").string();
  EXPECT_EQ(InGerman(ReadFile(none)), "die Datei " + none + " gibt es nicht");
  const std::string why = InOwnWords(std::strerror(ENOENT)).toStdString();
  const std::string nowhere = (dir_ / "nowhere" / "a.json").string();
  EXPECT_EQ(InGerman(WriteFile(nowhere, "x")),
            nowhere + " kann nicht geschrieben werden: " + why +
                "; wählen Sie einen Ordner, in den Sie schreiben dürfen und in dem Platz ist");
  const fs::path junk = Write("junk.ply", "hello");
  EXPECT_EQ(InGerman(ReadSurface(junk)),
            junk.string() + ": es ist keine PLY-Datei; schreiben Sie die Datei neu");
  const fs::path text = Write("text.json", "hello");
  EXPECT_EQ(InGerman(ReadCalibration(text)),
            text.string() + " ist kein gültiges JSON; schreiben Sie es neu, oder stellen Sie es wieder her");
  const fs::path other = Write("other.json", R"({"schema": "dorsum-report"})");
  EXPECT_NE(InGerman(ReadCalibration(other)).find("sondern eine dorsum-report-Datei"), std::string::npos)
      << InGerman(ReadCalibration(other));
  const fs::path empty = Write("empty.json", "{}");
  EXPECT_EQ(InGerman(ReadCalibration(empty)).find("missing"), std::string::npos);
  const fs::path device = Write("device.toml", "[camera]\nresolution_px = [20, 20]\n");
  const std::string wrong = InGerman(ReadDeviceDescription(device));
  EXPECT_EQ(wrong,
            device.string() + ": camera.resolution_px ist 20; es muss eine Zahl von 64 bis 10000 sein");
}

TEST_F(LibraryWordsTest, ErrorsOfDevicesAreSaidInGermanWithTheirValues) {
  EXPECT_EQ(InGerman(SerialPort::Open("/dev/no-such-port", 115200)),
            "den Anschluss /dev/no-such-port gibt es nicht; schließen Sie die Lichtsteuerung an, oder "
            "berichtigen Sie controller.port in der Gerätebeschreibung");
  EXPECT_EQ(InGerman(OpenFirstSerialLights({}, {}, {})).find("there is no"), std::string::npos);
  CameraDesign design;
  design.source = "/dev/video63";
  const std::string camera = InGerman(OpenCamera(design, {}));
  EXPECT_EQ(camera.rfind("die Kamera /dev/video63 kann nicht geöffnet werden: ", 0), 0U) << camera;
  EXPECT_NE(InGerman(ParseCameraSource("nonsense")).find("Kameraquelle \"nonsense\""), std::string::npos);
  // A cause in brackets, and one after a colon.
  EXPECT_EQ(InOwnWords("no light controller on any of /dev/ttyUSB0 (/dev/ttyUSB0 is in use by another "
                       "program; close that first)")
                .toStdString(),
            "keine Lichtsteuerung an einem von /dev/ttyUSB0 (/dev/ttyUSB0 wird von einem anderen Programm "
            "benutzt; schließen Sie dieses zuerst)");
  EXPECT_EQ(InOwnWords("none of the cameras can be used: /dev/video0 cannot be opened: Device or resource "
                       "busy; close the other program that uses it")
                .toStdString(),
            "keine der Kameras kann benutzt werden: /dev/video0 kann nicht geöffnet werden: es wird gerade "
            "benutzt; schließen Sie das andere Programm, das sie benutzt");
}

TEST_F(LibraryWordsTest, ErrorsOfCapturesAndCampaignsAreSaidInGermanWithTheirValues) {
  const std::string none = (dir_ / "none").string();
  EXPECT_EQ(InGerman(LoadCapture(none, {560, 420}, {0})), "den Aufnahmeordner " + none + " gibt es nicht");
  fs::create_directories(none);
  EXPECT_EQ(InGerman(LoadCapture(none, {560, 420}, {0})),
            "das Bild bgHand (.jpg oder .png) fehlt in " + none);
  const fs::path hand = ScanFixture::Scan() / "captures" / ScanFixture::kHand;
  const std::string size = InGerman(LoadCapture(hand, {640, 480}, {0, 1, 2}));
  EXPECT_NE(size.find(" hat 560x420 Pixel, aber 640x480 werden erwartet"), std::string::npos) << size;
  const cv::Mat black = cv::Mat::zeros(420, 560, CV_8UC3);
  EXPECT_EQ(InOwnWords(CheckLaser(black, black, 2, {}).sentence).toStdString(),
            "Laser 2 leuchtet nicht; prüfen Sie Versorgung, Kabel und Kanal");
  EXPECT_EQ(InGerman(CheckConsentDate("2999-01-01", "2024-05-31")),
            "das Datum der Einwilligung 2999-01-01 liegt in der Zukunft (heute ist 2024-05-31); ohne "
            "Einwilligung wird nichts gespeichert");
  AddPersonRequest person;
  person.dir = dir_.path();
  person.person = {"p01", "woman", "20-29", "2024-05-31", false};
  EXPECT_EQ(InGerman(AddPerson(person, {})),
            "in " + dir_.path().string() + " ist keine Kampagne; dorsum campaign new legt eine an");
}

TEST_F(LibraryWordsTest, TheBannerSaysThemAndLeavesWhatIsNotKnown) {
  workbench_.OpenPath(dir_ / "none.json");
  ASSERT_TRUE(Rests());
  EXPECT_EQ(Said(), "Die Datei " + (dir_ / "none.json").string() + " gibt es nicht.");
  workbench_.Fail(BadInput("nobody foresaw this: 7 of 9"));
  EXPECT_EQ(Said(), "Nobody foresaw this: 7 of 9.");
}

}  // namespace
}  // namespace dorsum
