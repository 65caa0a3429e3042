// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/campaign_model.h"
#include "studio/campaign_thumbnails.h"
#include "studio/page.h"

class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;

namespace dorsum {

class CampaignDetails;
class CampaignPeople;
class CampaignTable;

// A campaign: people, hands and sessions with their pictures, what is missing, and the captures that make it
// whole.
class CampaignPage : public Page {
  Q_OBJECT

 public:
  CampaignPage(Workbench* workbench, QWidget* parent);

  void Enter() override;
  void Leave() override;

  CampaignModel* model() { return &model_; }
  const CampaignPlace& chosen() const { return place_; }

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;  // the folder of a campaign
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* MakeEmpty();
  QWidget* MakeHeader();
  static QPushButton* Button(const QString& text, const char* name, const QString& help, QWidget* parent);
  void Open();
  void New();
  void AddPerson();
  void Export();
  void ShowView();
  void Refresh();

  CampaignModel model_;
  CampaignThumbnails thumbnails_;
  CampaignPlace place_;
  bool entered_before_ = false;
  bool go_on_ = false;  // to what is missing next of the same person, as soon as the table is up to date

  CampaignTable* table_;
  CampaignPeople* people_;
  CampaignDetails* details_;
  QStackedWidget* stack_;
  QLabel *summary_, *said_;
  QListWidget* warnings_;
  QPushButton *verify_, *export_;
};

}  // namespace dorsum
