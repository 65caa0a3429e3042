// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>

#include "studio/surface_colours.h"
#include "studio/workbench.h"

class QWidget;

namespace dorsum {

// Writes surfaces and reads those to compare with, beside the window; what fails is said to the workbench.
class SurfaceFiles : public QObject {
  Q_OBJECT

 public:
  explicit SurfaceFiles(Workbench* workbench, QObject* parent = nullptr)
      : QObject(parent), workbench_(workbench) {}

  // The workbench's surface; for .png, `picture` of it.
  void Export(const std::filesystem::path& path, const QImage& picture);
  void ReadOther(const std::filesystem::path& path);  // a PLY file; HasOther() follows

  // Dialogs; empty where the person chose nothing.
  static std::filesystem::path AskForOther(QWidget* parent);
  static std::filesystem::path AskWhereTo(bool mesh, QWidget* parent);

 signals:
  void HasOther(std::shared_ptr<const dorsum::OtherHeight> other, const QString& name);

 private:
  bool Free();  // says so if not

  Workbench* workbench_;
};

}  // namespace dorsum
