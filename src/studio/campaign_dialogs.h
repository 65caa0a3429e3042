// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <filesystem>
#include <optional>

#include "jobs/campaign_create.h"
#include "jobs/campaign_export.h"
#include "jobs/campaign_virtual.h"
#include "studio/form_dialog.h"

class QCheckBox;
class QComboBox;
class QDateEdit;
class QSpinBox;

namespace dorsum {

// What a new campaign is to be.
class NewCampaignDialog : public FormDialog {
  Q_OBJECT

 public:
  // `calibration`: the one that is open, or empty.
  NewCampaignDialog(const std::filesystem::path& calibration, QWidget* parent);

  bool is_virtual() const;
  CreateCampaignRequest request() const;
  VirtualCampaignRequest virtual_request() const;

 private:
  QString FindProblem() const override;
  std::filesystem::path Dir() const;
  CampaignPlan Plan() const;

  std::filesystem::path calibration_;
  QLineEdit *name_, *parent_, *seed_;
  QSpinBox *people_, *sessions_, *captures_;
  QComboBox* hands_;
  QCheckBox *with_calibration_, *virtual_;
};

// Who a person is, as far as a campaign may know it.
class PersonDialog : public FormDialog {
  Q_OBJECT

 public:
  // `known`: the person whose data are to be corrected; none: a new one, whose id must not be among `taken`.
  PersonDialog(const std::optional<CampaignPerson>& known, QStringList taken, QWidget* parent);
  CampaignPerson person() const;

 private:
  QString FindProblem() const override;

  QStringList taken_;
  bool is_virtual_ = false;
  QLineEdit* id_;
  QComboBox *sex_, *age_;
  QCheckBox* signed_;
  QDateEdit* consent_;
};

// Where an export goes, and what it may tell.
class ExportDialog : public FormDialog {
  Q_OBJECT

 public:
  ExportDialog(const std::filesystem::path& campaign, QWidget* parent);
  ExportRequest request() const;  // without the campaign's folder

 private:
  QString FindProblem() const override;

  QLineEdit *name_, *parent_;
  QCheckBox* groups_;
  QSpinBox* least_;
};

}  // namespace dorsum
