// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "studio/hand_advice.h"
#include "studio/scan_words.h"
#include "studio/take_scan.h"
#include "studio/virtual_session.h"

namespace dorsum {

// The way of one hand through the scanner, for the page that shows it: live picture and advice, capture,
// surface, keep or repeat. No widgets.
class ScanModel : public QObject {
  Q_OBJECT

 public:
  static constexpr double kRest_s = 1.0;  // that a hand rests before it counts as ready

  explicit ScanModel(Workbench* workbench, QObject* parent = nullptr);

  ScanState state() const { return state_; }
  const HandView& view() const { return view_; }  // of the last live picture
  QString Sentence() const;                       // what the person should do, or what is being done

  // The page is looked at: the live picture runs while it is.
  void Activate();
  void Deactivate();

  void SetAutomatic(bool automatic);
  bool automatic() const { return automatic_; }

  void Scan();  // now, whatever the advice is
  void Cancel();
  void Keep();    // Kept() follows, or the workbench's Failed()
  void Repeat();  // back to the live picture; what was not kept is gone
  void Reconnect();

  // Pictures of a capture and the surface, in order; how many are done.
  const QStringList& steps() const { return steps_; }
  int steps_done() const { return steps_done_; }

  // The scan that is shown, and of it.
  const std::shared_ptr<const dorsum::Scan>& taken() const { return taken_; }
  const std::vector<FingerQuality>& fingers() const { return fingers_; }
  double wait_s() const { return wait_s_; }  // from the last frame until the surface was there

  std::filesystem::path folder() const { return folder_; }  // that captures are kept in
  void SetFolder(const std::filesystem::path& folder) { folder_ = folder; }

  // Of a virtual device only.
  bool is_virtual() const { return virtual_.is_open(); }
  void Place(const QString& scene) { virtual_.Place(scene); }
  void CalibrateVirtual();
  void SetCache(const std::filesystem::path& cache) { virtual_.SetCache(cache); }

 signals:
  void Changed();      // state, sentence or steps
  void ViewChanged();  // a live picture was looked at
  void Kept(const QString& folder);

 private:
  void Go(ScanState state);
  void GoLive();  // the state that fits device and calibration, with a live picture
  bool CalibrationFits() const;
  bool IsLive() const;
  void OnOpened();
  void OnFrame(const cv::Mat& picture);
  void OnViewed(HandView view);
  void OnProgress(const QString& stage);
  void OnTaken(Result<TakenScan> taken);
  void OnFailed(const Error& error);  // of a task

  Workbench* workbench_;
  VirtualSession virtual_;
  ScanState state_ = ScanState::kNoDevice;
  HandView view_;
  QString again_;  // why a picture is taken again
  QStringList steps_;
  int steps_done_ = 0;
  bool active_ = false, automatic_ = false;
  bool armed_ = true;  // the hand has moved since the last scan, so that another may start by itself
  std::shared_ptr<const dorsum::Scan> taken_;  // the workbench's may be another, opened meanwhile
  std::vector<FingerQuality> fingers_;
  double wait_s_ = 0.0;
  std::filesystem::path folder_;
  std::shared_ptr<HandAdvisor> advisor_;
  JobRunner looking_, saving_;  // last: they end first
};

}  // namespace dorsum
