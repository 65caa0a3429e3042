// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "jobs/campaign_add.h"
#include "jobs/campaign_create.h"
#include "jobs/campaign_export.h"
#include "jobs/campaign_remove.h"
#include "jobs/campaign_virtual.h"
#include "studio/campaign_view.h"
#include "studio/workbench.h"

namespace dorsum {

// The campaign that is open, and all that can be done with it: the jobs behind `dorsum campaign`, one at a
// time beside the window. What goes wrong is told by the workbench. No widgets.
class CampaignModel : public QObject {
  Q_OBJECT

 public:
  explicit CampaignModel(Workbench* workbench, QObject* parent = nullptr);

  const std::filesystem::path& dir() const { return dir_; }                  // empty: none is open
  const std::shared_ptr<const CampaignView>& view() const { return view_; }  // none: none is open
  bool busy() const { return workbench_->jobs().busy() || workbench_->device().busy(); }

  // Changed() follows each of these when it went well. A campaign that is open stays so until another one
  // could be read.
  void Open(const std::filesystem::path& dir);
  void Create(const CreateCampaignRequest& request);
  void CreateVirtual(const VirtualCampaignRequest& request);  // goes on with one that was interrupted
  void ContinueVirtual();                                     // of the campaign that is open
  void AddPerson(const CampaignPerson& person, bool correct);
  void Remove(const std::string& id);
  void RemoveCapture(const CampaignCapture& capture);
  // Captures with the open device. A campaign without a calibration gets that of the workbench, if there is
  // one.
  void Capture(const MissingCaptures& what);
  // The same from a capture folder.
  void Import(const MissingCaptures& what, const std::filesystem::path& capture);

  void Look(const CampaignCapture& capture);  // reconstructs it: the workbench's scan
  void Verify();                              // Verified() follows
  void Export(const ExportRequest& request);  // `dir` is filled in

  // The folder of the campaign that was open last, if it is still there; empty otherwise.
  static std::filesystem::path Last();

 signals:
  void Changed();                             // view()
  void Said(const QString& sentence);         // what was done
  void Warned(const QStringList& sentences);  // about what was done
  void Captured(const dorsum::MissingCaptures& what);

 private:
  template <class T>
  void Do(const QString& title, std::function<Result<T>(const Context&)> work, std::function<void(T)> done);
  bool Free();
  void Reload();
  AddCaptureRequest RequestFor(const MissingCaptures& what, const std::string& source) const;
  void Take(const MissingCaptures& what, const AddedCapture& added);

  Workbench* workbench_;
  std::filesystem::path dir_;
  std::shared_ptr<const CampaignView> view_;
  bool stale_ = false;  // view_ is to be read anew as soon as nothing else is done
};

}  // namespace dorsum
