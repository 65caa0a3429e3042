// SPDX-License-Identifier: Apache-2.0
#include "studio/campaign_model.h"

#include <QSettings>
#include <utility>

#include "jobs/campaign_capture.h"
#include "jobs/campaign_names.h"
#include "jobs/campaign_verify.h"
#include "studio/campaign_scan.h"
#include "studio/campaign_table.h"
#include "studio/library_words.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLastKey = "campaign/last";

QStringList ToTexts(const std::vector<std::string>& sentences) {
  QStringList texts;
  for (const std::string& sentence : sentences) texts << InOwnWords(sentence);
  return texts;
}

struct Done {};

}  // namespace

CampaignModel::CampaignModel(Workbench* workbench, QObject* parent) : QObject(parent), workbench_(workbench) {
  const auto catch_up = [this] {
    if (stale_ && !workbench_->jobs().busy()) Reload();
  };
  connect(&workbench->jobs(), &JobRunner::Finished, this, catch_up, Qt::QueuedConnection);
}

fs::path CampaignModel::Last() {
  const fs::path last = QSettings().value(kLastKey).toString().toStdString();
  std::error_code ec;
  return !last.empty() && fs::exists(last / kCampaignJson, ec) ? last : fs::path();
}

bool CampaignModel::Free() {
  if (!workbench_->jobs().busy()) return true;
  workbench_->Fail(UsageError("something else is being done; wait for it, or cancel it"));
  return false;
}

template <class T>
void CampaignModel::Do(const QString& title, std::function<Result<T>(const Context&)> work,
                       std::function<void(T)> done) {
  if (!Free()) return;
  workbench_->jobs().Run<T>(title, std::move(work), [this, done = std::move(done)](Result<T> result) {
    if (!result.ok()) return workbench_->Fail(result.error());
    done(std::move(result).value());
  });
}

void CampaignModel::Open(const fs::path& dir) {
  using View = std::shared_ptr<const CampaignView>;
  Do<View>(
      tr("Reading the campaign"), [dir](const Context& context) { return ReadCampaignView(dir, context); },
      [this, dir](const View& view) {
        dir_ = dir;
        view_ = view;
        stale_ = false;
        QSettings().setValue(kLastKey, QString::fromStdString(fs::absolute(dir).string()));
        emit Changed();
      });
}

void CampaignModel::Reload() {
  stale_ = !dir_.empty();
  if (stale_ && !workbench_->jobs().busy()) Open(dir_);
}

void CampaignModel::Create(const CreateCampaignRequest& request) {
  Do<Campaign>(
      tr("Making the campaign"),
      [request](const Context& context) { return CreateCampaign(request, context); },
      [this, dir = request.dir](const Campaign& campaign) {
        emit Said(
            tr("The campaign %1 is there. Add the first person.").arg(QString::fromStdString(campaign.name)));
        Open(dir);
      });
}

void CampaignModel::CreateVirtual(const VirtualCampaignRequest& request) {
  if (!Free()) return;
  workbench_->jobs().Run<VirtualCampaignSummary>(
      tr("Capturing virtual people"),
      [request](const Context& context) { return MakeVirtualCampaign(request, context); },
      [this, dir = request.dir](Result<VirtualCampaignSummary> summary) {
        if (summary.ok()) {
          emit Said(tr("%1 virtual people with %2 captures are there.")
                        .arg(summary->people)
                        .arg(summary->captures));
        } else {
          workbench_->Fail(summary.error());
        }
        // What was made before it was stopped is there too, and can be gone on with.
        std::error_code ec;
        if (fs::exists(dir / kCampaignJson, ec)) Open(dir);
      });
}

void CampaignModel::ContinueVirtual() {
  const Campaign& campaign = view_->status.campaign;
  if (!campaign.virtual_people || !campaign.virtual_people->device_sha256.empty()) {
    return workbench_->Fail(
        UsageError("this campaign's virtual device is described by a file; go on with dorsum campaign new, "
                   "--virtual and --device"));
  }
  VirtualCampaignRequest request;
  request.dir = dir_;
  request.name = campaign.name;
  request.plan = campaign.plan;
  request.plan.people = campaign.virtual_people->people;
  request.seed = campaign.virtual_people->seed;
  CreateVirtual(request);
}

void CampaignModel::AddPerson(const CampaignPerson& person, bool correct) {
  Do<Done>(
      tr("Adding a person"),
      [request = AddPersonRequest{dir_, person, correct, ""}](const Context& context) -> Result<Done> {
        DORSUM_RETURN_IF_ERROR(dorsum::AddPerson(request, context));
        return Done{};
      },
      [this, correct, id = QString::fromStdString(person.id)](Done) {
        emit Said(correct ? tr("What is said of %1 is corrected.").arg(id)
                          : tr("%1 belongs to the campaign now.").arg(id));
        Reload();
      });
}

void CampaignModel::Remove(const std::string& id) {
  Do<RemoveSummary>(
      tr("Removing a person"),
      [request = RemoveRequest{dir_, id, 0, std::nullopt}](const Context& context) {
        return RemoveFromCampaign(request, context);
      },
      [this](const RemoveSummary& summary) {
        emit Said(tr("Removed the person and %n capture(s). Exports, surfaces and backups are not reached.",
                     nullptr, summary.captures));
        Reload();
      });
}

void CampaignModel::RemoveCapture(const CampaignCapture& capture) {
  const CaptureKey key{capture.stored.hand, capture.stored.number};
  Do<RemoveSummary>(
      tr("Removing a capture"),
      [request = RemoveRequest{dir_, capture.id, capture.session, key}](const Context& context) {
        return RemoveFromCampaign(request, context);
      },
      [this, name = QString::fromStdString(capture.Name())](const RemoveSummary&) {
        emit Said(tr("Removed %1. The next capture of this hand takes its number.").arg(name));
        Reload();
      });
}

AddCaptureRequest CampaignModel::RequestFor(const MissingCaptures& what, const std::string& source) const {
  AddCaptureRequest request{dir_, what.id, what.hand, what.session, {}, source};
  if (view_->status.campaign.calibration.empty()) request.calibration = workbench_->calibration_path();
  return request;
}

void CampaignModel::Capture(const MissingCaptures& what) {
  if (!workbench_->device().facts()) {
    return workbench_->Fail(UsageError("no device is open; open one on the Device page, then capture"));
  }
  const AddCaptureRequest request = RequestFor(what, "the capture with the device");
  const auto work = [request](Device& device, const Context& context) -> Result<AddedCapture> {
    std::vector<std::string> warnings;
    DORSUM_ASSIGN_OR_RETURN(AddedCapture added,
                            AddCapture(request, CaptureWithDevice(&device, request, &warnings), context));
    added.warnings.insert(added.warnings.begin(), warnings.begin(), warnings.end());
    return added;
  };
  const QString title = tr("Capturing %1, session %2, %3")
                            .arg(QString::fromStdString(what.id))
                            .arg(what.session)
                            .arg(HandTitle(what.hand));
  workbench_->device().Run<AddedCapture>(title, work, [this, what](Result<AddedCapture> added) {
    if (!added.ok()) return workbench_->Fail(added.error());
    Take(what, *added);
  });
}

void CampaignModel::Import(const MissingCaptures& what, const fs::path& capture) {
  Do<AddedCapture>(
      tr("Taking over a capture"),
      [request = RequestFor(what, capture.string()), capture](const Context& context) {
        return AddCapture(request, ImportCapture(capture), context);
      },
      [this, what](const AddedCapture& added) { Take(what, added); });
}

void CampaignModel::Take(const MissingCaptures& what, const AddedCapture& added) {
  const CampaignCapture& c = added.capture;
  emit Said(tr("%1, session %2, %3: capture %4 of %5 is stored.")
                .arg(QString::fromStdString(c.id))
                .arg(c.session)
                .arg(HandTitle(c.stored.hand))
                .arg(c.stored.number)
                .arg(added.planned));
  emit Warned(ToTexts(added.warnings));
  emit Captured(what);
  Reload();
}

void CampaignModel::Look(const CampaignCapture& capture) {
  using Made = std::shared_ptr<const Scan>;
  Do<Made>(
      tr("Reconstructing %1").arg(QString::fromStdString(capture.Name())),
      [capture, dir = dir_](const Context& context) { return ScanOfCapture(capture, dir, context); },
      [this](const Made& scan) {
        emit Said(tr("%1 is on the pages Surface and Stages now.").arg(QString::fromStdString(scan->name)));
        workbench_->SetScan(scan);
      });
}

void CampaignModel::Verify() {
  Do<CampaignVerification>(
      tr("Verifying the campaign"),
      [dir = dir_](const Context& context) { return VerifyCampaign(dir, context); },
      [this](const CampaignVerification& found) {
        emit Said(
            found.findings.empty()
                ? tr("Verified: all %n file(s) are as they were stored.", nullptr, found.files)
                : tr("Verified: the campaign is not as it was stored, with %n finding(s). Bring back what is "
                     "missing or damaged from a copy of the folder, or remove the capture and take it again.",
                     nullptr, static_cast<int>(found.findings.size())));
        emit Warned(ToTexts(found.findings));
      });
}

void CampaignModel::Export(const ExportRequest& request) {
  ExportRequest wanted = request;
  wanted.dir = dir_;
  Do<ExportSummary>(
      tr("Exporting the campaign"),
      [wanted](const Context& context) { return ExportCampaign(wanted, context); },
      [this, out = QString::fromStdString(wanted.out_dir.string())](const ExportSummary& summary) {
        emit Said(tr("Exported %1 people with %2 captures to %3.")
                      .arg(summary.people)
                      .arg(summary.captures)
                      .arg(out));
        emit Warned(ToTexts(summary.warnings));
      });
}

}  // namespace dorsum
