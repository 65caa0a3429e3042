// SPDX-License-Identifier: Apache-2.0
#include "studio/main_window.h"

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "base/version.h"
#include "studio/banner.h"
#include "studio/calibrate_page.h"
#include "studio/campaign_page.h"
#include "studio/device_page.h"
#include "studio/language.h"
#include "studio/page_area.h"
#include "studio/scan_page.h"
#include "studio/stages_page.h"
#include "studio/surface_page.h"

namespace dorsum {
namespace {

constexpr int kSaid_ms = 10000;

}  // namespace

MainWindow::MainWindow(Workbench* workbench, QWidget* parent)
    : QMainWindow(parent),
      workbench_(workbench),
      list_(new QListWidget(this)),
      stack_(new QStackedWidget(this)),
      banner_(new Banner(this)),
      work_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setWindowTitle("Dorsum Studio");
  setAcceptDrops(true);
  resize(1240, 760);
  list_->setObjectName("pages");
  list_->setAccessibleName(tr("Pages"));
  list_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  auto* right = new QVBoxLayout;
  right->addWidget(banner_);
  right->addWidget(stack_, 1);
  auto* middle = new QWidget(this);
  auto* row = new QHBoxLayout(middle);
  row->addWidget(list_);
  row->addLayout(right, 1);
  setCentralWidget(middle);
  AddMenus();
  AddProgress();
  connect(list_, &QListWidget::currentRowChanged, this, [this](int now) {
    if (Page* before = page(stack_->currentIndex())) before->Leave();
    stack_->setCurrentIndex(now);
    if (Page* after = page(now)) after->Enter();
  });
  connect(workbench_, &Workbench::Failed, this, [this](const Error& error) {
    if (error.code != ErrorCode::kCancelled) banner_->Show(error);
  });
  connect(&workbench_->device(), &DeviceSession::Failed, this,
          [this](const Error& error) { banner_->Show(error); });
  AddPages();
  list_->setFixedWidth(list_->sizeHintForColumn(0) + 2 * list_->frameWidth() + 24);
  Restore();
}

// The order in which a person needs them.
void MainWindow::AddPages() {
  AddPage(tr("Scan"), tr("Scan a hand"), new ScanPage(workbench_, stack_));
  AddPage(tr("Surface"), tr("Look at a surface and measure it"), new SurfacePage(workbench_, stack_));
  AddPage(tr("Calibrate"), tr("Calibrate the device, or look at how well it is calibrated"),
          new CalibratePage(workbench_, stack_));
  AddPage(tr("Stages"), tr("See each step of the computation, the document's beside ours"),
          new StagesPage(workbench_, stack_));
  AddPage(tr("Campaign"), tr("Collect captures of many people, and see what is missing"),
          new CampaignPage(workbench_, stack_));
  AddPage(tr("Device"), tr("Open a device, switch its lights by hand, examine it"),
          new DevicePage(workbench_, stack_));
}

void MainWindow::AddPage(const QString& title, const QString& help, Page* page) {
  auto* item = new QListWidgetItem(title, list_);
  item->setToolTip(help);
  page->setAccessibleName(title);
  page->setAccessibleDescription(help);
  stack_->addWidget(new PageArea(page, stack_));
}

int MainWindow::pages() const { return stack_->count(); }
Page* MainWindow::page(int index) const {
  const auto* area = qobject_cast<PageArea*>(stack_->widget(index));
  return area == nullptr ? nullptr : qobject_cast<Page*>(area->widget());
}
void MainWindow::ShowPage(int index) { list_->setCurrentRow(index); }

void MainWindow::AddMenus() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  file->addAction(tr("&Open file…"), QKeySequence::Open, this, [this] { OpenWithDialog(false); });
  file->addAction(tr("Open &capture folder…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O), this,
                  [this] { OpenWithDialog(true); });
  file->addSeparator();
  file->addAction(tr("&Quit"), QKeySequence::Quit, this, &QWidget::close);
  AddLanguages();
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  help->addAction(tr("&About Dorsum Studio"), this, [this] {
    QMessageBox::about(this, tr("About Dorsum Studio"),
                       tr("Dorsum Studio %1: scans the back of a hand. Apache License 2.0.")
                           .arg(QString::fromLatin1(kVersion)));
  });
}

void MainWindow::AddLanguages() {
  QMenu* languages = menuBar()->addMenu(tr("&View"))->addMenu(tr("&Language"));
  languages->setObjectName("languages");
  auto* group = new QActionGroup(this);
  const auto add = [&](const QString& text, const QString& code) {
    QAction* action = languages->addAction(text, this, [this, code] {
      ChooseLanguage(code);
      statusBar()->showMessage(tr("The window speaks it from its next start on."), kSaid_ms);
    });
    action->setData(code);
    action->setCheckable(true);
    action->setChecked(code == ChosenLanguage());
    group->addAction(action);
  };
  add(tr("&As the desktop"), {});
  for (const Language& language : Languages()) add(language.name, language.code);
}

void MainWindow::AddProgress() {
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setMaximumWidth(220);
  progress_->setAccessibleName(tr("Progress"));
  cancel_->setObjectName("cancel");
  statusBar()->addPermanentWidget(work_);
  statusBar()->addPermanentWidget(progress_);
  statusBar()->addPermanentWidget(cancel_);
  const auto show = [this](bool shown) {
    for (QWidget* widget :
         {static_cast<QWidget*>(work_), static_cast<QWidget*>(progress_), static_cast<QWidget*>(cancel_)}) {
      widget->setVisible(shown);
    }
  };
  const auto started = [this, show](const QString& title) {
    work_->setText(title);
    progress_->setValue(0);
    show(true);
  };
  const auto progressed = [this](const QString&, double fraction) {
    progress_->setValue(static_cast<int>(1000.0 * fraction));
  };
  const auto finished = [this, show] { show(workbench_->jobs().busy() || workbench_->device().busy()); };
  show(false);
  connect(&workbench_->jobs(), &JobRunner::Started, this, started);
  connect(&workbench_->jobs(), &JobRunner::Progressed, this, progressed);
  connect(&workbench_->jobs(), &JobRunner::Finished, this, finished);
  connect(&workbench_->device(), &DeviceSession::TaskStarted, this, started);
  connect(&workbench_->device(), &DeviceSession::Progressed, this, progressed);
  connect(&workbench_->device(), &DeviceSession::TaskFinished, this, finished);
  connect(cancel_, &QPushButton::clicked, this, [this] {
    workbench_->jobs().Cancel();
    workbench_->device().Cancel();
  });
}

void MainWindow::OpenWithDialog(bool folder) {
  const QString path = folder ? QFileDialog::getExistingDirectory(this, tr("Open a capture folder"))
                              : QFileDialog::getOpenFileName(this, tr("Open a calibration or a surface"), {},
                                                             tr("Calibrations and surfaces (*.json *.ply)"));
  if (!path.isEmpty()) workbench_->OpenPath(path.toStdString());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile()) return workbench_->OpenPath(url.toLocalFile().toStdString());
  }
  workbench_->Fail(
      BadInput("what was dropped is no file of this machine; drop a capture folder or a PLY file"));
}

void MainWindow::closeEvent(QCloseEvent* event) {
  Remember();
  if (Page* now = page(stack_->currentIndex())) now->Leave();
  event->accept();
}

void MainWindow::Remember() {
  QSettings settings;
  settings.setValue("window/geometry", saveGeometry());
  settings.setValue("window/page", list_->currentRow());
  for (const QSplitter* split : stack_->findChildren<QSplitter*>()) {
    if (!split->objectName().isEmpty())
      settings.setValue("window/" + split->objectName(), split->saveState());
  }
}

void MainWindow::Restore() {
  const QSettings settings;
  restoreGeometry(settings.value("window/geometry").toByteArray());
  for (QSplitter* split : stack_->findChildren<QSplitter*>()) {
    if (split->objectName().isEmpty()) continue;
    const QByteArray state = settings.value("window/" + split->objectName()).toByteArray();
    if (!state.isEmpty()) split->restoreState(state);
  }
  const int row = settings.value("window/page", 0).toInt();
  if (list_->count() > 0) list_->setCurrentRow(row >= 0 && row < list_->count() ? row : 0);
}

}  // namespace dorsum
