// SPDX-License-Identifier: Apache-2.0
#include "studio/campaign_removal.h"

#include <QCoreApplication>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

#include "studio/campaign_table.h"

namespace dorsum {
namespace {

class Removal {
  Q_DECLARE_TR_FUNCTIONS(Removal)
 public:
  static bool Ask(const QString& what, const QString& lost, QWidget* parent) {
    QMessageBox box(QMessageBox::Warning, tr("Remove"), what, QMessageBox::Cancel, parent);
    box.setInformativeText(lost);
    box.setObjectName("askToRemove");
    QPushButton* remove = box.addButton(tr("&Remove"), QMessageBox::DestructiveRole);
    remove->setObjectName("remove");
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == remove;
  }
};

}  // namespace

bool AskToRemoveCapture(const CampaignCapture& capture, QWidget* parent) {
  const QString what = Removal::tr("Remove %1, session %2, %3, capture %4?")
                           .arg(QString::fromStdString(capture.id))
                           .arg(capture.session)
                           .arg(HandTitle(capture.stored.hand))
                           .arg(capture.stored.number);
  const QString lost =
      Removal::tr("Its %n picture(s) are deleted for good. The next capture of this hand takes its number.",
                  nullptr, static_cast<int>(capture.stored.pictures.size()));
  return Removal::Ask(what, lost, parent);
}

bool AskToRemovePerson(const std::string& id, const std::vector<CampaignCapture>& captures, QWidget* parent) {
  std::uint64_t bytes = 0;
  for (const CampaignCapture& c : captures) {
    for (const StoredPicture& picture : c.stored.pictures) bytes += picture.bytes;
  }
  const QString lost =
      Removal::tr(
          "%n capture(s), %1 together, are deleted for good. The id and what was said of the "
          "person go too. Exports, surfaces and backups are not reached.",
          nullptr, static_cast<int>(captures.size()))
          .arg(QLocale().formattedDataSize(static_cast<qint64>(bytes)));
  return Removal::Ask(Removal::tr("Remove %1 from the campaign?").arg(QString::fromStdString(id)), lost,
                      parent);
}

}  // namespace dorsum
