// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

#include "base/context.h"
#include "base/result.h"

namespace dorsum {

// Runs one job at a time beside the window. Lives in the window's thread; everything it says, it says there.
class JobRunner : public QObject {
  Q_OBJECT

 public:
  explicit JobRunner(QObject* parent = nullptr) : QObject(parent) {}
  ~JobRunner() override;  // cancels what runs, and waits for it

  bool busy() const { return busy_; }

  // Calls `work` in a thread of its own with a context that reports here and that Cancel() cancels; then
  // `done` with its result in this object's thread. Not while busy: std::logic_error.
  template <class T>
  void Run(const QString& title, std::function<Result<T>(const Context&)> work,
           std::function<void(Result<T>)> done) {
    Start(title, [work = std::move(work), done = std::move(done)](const Context& context) {
      auto result = std::make_shared<Result<T>>(work(context));
      return [result, done] { done(std::move(*result)); };
    });
  }
  void Cancel() { cancel_ = true; }

 signals:
  void Started(const QString& title);
  void Progressed(const QString& stage, double fraction);  // fraction in [0, 1]
  void Finished();                                         // after `done`

 private:
  using Report = std::function<void()>;  // to be called in this object's thread
  void Start(const QString& title, std::function<Report(const Context&)> work);

  bool busy_ = false;
  std::atomic<bool> cancel_ = false;
  std::thread thread_;
};

}  // namespace dorsum
