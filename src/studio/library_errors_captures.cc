// SPDX-License-Identifier: Apache-2.0
#include <QCoreApplication>

#include "studio/library_texts.h"

namespace dorsum {
namespace {

// NOLINTBEGIN(bugprone-suspicious-missing-comma): long sentences are several literals
constexpr const char* kTexts[] = {
    // Folders and images (captures/image_file.h, captures/capture.h).
    QT_TRANSLATE_NOOP("library", "there is no calibration folder %1"),
    QT_TRANSLATE_NOOP("library", "there is no capture folder %1"),
    QT_TRANSLATE_NOOP("library", "there is no image stripesHand0, stripesHand1, … in %1"),
    QT_TRANSLATE_NOOP("library",
                      "there is no setup.json in %1; it says what the chessboard and the boxes measure"),
    QT_TRANSLATE_NOOP("library", "the image %1 (.jpg or .png) is missing in %2"),
    QT_TRANSLATE_NOOP("library", "%1: the background image"),
    QT_TRANSLATE_NOOP("library", "%1 is %2 pixels, more than any camera here has; capture it again"),
    QT_TRANSLATE_NOOP("library", "%1 has %2 bits per channel; 8 are expected, so save it as 8 bit"),
    QT_TRANSLATE_NOOP(
        "library",
        "%1 is a grey image; the stripes are read from the green channel, so capture it in colour"),
    QT_TRANSLATE_NOOP("library",
                      "%1 is not a plain colour image; the stripes are read from the green channel, so "
                      "capture it in colour"),
    QT_TRANSLATE_NOOP("library",
                      "%1 is %2 pixels, but %3 is expected; use images of one camera at one resolution"),
    QT_TRANSLATE_NOOP("library", "%1 is cut off: its end is missing; copy or capture it again"),
    QT_TRANSLATE_NOOP("library", "%1 is damaged; copy or capture it again"),
    QT_TRANSLATE_NOOP("library", "%1 is a damaged PNG; copy or capture it again"),
    QT_TRANSLATE_NOOP("library", "%1 is a damaged JPEG; copy or capture it again"),
    QT_TRANSLATE_NOOP("library", "%1 is empty; copy or capture it again"),
    QT_TRANSLATE_NOOP("library", "%1 is neither a PNG nor a JPEG image; copy or capture it again"),
    QT_TRANSLATE_NOOP("library", "%1 cannot be decoded; copy or capture it again"),
    QT_TRANSLATE_NOOP("library", "%1 is black; check the light and the exposure"),
    QT_TRANSLATE_NOOP("library", "%1 is white all over; lower the exposure"),
    // What the pictures of a capture show (jobs/capture.h, jobs/capture_checks.h).
    QT_TRANSLATE_NOOP("library",
                      "with all lights off %1 of the picture is brighter than it may be; shade the device "
                      "from daylight, or shorten the camera's exposure"),
    QT_TRANSLATE_NOOP(
        "library",
        "the LEDs light too little of the picture; check their supply and channel, or expose longer"),
    QT_TRANSLATE_NOOP("library",
                      "%1 of the picture under the LEDs is overexposed; shorten the camera's exposure under "
                      "the LEDs, or dim them"),
    QT_TRANSLATE_NOOP("library", "laser %1 does not light up; check its supply, its cable and its channel"),
    QT_TRANSLATE_NOOP(
        "library",
        "%1 of the picture under laser %2 is overexposed; shorten the camera's exposure for the lasers"),
    QT_TRANSLATE_NOOP("library",
                      "the pictures of lasers %1 and %2 show the same stripes; check their cables, and that "
                      "their channels in device.toml differ"),
    QT_TRANSLATE_NOOP("library",
                      "laser %1 was lit in place of laser %2: its cable is plugged elsewhere than when the "
                      "device was calibrated, or a laser's channel in device.toml is wrong"),
    QT_TRANSLATE_NOOP(
        "library", "the hand moved by %1 while it was captured; rest it on the backplane and capture again"),
    QT_TRANSLATE_NOOP("library", "the hand moved by %1 while it was captured"),
    QT_TRANSLATE_NOOP("library",
                      "the hand leaves the picture at more than one place; move it to the middle, so that "
                      "only the wrist runs out"),
    QT_TRANSLATE_NOOP("library", "the device has no laser %1: its lasers are 0 to %2"),
    QT_TRANSLATE_NOOP("library", "%1 is there already and not empty; name a new folder"),
    QT_TRANSLATE_NOOP("library",
                      "%1 is of a camera of %2 pixels, the device's has %3; calibrate this device"),
    QT_TRANSLATE_NOOP(
        "library", "%1 is of another device or board than %2; go on with that device, or name a new folder"),
    QT_TRANSLATE_NOOP(
        "library",
        "no hand is seen in bgHand: it looks like the empty background; put the hand down and capture again"),
    QT_TRANSLATE_NOOP("library",
                      "bgHand differs from the background nearly everywhere; the light or the camera changed "
                      "since the calibration, so calibrate again"),
    QT_TRANSLATE_NOOP("library",
                      "no object is seen: a few stripes seem to lie on one, but make no outline together "
                      "with bgHand; put the hand down and capture again"),
    QT_TRANSLATE_NOOP("library",
                      "the object seems to fill the picture, so its outline is not seen; look whether bgHand "
                      "and the stripes are of one capture and the calibration is this device's"),
    QT_TRANSLATE_NOOP("library",
                      "only shadow is seen in bgHand: the object is as bright as the backplane, or it is "
                      "gone; cover a white object with something darker and capture again"),
    QT_TRANSLATE_NOOP("library",
                      "the stripes of laser %1 lie %2 px beside their places on the backplane: camera, laser "
                      "or backplane moved since the calibration; calibrate again"),
    QT_TRANSLATE_NOOP(
        "library", "no stripe is seen on the object; are the lasers on, and is the capture of this device?"),
    QT_TRANSLATE_NOOP("library",
                      "the calibration is for images of %1, but the capture has %2; use the calibration of "
                      "this camera and resolution"),
    QT_TRANSLATE_NOOP("library",
                      "the calibration holds no %1 sheets for laser %2; calibrate with --method %3, or "
                      "reconstruct with --sheets %4"),
    QT_TRANSLATE_NOOP("library",
                      "the stripes shine as those of other orders do, so the object reaches out of the "
                      "working volume of %1 to %2 mm; place it lower and capture again"),
    QT_TRANSLATE_NOOP(
        "library",
        "the lasers put the object at heights that differ by %1 mm: it reaches out of the working volume of "
        "%2 to %3 mm, or moved while it was captured; place it lower and capture again"),
    QT_TRANSLATE_NOOP(
        "library",
        "the lasers see the object at places that differ by %1 mm: it moved while it was captured, or "
        "reaches out of the working volume of %2 to %3 mm; place it lower, keep still and capture again"),
    QT_TRANSLATE_NOOP("library",
                      "the object moved by about %1 mm while it was captured, since the lasers see it at "
                      "different places; keep still and capture again"),
    QT_TRANSLATE_NOOP("library",
                      "stages are shown of a capture with its calibration; take one, or open its folder"),
    // Calibrations and their series (calibration/*).
    QT_TRANSLATE_NOOP("library",
                      "%1: the camera's matrix or pose is not one of a camera above the backplane"),
    QT_TRANSLATE_NOOP("library", "%1: laser %2 has no light sheets; calibrate again"),
    QT_TRANSLATE_NOOP("library", "%1: the working volume's bottom is not below its top"),
    QT_TRANSLATE_NOOP("library", "%1: the lasers are not in ascending order"),
    QT_TRANSLATE_NOOP("library", "%1 holds no laser; calibrate again"),
    QT_TRANSLATE_NOOP("library", "%1: the background image is damaged; calibrate again"),
    QT_TRANSLATE_NOOP("library",
                      "no chessboard of %1 inner corners is seen in %2, which fixes the world; capture it "
                      "again or correct setup.json"),
    QT_TRANSLATE_NOOP(
        "library", "no chessboard of %1 inner corners is seen in %2; capture it again or correct setup.json"),
    QT_TRANSLATE_NOOP("library",
                      "a chessboard is seen in only %1 of %2 views; at least %3 are needed, so capture the "
                      "chessboards again"),
    QT_TRANSLATE_NOOP("library",
                      "the chessboard views do not determine the camera; capture them again with the board "
                      "tilted differently in each"),
    QT_TRANSLATE_NOOP("library",
                      "the chessboard lies alike in all views, which leaves the focal length open; capture "
                      "chess00, chess01, … again with the board tilted differently in each"),
    QT_TRANSLATE_NOOP("library",
                      "the stripes and chessboards do not determine the device; capture the series again"),
    QT_TRANSLATE_NOOP(
        "library",
        "only %1 whole stripes of laser %2 are seen in %3; capture it again with a longer exposure"),
    QT_TRANSLATE_NOOP("library", "the central stripe of laser %1 is not seen in %2; capture it again"),
    QT_TRANSLATE_NOOP(
        "library",
        "no drawn lines are seen in laserFirstEstimates; capture the laser calibration plane again"),
    QT_TRANSLATE_NOOP("library",
                      "no stripes are seen in %1; is laser %2 on and the exposure right? Capture it again"),
    QT_TRANSLATE_NOOP("library",
                      "only %1 stripes are seen in %2; is laser %3 on and the exposure long enough?"),
    QT_TRANSLATE_NOOP(
        "library",
        "only %1 stripes of laser %2 are seen on the backplane; capture %3 again with a longer exposure"),
    QT_TRANSLATE_NOOP("library",
                      "only %1 stripes of laser %2 are seen on the calibration object; capture %3 again with "
                      "a longer exposure"),
    QT_TRANSLATE_NOOP(
        "library",
        "fewer than three stripes of laser %1 are seen at both distances; capture %2 and %3 again"),
    QT_TRANSLATE_NOOP("library",
                      "the stripes of laser %1 are not closer together on the calibration object than on the "
                      "backplane; are the Closer and Further images swapped?"),
    QT_TRANSLATE_NOOP(
        "library",
        "the chessboard under laser %1 does not lie higher on the calibration object than on the "
        "backplane; are the Closer and Further images swapped?"),
    QT_TRANSLATE_NOOP("library",
                      "the stripes of laser %1 on the backplane and on the calibration object do not belong "
                      "to one grating; are the Closer and Further images swapped?"),
    QT_TRANSLATE_NOOP("library", "too few points on the boxes under heights/ to fit the error correction"),
    QT_TRANSLATE_NOOP(
        "library",
        "the boxes under heights/ do not determine the error correction; at least three heights are needed"),
    QT_TRANSLATE_NOOP("library", "only a virtual device calibrates by itself; use the calibrate page"),
    QT_TRANSLATE_NOOP("library", "this device is not virtual"),
};
// NOLINTEND(bugprone-suspicious-missing-comma)

}  // namespace

std::span<const char* const> LibraryErrorsOfCaptures() { return kTexts; }

}  // namespace dorsum
