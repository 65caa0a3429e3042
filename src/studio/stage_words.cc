// SPDX-License-Identifier: Apache-2.0
#include "studio/stage_words.h"

#include <QLocale>
#include <cstdlib>

#include "studio/library_words.h"
#include "studio/stages_page.h"

namespace dorsum {
namespace {

QString WithDifference(std::size_t now, const std::size_t* before) {
  QString text = QLocale().toString(static_cast<qulonglong>(now));
  if (before == nullptr || *before == now) return text;
  const auto by = static_cast<qlonglong>(now) - static_cast<qlonglong>(*before);
  return QString("%1 (%2%3)")
      .arg(text, by > 0 ? "+" : QString(QChar(0x2212)), QLocale().toString(std::abs(by)));
}

}  // namespace

QString StageTitle(const std::string& key) {
  QString text = QString::fromStdString(key);
  const QString laser = text.section('/', 1, 1);
  if (key == "mask/difference") return StagesPage::tr("Mask: difference");
  if (key == "mask/threshold") return StagesPage::tr("Mask: threshold");
  if (key == "mask/coarse") return StagesPage::tr("Mask: coarse");
  if (key == "mask/mask") return StagesPage::tr("Mask");
  if (key == "mask/without_shadow") return StagesPage::tr("Mask: without shadow");
  if (key == "stripes/busy") return StagesPage::tr("Busy part");
  if (key == "heights") return StagesPage::tr("Heights");
  if (text.startsWith("orders/")) return StagesPage::tr("Laser %1: orders").arg(laser);
  if (text.startsWith("points/")) return StagesPage::tr("Laser %1: points").arg(laser);
  if (text.startsWith("stripes/") && text.endsWith("/edges"))
    return StagesPage::tr("Laser %1: edges").arg(laser);
  if (text.startsWith("stripes/") && text.endsWith("/mask"))
    return StagesPage::tr("Laser %1: stripes").arg(laser);
  if (text.startsWith("stripes/") && text.endsWith("/points"))
    return StagesPage::tr("Laser %1: stripe points").arg(laser);
  return text;
}

QString StageFigures(const ChainStages& now, const ChainStages* before) {
  if (now.error) {
    return StagesPage::tr("This chain ended early: %1. Take the last change back, or try other values.")
        .arg(InOwnWords(now.error->message));
  }
  return StagesPage::tr("%1 points, %2 faces, computed in %3 s")
      .arg(WithDifference(now.points, before != nullptr ? &before->points : nullptr),
           WithDifference(now.faces, before != nullptr ? &before->faces : nullptr),
           QLocale().toString(now.seconds, 'f', 2));
}

}  // namespace dorsum
