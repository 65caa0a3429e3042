// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMainWindow>
#include <QStringList>

#include "studio/page.h"

class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace dorsum {

class Banner;

// The window: pages at the left, the chosen one beside them, a banner for what went wrong above it, and the
// work that is being done below it. Remembers its size and page; opens what is dropped on it.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(Workbench* workbench, QWidget* parent = nullptr);

  Workbench* workbench() const { return workbench_; }
  int pages() const;
  Page* page(int index) const;
  void ShowPage(int index);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void AddPage(const QString& title, const QString& help, Page* page);
  void AddPages();
  void AddMenus();
  void AddLanguages();
  void AddProgress();
  void OpenWithDialog(bool folder);
  void Remember();
  void Restore();

  Workbench* workbench_;
  QListWidget* list_;
  QStackedWidget* stack_;
  Banner* banner_;
  QLabel* work_;
  QProgressBar* progress_;
  QPushButton* cancel_;
};

}  // namespace dorsum
