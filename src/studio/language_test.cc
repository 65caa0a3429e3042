// SPDX-License-Identifier: Apache-2.0
#include "studio/language.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QListWidget>
#include <QLocale>
#include <QMenu>
#include <QProcess>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <algorithm>

#include "calibration/calibration_file.h"
#include "captures/series_plan.h"
#include "jobs/reconstruct_options.h"
#include "studio/library_words.h"
#include "studio/window_fixture_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

struct Message {
  QString source;
  QStringList said;  // more than one of a plural
  bool finished = true;
};

std::vector<Message> ReadMessages(const QString& path) {
  std::vector<Message> messages;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return messages;
  QXmlStreamReader xml(&file);
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == u"source") {
      messages.push_back({xml.readElementText(), {}, true});
    } else if (xml.name() == u"translation") {
      messages.back().finished = !xml.attributes().hasAttribute("type");
      const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements);
      messages.back().said = text.trimmed().isEmpty() ? QStringList() : QStringList(text);
    }
  }
  return messages;
}

// %1, %L2, %n …: in any order, but each of them.
QStringList Places(const QString& text) {
  static const QRegularExpression form("%L?[0-9n]");
  QStringList places;
  for (auto it = form.globalMatch(text); it.hasNext();) places.append(it.next().captured().remove('L'));
  places.removeDuplicates();
  places.sort();
  return places;
}

class LanguageTest : public WindowTest {
 protected:
  ~LanguageTest() override { SpeakLanguage(qApp, "en"); }
};

TEST_F(LanguageTest, EveryTextOfTheSourcesIsTranslatedWithItsValues) {
  if (!fs::exists(DORSUM_TEST_LUPDATE)) GTEST_SKIP() << "no lupdate";
  for (const char* code : {"de", "cs", "en"}) {
    const std::string name = std::string("dorsum_") + code + ".ts";
    fs::copy_file("src/studio/translations/" + name, dir_ / name);
  }
  qputenv("LUPDATE", DORSUM_TEST_LUPDATE);
  ASSERT_EQ(QProcess::execute("scripts/translate", {QString::fromStdString(dir_.path().string())}), 0);
  for (const char* code : {"de", "cs", "en"}) {
    const auto messages = ReadMessages(QString("%1/dorsum_%2.ts").arg(dir_.path().c_str(), code));
    EXPECT_GE(messages.size(), std::string(code) == "en" ? 2U : 300U);
    for (const Message& message : messages) {
      const std::string what = std::string(code) + ": " + message.source.toStdString();
      EXPECT_TRUE(message.finished && !message.said.isEmpty()) << what;
      const QString said = message.said.join("");
      EXPECT_EQ(Places(message.source), Places(said)) << what;
      EXPECT_EQ(message.source.contains('&'), said.contains('&')) << what << ": its key for Alt";
      EXPECT_EQ(message.source.count(";;"), said.count(";;")) << what;
    }
  }
}

TEST_F(LanguageTest, TheDesktopsLanguageIsTakenUnlessOneIsChosen) {
  EXPECT_EQ(LanguageOf({"de-AT", "en-US"}), "de");
  EXPECT_EQ(LanguageOf({"cs_CZ"}), "cs");
  EXPECT_EQ(LanguageOf({"sk", "cs"}), "cs");
  EXPECT_EQ(LanguageOf({"fr-FR"}), "en");
  EXPECT_EQ(LanguageOf({}), "en");
  EXPECT_EQ(ChosenLanguage(), "");
  QSettings().setValue("studio/language", "xx");
  EXPECT_EQ(ChosenLanguage(), "");
  EXPECT_FALSE(SpeakLanguage(qApp, "xx"));
  const QList<QAction*> choices = window_->findChild<QMenu*>("languages")->actions();
  ASSERT_EQ(choices.size(), 4);
  choices[3]->trigger();
  EXPECT_EQ(ChosenLanguage(), "cs");
  choices[0]->trigger();
  EXPECT_EQ(ChosenLanguage(), "");
}

TEST_F(LanguageTest, PluralsAndNumbersAreThoseOfTheLanguage) {
  const auto points = [](int n) {
    return QCoreApplication::translate("dorsum::SurfacePage", "%Ln point(s)", "", n);
  };
  ASSERT_TRUE(SpeakLanguage(qApp, "en"));
  EXPECT_EQ(points(1), "1 point");
  EXPECT_EQ(points(12345), "12,345 points");
  ASSERT_TRUE(SpeakLanguage(qApp, "de"));
  EXPECT_EQ(points(12345), "12.345 Punkte");
  ASSERT_TRUE(SpeakLanguage(qApp, "cs"));
  EXPECT_EQ(points(1), "1 bod");
  EXPECT_EQ(points(3), "3 body");
  EXPECT_EQ(points(5), QString::fromUtf8("5 bodů"));
}

TEST_F(LanguageTest, WhatTheLibrariesSayInOrdinaryUseIsKnown) {
  const auto device = ReadDeviceDescription(ScanFixture::Scan() / "device.toml");
  ASSERT_TRUE(device.ok());
  for (const SeriesStep& step : PlanCalibrationSeries(*device)) {
    EXPECT_TRUE(IsKnownText(InstructionOf(step, *device))) << InstructionOf(step, *device);
  }
  const auto calibration = ReadCalibration(ScanFixture::CalibrationJson());
  ASSERT_TRUE(calibration.ok());
  for (const PartReport& part : calibration->parts) {
    EXPECT_TRUE(IsKnownText(part.part)) << part.part;
    EXPECT_TRUE(IsKnownText(part.verdict)) << part.verdict;
    for (const Figure& figure : part.figures) EXPECT_TRUE(IsKnownText(figure.name)) << figure.name;
  }
  ReconstructOptions options;
  const OptionTable table = DescribeReconstructOptions(&options);
  for (const OptionSpec& option : table.specs()) EXPECT_TRUE(IsKnownText(option.help)) << option.help;
  ASSERT_TRUE(SpeakLanguage(qApp, "de"));
  EXPECT_EQ(
      InOwnWords("Again: the chessboard lies as it did before. Clear the backplane."),
      QString::fromUtf8("Noch einmal: das Schachbrett liegt wie zuvor. Räumen Sie die Grundplatte frei."));
  EXPECT_EQ(InOwnWords("focal length, uncertainty"), "Brennweite, Unsicherheit");
  EXPECT_EQ(ClausesInOwnWords(
                "cones explain all stripes; the fan leans by -0.18 degrees, too little to tell its form"),
            QString::fromUtf8(
                "Kegel erklären alle Laserstreifen; der Fächer neigt sich um -0.18 Grad, zu wenig, um "
                "seine Form zu bestimmen"));
  // What is not known stays as it is, whole.
  EXPECT_EQ(ClausesInOwnWords("the board is flat; nobody knows this"),
            "the board is flat; nobody knows this");
  EXPECT_EQ(InOwnWords("laser 1 moved between the series"), "laser 1 moved between the series");
}

TEST_F(LanguageTest, TheWindowFitsASmallScreenInEachLanguage) {
  for (const Language& language : Languages()) {
    window_.reset();
    ASSERT_TRUE(SpeakLanguage(qApp, language.code));
    window_ = std::make_unique<MainWindow>(&workbench_);
    window_->resize(1280, 800);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    EXPECT_EQ(Find<QListWidget>(window_.get(), "pages")->item(1)->text() == "Surface", language.code == "en");
    for (int i = 0; i < window_->pages(); ++i) {
      window_->ShowPage(i);
      QTest::qWait(30);
      EXPECT_LE(window_->minimumSizeHint().width(), 1280) << language.code.toStdString() << ", page " << i;
      EXPECT_LE(window_->minimumSizeHint().height(), 800) << language.code.toStdString() << ", page " << i;
      EXPECT_LE(window_->width(), 1280);
      EXPECT_LE(window_->height(), 800);
      const QString folder = qEnvironmentVariable("DORSUM_SCREENSHOTS");
      if (!folder.isEmpty()) {
        window_->grab().save(QString("%1/language-%2-%3.png").arg(folder, language.code).arg(i));
      }
    }
  }
}

}  // namespace
}  // namespace dorsum
