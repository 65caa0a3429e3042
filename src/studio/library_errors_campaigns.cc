// SPDX-License-Identifier: Apache-2.0
#include <QCoreApplication>

#include "studio/library_texts.h"

namespace dorsum {
namespace {

// NOLINTBEGIN(bugprone-suspicious-missing-comma): long sentences are several literals
constexpr const char* kTexts[] = {
    // Campaigns (jobs/campaign_*.h).
    QT_TRANSLATE_NOOP("library", "there is no campaign in %1; dorsum campaign new makes one"),
    QT_TRANSLATE_NOOP("library", "%1 is a campaign already; add to it, or choose another folder"),
    QT_TRANSLATE_NOOP("library", "%1 is not an empty folder; choose another one for the campaign"),
    QT_TRANSLATE_NOOP("library",
                      "%1 is a campaign already, and another one than asked for; choose another folder, or "
                      "ask for the same device, seed, people and plan to go on with it"),
    QT_TRANSLATE_NOOP("library", "%1 is a campaign of virtual people; make another for real ones"),
    QT_TRANSLATE_NOOP("library", "%1 is a campaign of real people; virtual ones have their own"),
    QT_TRANSLATE_NOOP("library",
                      "this campaign's virtual device is described by a file; go on with dorsum campaign "
                      "new, --virtual and --device"),
    QT_TRANSLATE_NOOP("library", "a campaign's name has 1 to 100 characters, all of them printable"),
    QT_TRANSLATE_NOOP("library",
                      "a person's id is 1 to 32 letters a to z, digits, - and _, with at least one digit and "
                      "neither - nor _ in front: p01, never a name"),
    QT_TRANSLATE_NOOP(
        "library",
        "the consent date must be a day that exists, as 2024-05-31; without consent nothing is stored"),
    QT_TRANSLATE_NOOP("library", "the consent date %1 is before 1990"),
    QT_TRANSLATE_NOOP(
        "library", "the consent date %1 lies in the future (today is %2); without consent nothing is stored"),
    QT_TRANSLATE_NOOP("library",
                      "there is no person %1 in %2; add the person first, with the date of the consent"),
    QT_TRANSLATE_NOOP("library", "there is no person %1 in %2 to correct"),
    QT_TRANSLATE_NOOP("library", "there is no person %1 in %2"),
    QT_TRANSLATE_NOOP("library", "there is a person %1 in %2 already; choose another id"),
    QT_TRANSLATE_NOOP("library", "the person %1 was removed meanwhile; nothing was stored"),
    QT_TRANSLATE_NOOP("library", "the campaign's plan has no left hands"),
    QT_TRANSLATE_NOOP("library", "the campaign's plan has no right hands"),
    QT_TRANSLATE_NOOP("library", "the campaign's plan has sessions 1 to %1, not %2"),
    QT_TRANSLATE_NOOP("library", "the left hand of %1 has all %2 captures of session %3 already"),
    QT_TRANSLATE_NOOP("library", "the right hand of %1 has all %2 captures of session %3 already"),
    QT_TRANSLATE_NOOP(
        "library",
        "the left hand of %1 has all %2 captures of session %3; name the next session with --session"),
    QT_TRANSLATE_NOOP(
        "library",
        "the right hand of %1 has all %2 captures of session %3; name the next session with --session"),
    QT_TRANSLATE_NOOP("library", "there is no left capture %1 in session %2 of %3"),
    QT_TRANSLATE_NOOP("library", "there is no right capture %1 in session %2 of %3"),
    QT_TRANSLATE_NOOP("library", "%1 of %2 is in the campaign already, in %3; add each capture once"),
    QT_TRANSLATE_NOOP("library", "%1 is there, but no manifest names it; move it away"),
    QT_TRANSLATE_NOOP(
        "library",
        "%1 has a picture of laser %2, which the campaign's device does not have; a campaign has one device"),
    QT_TRANSLATE_NOOP(
        "library", "%1 is of a camera with %2 pixels, but the campaign's has %3; a campaign has one device"),
    QT_TRANSLATE_NOOP(
        "library", "%1 knows laser %2, which the campaign's device does not have; a campaign has one device"),
    QT_TRANSLATE_NOOP("library",
                      "%1 has no calibration, so that there is no surface of it; give the campaign the "
                      "device's with the next capture, and take this one again"),
    QT_TRANSLATE_NOOP("library", "%1 has no captures to export"),
    QT_TRANSLATE_NOOP("library", "%1 is not an empty folder; choose another one"),
    QT_TRANSLATE_NOOP("library", "%1 lies in the campaign; choose a folder outside"),
    QT_TRANSLATE_NOOP("library", "%1 is no calibration; restore it from a copy"),
    // What an examination of a campaign finds (jobs/campaign_verify.h).
    QT_TRANSLATE_NOOP("library",
                      "%1 was changed since dorsum wrote it: its checksum is wrong; restore it from a copy"),
    QT_TRANSLATE_NOOP("library", "%1 was changed since it was stored; restore it from a copy"),
    QT_TRANSLATE_NOOP("library", "%1 is missing; restore it from a copy"),
    QT_TRANSLATE_NOOP("library", "%1 has %2 bytes, but %3 were stored; restore it from a copy"),
    QT_TRANSLATE_NOOP("library", "%1 names a capture twice; restore it from a copy"),
    QT_TRANSLATE_NOOP("library", "%1; what else lies in its folder cannot be checked"),
    QT_TRANSLATE_NOOP(
        "library",
        "%1 was being added or removed when the command was killed; the next command that writes clears it"),
    QT_TRANSLATE_NOOP("library",
                      "%1 was left by a command that was killed; the next command that writes clears it"),
    QT_TRANSLATE_NOOP(
        "library", "%1 holds what is left of a person whose removal was interrupted; run the removal again"),
    QT_TRANSLATE_NOOP("library", "%1 is a virtual person in a campaign of the other kind"),
    QT_TRANSLATE_NOOP("library", "%1 is a real person in a campaign of the other kind"),
    QT_TRANSLATE_NOOP("library", "%1 is a session beyond the plan"),
    QT_TRANSLATE_NOOP("library", "%1 is a capture beyond the plan"),
    QT_TRANSLATE_NOOP("library", "%1 is a link; a campaign holds its files itself"),
    QT_TRANSLATE_NOOP("library", "%1 does not belong to the campaign; move it away"),
    QT_TRANSLATE_NOOP(
        "library",
        "without a calibration it cannot be told whether a hand is there and each laser is the right one"),
};
// NOLINTEND(bugprone-suspicious-missing-comma)

}  // namespace

std::span<const char* const> LibraryErrorsOfCampaigns() { return kTexts; }

}  // namespace dorsum
