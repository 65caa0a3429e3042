// SPDX-License-Identifier: Apache-2.0
#include "studio/job_runner.h"

#include <QMetaObject>
#include <exception>
#include <stdexcept>

#include "studio/progress_gate.h"

namespace dorsum {

JobRunner::~JobRunner() {
  Cancel();
  if (thread_.joinable()) thread_.join();
}

void JobRunner::Start(const QString& title, std::function<Report(const Context&)> work) {
  if (busy_) throw std::logic_error("JobRunner is busy");
  if (thread_.joinable()) thread_.join();
  busy_ = true;
  cancel_ = false;
  emit Started(title);
  thread_ = std::thread([this, work = std::move(work)] {
    Context context;
    context.cancel = &cancel_;
    context.progress = [this, gate = ProgressGate()](std::string_view stage, double fraction) mutable {
      if (!gate.Passes(stage)) return;
      const QString name = QString::fromUtf8(stage.data(), static_cast<qsizetype>(stage.size()));
      QMetaObject::invokeMethod(
          this, [this, name, fraction] { emit Progressed(name, fraction); }, Qt::QueuedConnection);
    };
    Report report = work(context);
    QMetaObject::invokeMethod(
        this,
        [this, report = std::move(report)] {
          busy_ = false;
          report();
          emit Finished();
        },
        Qt::QueuedConnection);
  });
}

}  // namespace dorsum
