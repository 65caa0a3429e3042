// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_files.h"

#include <QBuffer>
#include <QFileDialog>
#include <utility>

#include "base/files.h"
#include "studio/surface_export.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

Status WritePicture(const QImage& picture, const fs::path& path) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (!buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "PNG")) {
    return Error{ErrorCode::kInternal, "the view could not be made a picture"};
  }
  return WriteFile(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace

fs::path SurfaceFiles::AskForOther(QWidget* parent) {
  return QFileDialog::getOpenFileName(parent, tr("Compare with a surface"), {}, tr("Surfaces (*.ply)"))
      .toStdString();
}

fs::path SurfaceFiles::AskWhereTo(bool mesh, QWidget* parent) {
  QFileDialog dialog(parent, tr("Export"), {},
                     mesh ? tr("PLY (*.ply);;OBJ (*.obj);;STL (*.stl);;GLB (*.glb);;Picture (*.png)")
                          : tr("PLY (*.ply);;Picture (*.png)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("ply");
  connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
    dialog.setDefaultSuffix(filter.section("*.", 1).section(')', 0, 0));
  });
  if (dialog.exec() != QDialog::Accepted) return {};
  return dialog.selectedFiles().front().toStdString();
}

bool SurfaceFiles::Free() {
  if (!workbench_->jobs().busy()) return true;
  workbench_->Fail(UsageError("something else is being done; wait for it, or cancel it"));
  return false;
}

void SurfaceFiles::ReadOther(const fs::path& path) {
  if (!Free()) return;
  workbench_->jobs().Run<std::shared_ptr<const OtherHeight>>(
      tr("Reading %1").arg(QString::fromStdString(path.filename().string())),
      [path](const Context&) -> Result<std::shared_ptr<const OtherHeight>> {
        DORSUM_ASSIGN_OR_RETURN(const std::shared_ptr<const Scan> other, ReadSurface(path));
        return std::make_shared<const OtherHeight>(MakeOtherHeight(other->surface));
      },
      [this, path](Result<std::shared_ptr<const OtherHeight>> other) {
        if (!other.ok()) return workbench_->Fail(other.error());
        emit HasOther(*other, QString::fromStdString(path.filename().string()));
      });
}

void SurfaceFiles::Export(const fs::path& path, const QImage& picture) {
  const std::shared_ptr<const Scan> scan = workbench_->scan();
  if (!scan) return workbench_->Fail(UsageError("there is no surface to export; scan or open one first"));
  if (!Free()) return;
  workbench_->jobs().Run<bool>(
      tr("Writing %1").arg(QString::fromStdString(path.filename().string())),
      [path, picture, scan](const Context&) -> Result<bool> {
        DORSUM_RETURN_IF_ERROR(path.extension() == ".png" ? WritePicture(picture, path)
                                                          : ExportSurface(scan->surface, path));
        return true;
      },
      [this](const Result<bool>& written) {
        if (!written.ok()) workbench_->Fail(written.error());
      });
}

}  // namespace dorsum
