// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMutex>
#include <QMutexLocker>
#include <QString>
#include <QStringList>
#include <QtGlobal>

namespace dorsum {

// Collects what Qt says on the console as long as it lives. There is one at a time.
class ConsoleWatch {
 public:
  ConsoleWatch() {
    now_ = this;
    before_ = qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString& message) {
      const QMutexLocker lock(&now_->mutex_);
      now_->said_.append(message);
    });
  }
  ConsoleWatch(const ConsoleWatch&) = delete;
  ConsoleWatch& operator=(const ConsoleWatch&) = delete;
  ~ConsoleWatch() { qInstallMessageHandler(before_); }

  QStringList said() {
    const QMutexLocker lock(&mutex_);
    return said_;
  }

 private:
  inline static ConsoleWatch* now_ = nullptr;
  QtMessageHandler before_;
  QMutex mutex_;
  QStringList said_;
};

}  // namespace dorsum
