// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>
#include <QSettings>
#include <memory>
#include <stdexcept>
#include <string>

#include "studio/banner.h"
#include "studio/console_watch_test.h"
#include "studio/main_window.h"
#include "studio/patience_test.h"
#include "studio/scan_fixture_studio_test.h"

namespace dorsum {

// The whole window with a workbench that can have the small virtual device.
class WindowTest : public ScanTest {
 protected:
  WindowTest() {
    QSettings().clear();
    window_ = std::make_unique<MainWindow>(&workbench_);
    window_->resize(1280, 800);
    window_->show();
  }
  template <class T>
  T* GoTo() {
    for (int i = 0; i < window_->pages(); ++i) {
      if (auto* page = qobject_cast<T*>(window_->page(i))) {
        window_->ShowPage(i);
        return page;
      }
    }
    throw std::runtime_error("the window has no such page");
  }
  template <class T>
  static T* Find(QWidget* page, const char* name) {
    T* found = page->findChild<T*>(name);
    if (found == nullptr) throw std::runtime_error(std::string("no widget ") + name);
    return found;
  }
  static void Click(QWidget* page, const char* name) {
    auto* button = Find<QAbstractButton>(page, name);
    if (!button->isVisible() || !button->isEnabled()) {
      throw std::runtime_error(std::string("nobody can press ") + name);
    }
    button->click();
  }
  static bool Until(const std::function<bool()>& done) {
    return QTest::qWaitFor(done, qEnvironmentVariableIsSet("DORSUM_SESSION_DEVICE") ? 900000 : kPatience_ms);
  }
  bool Rests() {
    return Until([&] { return !workbench_.jobs().busy() && !workbench_.device().busy(); });
  }
  std::string Said() { return window_->findChild<Banner*>("banner")->text().toStdString(); }

  ConsoleWatch console_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace dorsum
