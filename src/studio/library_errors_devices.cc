// SPDX-License-Identifier: Apache-2.0
#include <QCoreApplication>

#include "studio/library_texts.h"

namespace dorsum {
namespace {

// NOLINTBEGIN(bugprone-suspicious-missing-comma): long sentences are several literals
constexpr const char* kTexts[] = {
    // Names of things that sentences hold.
    QT_TRANSLATE_NOOP("library", "the camera %1"),
    QT_TRANSLATE_NOOP("library", "the stream %1"),
    QT_TRANSLATE_NOOP("library", "the recording %1"),
    QT_TRANSLATE_NOOP("library", "light controller on %1"),
    // Cameras (device/video_input.h, device/camera_source.h, device/still_picture.h).
    QT_TRANSLATE_NOOP("library", "there is no camera under /dev/video; connect one, or set camera.source"),
    QT_TRANSLATE_NOOP("library", "none of the cameras can be used: %1 %2"),
    QT_TRANSLATE_NOOP("library",
                      "cannot be opened: %1; add yourself to the group \"video\" (sudo usermod -aG video "
                      "$USER) and log in again"),
    QT_TRANSLATE_NOOP("library", "cannot be opened: %1; close the other program that uses it"),
    QT_TRANSLATE_NOOP("library", "cannot be opened: %1; unplug it and plug it in"),
    QT_TRANSLATE_NOOP("library", "does not answer as a camera; unplug it and plug it in"),
    QT_TRANSLATE_NOOP("library",
                      "the camera source \"%1\" is none: give a number, /dev/videoN, http://…, a video file "
                      "or a folder that exists, or virtual[:SEED]"),
    QT_TRANSLATE_NOOP("library",
                      "%1 cannot be opened: %2; add yourself to the group \"video\" and log in again"),
    QT_TRANSLATE_NOOP("library", "%1 cannot be opened: %2; close the other program that uses it"),
    QT_TRANSLATE_NOOP("library", "%1 cannot be opened: %2; check that it is connected"),
    QT_TRANSLATE_NOOP("library", "%1 cannot be opened; check that it is connected"),
    QT_TRANSLATE_NOOP("library",
                      "%1 cannot be opened as a camera; close other programs that use it, or choose another "
                      "one with camera.source"),
    QT_TRANSLATE_NOOP("library", "%1 is no video that can be read, or it is damaged; record it again"),
    QT_TRANSLATE_NOOP(
        "library",
        "%1 did not answer within %2; check the address, and that the camera is on and in the network"),
    QT_TRANSLATE_NOOP("library",
                      "%1 cannot be opened; check the address, and that the camera is on and in the network"),
    QT_TRANSLATE_NOOP("library", "%1 is gone; check its cable and plug it in again"),
    QT_TRANSLATE_NOOP("library", "%1 is gone; check that the camera is on and connected, and start again"),
    QT_TRANSLATE_NOOP(
        "library",
        "%1 was closed by the other side; check that the camera is on and connected, and start again"),
    QT_TRANSLATE_NOOP("library",
                      "%1 stopped sending pictures: none came for %2; check its cable and plug it in again"),
    QT_TRANSLATE_NOOP("library", "%1 is cut off after %2 frames of %3; copy or record it again"),
    QT_TRANSLATE_NOOP("library", "%1 is cut off after 1 frame of %2; copy or record it again"),
    QT_TRANSLATE_NOOP("library", "%1 has ended after %2 frames; record more, or begin again"),
    QT_TRANSLATE_NOOP("library", "%1 has ended after 1 frame; record more, or begin again"),
    QT_TRANSLATE_NOOP("library", "%1 has no more images after %2; record more, or begin again"),
    QT_TRANSLATE_NOOP("library", "there is no PNG or JPEG image in %1 to take for a camera's"),
    QT_TRANSLATE_NOOP("library", "%1 has no picture under these lights together"),
    QT_TRANSLATE_NOOP("library", "%1 failed: %2; start again"),
    QT_TRANSLATE_NOOP("library",
                      "%1 is damaged or cut off at frame %2, counted from 0; copy or record it again"),
    QT_TRANSLATE_NOOP("library",
                      "%1 sends damaged pictures only; check its cable, or choose a lower resolution or "
                      "another stream_format"),
    QT_TRANSLATE_NOOP(
        "library",
        "%1 sends pictures of %2 pixels, but %3 is expected; set camera.resolution_px to what it can do"),
    QT_TRANSLATE_NOOP("library", "%1 sent a picture of %2 pixels instead of %3; start again"),
    QT_TRANSLATE_NOOP(
        "library",
        "%1 gave no picture within %2; check that it is connected and that no other program uses it"),
    QT_TRANSLATE_NOOP(
        "library",
        "%1 sent no picture within %2; check that it is connected and that no other program uses it"),
    QT_TRANSLATE_NOOP("library", "%1 sent no picture within %2; check that it is connected"),
    QT_TRANSLATE_NOOP("library",
                      "%1 sent only %2 picture(s) after the light changed, within %3; it is too slow: "
                      "shorten the exposure or give it more time"),
    QT_TRANSLATE_NOOP("library",
                      "%1 is frozen: it sends the same picture again and again; unplug it and plug it in"),
    QT_TRANSLATE_NOOP("library", "%1 hangs: its exposure cannot be set; plug it in again"),
    QT_TRANSLATE_NOOP(
        "library",
        "the picture of %1 did not settle within %2: frames still differ by %3 grey levels; keep the hand "
        "still, shade other lights, and set a fixed exposure (camera.laser_exposure_s and led_exposure_s)"),
    QT_TRANSLATE_NOOP("library", "the camera did not take %1 %2; it is %3"),
    QT_TRANSLATE_NOOP("library", "the camera did not take %1 %2: it has no such control"),
    QT_TRANSLATE_NOOP("library",
                      "the camera chooses its exposure itself, so pictures may not be comparable; set "
                      "camera.laser_exposure_s and camera.led_exposure_s"),
    QT_TRANSLATE_NOOP(
        "library",
        "cameras need %1, which is missing or cannot be loaded; install Dorsum again, with OpenCV's videoio"),
    // The light controller (device/serial_port.h, device/controller_link.h, device/serial_lights.h).
    QT_TRANSLATE_NOOP("library",
                      "there is no port %1; plug the light controller in, or correct controller.port in the "
                      "device description"),
    QT_TRANSLATE_NOOP("library",
                      "no permission to use %1; join the group dialout (sudo usermod -aG dialout $USER, then "
                      "log in anew) or add the udev rule of docs/light-controller.md"),
    QT_TRANSLATE_NOOP("library", "%1 is in use by another program; close that first"),
    QT_TRANSLATE_NOOP("library", "%1 is no serial port; name the light controller's as controller.port"),
    QT_TRANSLATE_NOOP("library", "cannot open %1: %2; unplug the light controller and plug it in again"),
    QT_TRANSLATE_NOOP("library",
                      "no serial port runs at %1 baud; set controller.baud to 115200, the firmware's"),
    QT_TRANSLATE_NOOP(
        "library",
        "the light controller on %1 is gone; check its cable and plug it in again, then start over"),
    QT_TRANSLATE_NOOP("library",
                      "the light controller on %1 speaks protocol %2 (firmware %3), this program protocol "
                      "%4; flash the firmware that belongs to this program (scripts/firmware)"),
    QT_TRANSLATE_NOOP("library",
                      "what is on %1 talks, but not as a light controller; check controller.port and "
                      "controller.baud, or flash the firmware (scripts/firmware)"),
    QT_TRANSLATE_NOOP("library",
                      "no answer from a light controller on %1; check controller.port, cable and power, or "
                      "flash the firmware (scripts/firmware)"),
    QT_TRANSLATE_NOOP("library",
                      "the light controller on %1 has restarted in the middle, which switched its lights "
                      "off; check its power and cable"),
    QT_TRANSLATE_NOOP(
        "library",
        "the light controller on %1 does not answer any more; check its cable and power, then start over"),
    QT_TRANSLATE_NOOP("library",
                      "the light controller on %1 has firmware of %2 logic, but the device description says "
                      "%3; flash the other firmware or correct the description (docs/light-controller.md)"),
    QT_TRANSLATE_NOOP("library",
                      "the light controller on %1 does not tell its limits; flash the firmware that belongs "
                      "to this program (scripts/firmware)"),
    QT_TRANSLATE_NOOP("library",
                      "there is no serial port of a USB device; plug the light controller in, or name its "
                      "port as controller.port in the device description"),
    QT_TRANSLATE_NOOP("library", "no light controller on any of %1 (%2)"),
    QT_TRANSLATE_NOOP("library",
                      "the device description asks for channel %1, but the %2 has 0 to %3; correct the "
                      "channels in the device description"),
    QT_TRANSLATE_NOOP(
        "library",
        "the %1 found channel %2 not held off by its resistor when it started, so it does not drive it; "
        "check the wiring, and that the firmware's logic is the circuit's (docs/light-controller.md)"),
    QT_TRANSLATE_NOOP("library",
                      "the %1 did not switch its lights as it was told (%2); check its cable and power"),
    QT_TRANSLATE_NOOP("library",
                      "the %1 switched its lights off while a picture was taken; it was reset, or its time "
                      "limit is shorter than the camera needs"),
    // Findings of the examination that come of errors (jobs/doctor.h).
    QT_TRANSLATE_NOOP("library", "see the report beside %1"),
    QT_TRANSLATE_NOOP("library", "set it in device.toml to what the camera can do"),
    QT_TRANSLATE_NOOP("library", "%1 can be used"),
    QT_TRANSLATE_NOOP("library", "sudo usermod -aG dialout $USER, then log in again"),
    QT_TRANSLATE_NOOP("library",
                      "%1, firmware %2: all off after %3 s without a word from here, a laser after %4 s"),
    QT_TRANSLATE_NOOP("library", "%1, %2 x %3 pixels"),
};
// NOLINTEND(bugprone-suspicious-missing-comma)

}  // namespace

std::span<const char* const> LibraryErrorsOfDevices() { return kTexts; }

}  // namespace dorsum
