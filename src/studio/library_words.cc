// SPDX-License-Identifier: Apache-2.0
#include "studio/library_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <optional>
#include <vector>

namespace dorsum {
namespace {

// %1 … %4 stand for values, or for texts that are known themselves.
// NOLINTBEGIN(bugprone-suspicious-missing-comma): long sentences are several literals
constexpr const char* kTexts[] = {
    // What to arrange (captures/series_plan.h, jobs/live_series.h).
    QT_TRANSLATE_NOOP(
        "library",
        "Lay the chessboard flat on the backplane, its middle on the central stripe of laser %1 and "
        "its rows across the stripes."),
    QT_TRANSLATE_NOOP(
        "library",
        "Hold the chessboard raised and tilted by 10 to 25 degrees, another way than before, all of "
        "it in the picture."),
    QT_TRANSLATE_NOOP("library", "Clear the backplane."),
    QT_TRANSLATE_NOOP(
        "library",
        "Lay the chessboard flat on the backplane, its middle on the central stripe of laser %1, "
        "which is on now."),
    QT_TRANSLATE_NOOP("library",
                      "Lay the sheet with one line for each laser on the backplane, the lines on the central "
                      "stripes."),
    QT_TRANSLATE_NOOP("library",
                      "Put the calibration object of %1 mm on the backplane; it must fill the picture."),
    QT_TRANSLATE_NOOP(
        "library",
        "Lay the chessboard flat on the calibration object, its middle on the central stripe of "
        "laser %1, which is on now."),
    QT_TRANSLATE_NOOP("library",
                      "Put the box of %1 mm on the empty backplane, in the middle of the picture."),
    QT_TRANSLATE_NOOP("library", "Again: %1. %2"),
    QT_TRANSLATE_NOOP("library", "the chessboard of %1 x %2 inner corners is not seen whole"),
    QT_TRANSLATE_NOOP("library", "the chessboard lies as it did before"),
    QT_TRANSLATE_NOOP("library",
                      "Chessboard %1 of %2: the boards cover %3 % of the picture; least at the %4."),
    QT_TRANSLATE_NOOP("library", "Chessboard %1 of %2: the boards cover %3 % of the picture."),
    QT_TRANSLATE_NOOP("library", "top left"),
    QT_TRANSLATE_NOOP("library", "top right"),
    QT_TRANSLATE_NOOP("library", "bottom left"),
    QT_TRANSLATE_NOOP("library", "bottom right"),
    // Parts of a calibration, verdicts on them, and their figures (calibration/bundle_verdicts.h).
    QT_TRANSLATE_NOOP("library", "camera"),
    QT_TRANSLATE_NOOP("library", "chessboard"),
    QT_TRANSLATE_NOOP("library", "known heights"),
    QT_TRANSLATE_NOOP("library", "surface error correction"),
    QT_TRANSLATE_NOOP("library", "laser %1"),
    QT_TRANSLATE_NOOP("library", "the camera model explains all chessboards"),
    QT_TRANSLATE_NOOP(
        "library",
        "the corners do not fit; capture the chessboards again with a flat board and a sharp picture"),
    QT_TRANSLATE_NOOP("library", "the corners do not fit well, worst in %1"),
    QT_TRANSLATE_NOOP("library", "is the board flat, sharp and still?"),
    QT_TRANSLATE_NOOP("library", "the board is flat"),
    QT_TRANSLATE_NOOP("library", "the board is not flat: its corners lie %1 mm off its middle"),
    QT_TRANSLATE_NOOP("library", "that bow was taken into account, but mount the board on something flat"),
    QT_TRANSLATE_NOOP("library", "all heights fit as they were given"),
    QT_TRANSLATE_NOOP("library", "the height of %1 is given as %2 mm, fits %3 mm"),
    QT_TRANSLATE_NOOP("library", "what fits was used, so measure it and correct setup.json"),
    QT_TRANSLATE_NOOP("library", "cones explain all stripes"),
    QT_TRANSLATE_NOOP("library", "the fan leans by %1 degrees, too little to tell its form"),
    QT_TRANSLATE_NOOP("library", "the fan leans by %1 degrees and is flat, as it leaves a laser"),
    QT_TRANSLATE_NOOP("library",
                      "the fan leans by %1 degrees and has one cosine all along (a cone before the grating)"),
    QT_TRANSLATE_NOOP("library", "the fan leans by %1 degrees and is bowed, neither flat nor a cone"),
    QT_TRANSLATE_NOOP("library", "the second-order correction explains the boxes"),
    QT_TRANSLATE_NOOP("library", "views"),
    QT_TRANSLATE_NOOP("library", "boards that lie on known heights"),
    QT_TRANSLATE_NOOP("library", "reprojection error"),
    QT_TRANSLATE_NOOP("library", "worst view"),
    QT_TRANSLATE_NOOP("library", "focal length"),
    QT_TRANSLATE_NOOP("library", "principal point"),
    QT_TRANSLATE_NOOP("library", "camera height"),
    QT_TRANSLATE_NOOP("library", "stripe points"),
    QT_TRANSLATE_NOOP("library", "sheet residual"),
    QT_TRANSLATE_NOOP("library", "pattern left"),
    QT_TRANSLATE_NOOP("library", "height uncertainty by calibration"),
    QT_TRANSLATE_NOOP("library", "grating x"),
    QT_TRANSLATE_NOOP("library", "grating height"),
    QT_TRANSLATE_NOOP("library", "order step"),
    QT_TRANSLATE_NOOP("library", "fan distance"),
    QT_TRANSLATE_NOOP("library", "fan tilt"),
    QT_TRANSLATE_NOOP("library", "fan bow"),
    QT_TRANSLATE_NOOP("library", "sag of the corners"),
    QT_TRANSLATE_NOOP("library", "sag, in standard deviations"),
    QT_TRANSLATE_NOOP("library", "%1, uncertainty"),
    QT_TRANSLATE_NOOP("library", "laser %1: height error before"),
    QT_TRANSLATE_NOOP("library", "laser %1: height error after"),
    QT_TRANSLATE_NOOP("library", "laser %1: points"),
    QT_TRANSLATE_NOOP("library", "%1: given"),
    QT_TRANSLATE_NOOP("library", "%1: fits"),
    QT_TRANSLATE_NOOP("library", "%1: uncertainty"),
    // The examination of a device (jobs/doctor.h).
    QT_TRANSLATE_NOOP("library", "cameras"),
    QT_TRANSLATE_NOOP("library", "serial ports"),
    QT_TRANSLATE_NOOP("library", "disk"),
    QT_TRANSLATE_NOOP("library", "calibration"),
    QT_TRANSLATE_NOOP("library", "device"),
    QT_TRANSLATE_NOOP("library", "light controller"),
    QT_TRANSLATE_NOOP("library", "daylight"),
    QT_TRANSLATE_NOOP("library", "LEDs"),
    QT_TRANSLATE_NOOP("library", "virtual camera"),
    QT_TRANSLATE_NOOP("library", "virtual light controller"),
    QT_TRANSLATE_NOOP("library", "virtual light controller, firmware virtual"),
    QT_TRANSLATE_NOOP("library", "virtual camera, %1 x %2 pixels"),
    QT_TRANSLATE_NOOP("library", "this machine has no camera"),
    QT_TRANSLATE_NOOP("library", "plug one in; a network camera or virtual needs none"),
    QT_TRANSLATE_NOOP("library", "no serial port of a USB device is there"),
    QT_TRANSLATE_NOOP("library", "plug the light controller in; virtual needs none"),
    QT_TRANSLATE_NOOP("library", "%1 may be used"),
    QT_TRANSLATE_NOOP("library", "%1 may not be used by you"),
    QT_TRANSLATE_NOOP("library", "%1 GB are free at %2"),
    QT_TRANSLATE_NOOP("library", "make room: a capture takes some megabytes"),
    QT_TRANSLATE_NOOP("library", "%1 is %2 days old, made by version %3 with method %4"),
    QT_TRANSLATE_NOOP("library", "the check below says whether it still fits"),
    QT_TRANSLATE_NOOP("library", "calibrate the device"),
    QT_TRANSLATE_NOOP("library", "calibrate this device"),
    QT_TRANSLATE_NOOP("library", "little light comes from elsewhere"),
    QT_TRANSLATE_NOOP("library", "they light the picture"),
    QT_TRANSLATE_NOOP("library", "it lights its stripes"),
    QT_TRANSLATE_NOOP("library", "it is of a camera of %1 x %2 pixels"),
    QT_TRANSLATE_NOOP("library", "its stripes lie %1 px from where the calibration has them (%2 points)"),
    QT_TRANSLATE_NOOP("library", "camera, laser or backplane moved: calibrate again"),
    QT_TRANSLATE_NOOP("library", "clear the backplane and ask again; if it is clear, calibrate again"),
    // Parameters of the reconstruction (jobs/reconstruct_options.h).
    QT_TRANSLATE_NOOP("library", "how the object is found in the image (§3.4)"),
    QT_TRANSLATE_NOOP("library", "how stripes are located (§3.4)"),
    QT_TRANSLATE_NOOP("library", "how stripes get their orders (§3.5)"),
    QT_TRANSLATE_NOOP("library",
                      "whether the surface's brightness is taken off the stripes' centres (ridges)"),
    QT_TRANSLATE_NOOP("library", "model of a light sheet (§3.6)"),
    QT_TRANSLATE_NOOP("library", "surface error correction of plane sheets (3.9)"),
    QT_TRANSLATE_NOOP("library", "how the lasers are merged"),
    QT_TRANSLATE_NOOP("library", "a stripe keeps its order where any other costs this much more (joint)"),
    QT_TRANSLATE_NOOP("library", "the same for a whole surface"),
    QT_TRANSLATE_NOOP("library", "how far the surface goes on beyond the last points, mm (robust)"),
    QT_TRANSLATE_NOOP("library", "widest gap between points that closes, mm (robust)"),
    QT_TRANSLATE_NOOP("library", "a point further from the surface than this, mm, and than … (robust)"),
    QT_TRANSLATE_NOOP("library", "… that many of its sigma is left out (robust)"),
    QT_TRANSLATE_NOOP("library", "side of the mask's opening, px"),
    QT_TRANSLATE_NOOP("library", "least contrast of the object, 255ths of the background"),
    QT_TRANSLATE_NOOP("library", "window of the stripes' adaptive threshold, px"),
    QT_TRANSLATE_NOOP("library", "edge response above its local mean, grey values"),
    QT_TRANSLATE_NOOP("library", "side of the stripe mask's median, px"),
    QT_TRANSLATE_NOOP("library", "smallest stripe region, px"),
    QT_TRANSLATE_NOOP("library", "shortest stripe, px"),
    QT_TRANSLATE_NOOP("library", "rows on either side smoothed together, px"),
    QT_TRANSLATE_NOOP("library", "jump that parts a stripe, px"),
    QT_TRANSLATE_NOOP("library", "V of Algorithm 2, in usual spacings"),
    QT_TRANSLATE_NOOP("library",
                      "share of the central order's contrast that a level must show to be central"),
    QT_TRANSLATE_NOOP("library", "grid of the height field, mm"),
    QT_TRANSLATE_NOOP("library", "widest gap between stripes that is bridged, mm"),
    QT_TRANSLATE_NOOP("library", "steepest surface between stripes, degrees"),
    // What the window itself cannot do.
    QT_TRANSLATE_NOOP("library", "something else is being done; wait for it, or cancel it"),
    QT_TRANSLATE_NOOP("library", "no device is open; choose one on the device page"),
    QT_TRANSLATE_NOOP("library", "no device is open; open one on the Device page, then capture"),
    QT_TRANSLATE_NOOP(
        "library",
        "no device is open; open one on the device page, or calibrate from a folder that holds a "
        "series"),
    QT_TRANSLATE_NOOP("library", "no device is named; choose a device.toml, or write virtual"),
    QT_TRANSLATE_NOOP("library", "there is no surface to export; scan or open one first"),
    QT_TRANSLATE_NOOP("library", "only points are open and .%1 files hold meshes; export them as .ply"),
    QT_TRANSLATE_NOOP("library",
                      "'%1' does not say which file to write; end it with .ply, .obj, .stl, .glb or .png"),
    QT_TRANSLATE_NOOP("library",
                      "a capture needs the calibration of its device; open a calibration.json first"),
    QT_TRANSLATE_NOOP("library", "%1 is neither a capture folder nor a PLY file; drop one of those"),
    QT_TRANSLATE_NOOP("library",
                      "what was dropped is no file of this machine; drop a capture folder or a PLY file"),
};
// NOLINTEND(bugprone-suspicious-missing-comma)

struct Pattern {
  const char* text;
  QRegularExpression form;
};

const std::vector<Pattern>& Patterns() {
  static const std::vector<Pattern> all = [] {
    std::vector<Pattern> made;
    for (const char* text : kTexts) {
      QString form = QRegularExpression::escape(QString::fromUtf8(text));
      // In what is no sentence, such as "laser %1", a value is one word.
      const char* value = form.count(' ') > 1 || form.startsWith("\\%") ? "(.+)" : "(\\S+)";
      for (int i = 1; i <= 4; ++i) form.replace("\\%" + QString::number(i), value);
      made.push_back({text, QRegularExpression(QRegularExpression::anchoredPattern(form))});
    }
    return made;
  }();
  return all;
}

// Patterns' values stand in order, so that the n-th group is %n.
std::optional<QString> Find(const QString& english) {
  for (const Pattern& pattern : Patterns()) {
    const QRegularExpressionMatch match = pattern.form.match(english);
    if (!match.hasMatch()) continue;
    QString said = QCoreApplication::translate("library", pattern.text);
    for (int i = match.lastCapturedIndex(); i >= 1; --i) {
      const QString value = match.captured(i);
      said.replace("%" + QString::number(i), Find(value).value_or(value));
    }
    return said;
  }
  return std::nullopt;
}

}  // namespace

QString InOwnWords(const std::string& english) {
  const QString text = QString::fromStdString(english);
  return Find(text).value_or(text);
}

QString ClausesInOwnWords(const std::string& english) {
  const QString text = QString::fromStdString(english);
  QStringList said;
  for (const QString& clause : text.split("; ")) {
    const auto found = Find(clause);
    if (!found) return Find(text).value_or(text);
    said.append(*found);
  }
  return said.join("; ");
}

bool IsKnownText(const std::string& english) {
  const QString text = QString::fromStdString(english);
  if (Find(text)) return true;
  for (const QString& clause : text.split("; ")) {
    if (!Find(clause)) return false;
  }
  return true;
}

}  // namespace dorsum
