// SPDX-License-Identifier: Apache-2.0
#include <QApplication>
#include <QCommandLineParser>
#include <QSurfaceFormat>

#include "base/heap.h"
#include "base/version.h"
#include "captures/picture_pool.h"
#include "studio/language.h"
#include "studio/main_window.h"

int main(int argc, char** argv) {
  dorsum::KeepFreedMemory();
  dorsum::KeepPictureMemory();
  // FFmpeg would put its own words on the standard error; -8 is its "quiet".
  qputenv("OPENCV_FFMPEG_LOGLEVEL", "-8");
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setSamples(4);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Dorsum");
  QApplication::setApplicationName("dorsum-studio");
  QApplication::setApplicationVersion(dorsum::kVersion);
  dorsum::SpeakChosenLanguage(&application);

  QCommandLineParser parser;
  parser.setApplicationDescription(QApplication::translate("main", "Dorsum Studio: the window of Dorsum."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("path", QApplication::translate("main", "capture folder or PLY file to open"),
                               "[path]");
  const QCommandLineOption device(
      "device", QApplication::translate("main", "device description, or virtual[:SEED]"), "DEVICE");
  const QCommandLineOption calibration({"c", "calibration"},
                                       QApplication::translate("main", "calibration.json"), "FILE");
  parser.addOption(device);
  parser.addOption(calibration);
  parser.process(application);

  dorsum::Workbench workbench;
  dorsum::MainWindow window(&workbench);
  window.show();
  if (parser.isSet(device)) workbench.device().Open(parser.value(device).toStdString());
  const QStringList paths = parser.positionalArguments();
  if (parser.isSet(calibration)) {
    if (!paths.isEmpty()) {
      QObject::connect(
          &workbench, &dorsum::Workbench::CalibrationChanged, &window,
          [&workbench, path = paths.front().toStdString()] { workbench.OpenPath(path); },
          Qt::SingleShotConnection);
    }
    workbench.LoadCalibration(parser.value(calibration).toStdString());
  } else if (!paths.isEmpty()) {
    workbench.OpenPath(paths.front().toStdString());
  }
  return QApplication::exec();
}
