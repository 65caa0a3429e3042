// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "studio/campaign_captures.h"
#include "studio/campaign_view.h"

class QLabel;
class QListView;
class QPushButton;

namespace dorsum {

class CampaignModel;
class CampaignTable;
class FittedPicture;
class Workbench;

// What is chosen in a campaign: its captures, and what can be done there. Asks before anything is lost.
class CampaignDetails : public QWidget {
  Q_OBJECT

 public:
  CampaignDetails(Workbench* workbench, CampaignModel* model, CampaignTable* table,
                  CampaignThumbnails* thumbnails, QWidget* parent);

  void Show(const QModelIndex& cell);  // of the table; invalid: nothing is chosen
  void Refresh();                      // what can be done now
  void Watch(bool watched);            // the live picture of the open device, under the LEDs

 private:
  QWidget* MakePersonButtons();
  QWidget* MakeCaptureButtons();
  static QPushButton* Button(const QString& text, const char* name, const QString& help, QWidget* parent);
  std::optional<MissingCaptures> Next() const;
  const CampaignPersonView* Person() const;
  const CampaignCapture* Chosen() const;  // of the captures
  QString NextWords() const;
  bool AnyVirtualMissing() const;
  void DoNext();
  void Import();
  void RemoveCapture();
  void RemovePerson();
  void Correct();
  void ShowLive();

  Workbench* workbench_;
  CampaignModel* model_;
  CampaignTable* table_;
  CampaignCaptures* captures_;
  CampaignPlace place_;
  bool watched_ = false;

  QLabel *title_, *next_words_;
  FittedPicture* live_;
  QListView* list_;
  QPushButton *next_, *import_, *look_, *remove_capture_, *correct_, *remove_person_;
};

}  // namespace dorsum
