// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneDialogs.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QMessageBox>
#include <QStandardPaths>

#include "widgets/sceneedit/NewSceneDialog.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneEdits.h"

namespace widgets {
namespace {

struct SceneDialogText {
  Q_DECLARE_TR_FUNCTIONS(widgets::SceneDialogs)
};

bool wasDone(SceneBench& bench, const robotlink::Result<void>& result) {
  if (!result) Q_EMIT bench.reported(QString::fromStdString(result.error().describe()), true);
  return result.has_value();
}

QString shownFolder(const SceneBench& bench) {
  return QString::fromStdString(bench.folder().string());
}

/// The folder for new scenes: that of other files of its author, not that of a shipped scene that happens
/// to run.
QString folderOfNewFiles(const SceneBench& bench) {
  for (const SceneFile* file : bench.files()) {
    if (!file->path().empty()) return QString::fromStdString(file->path().parent_path().string());
  }
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QDir(documents).exists() ? documents : QDir::homePath();
}

/// Asks whether to save changes. `save` saves them.
template <typename Save>
bool mayLose(const QString& what, QWidget* parent, Save save) {
  QMessageBox box(QMessageBox::Warning, SceneDialogText::tr("Scene"), what,
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
  box.setObjectName(QStringLiteral("unsavedScene"));
  box.setInformativeText(SceneDialogText::tr("Save the changes?"));
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

}  // namespace

bool newScene(SceneBench& bench, QWidget* parent) {
  const auto language = bench.context().sceneLanguage;
  if (language == nullptr) return false;
  NewSceneDialog dialog(*language, bench.folder() / "room.sdf", parent);
  if (dialog.exec() != QDialog::Accepted) return false;
  bench.startAnew(dialog.text(), {}, dialog.name() + QStringLiteral(".sdf"));
  // The user continues in the text.
  Q_EMIT bench.lineWanted(1);
  return true;
}

bool openScene(SceneBench& bench, QWidget* parent) {
  QFileDialog dialog(parent, SceneDialogText::tr("Open scene file"), shownFolder(bench),
                     SceneDialogText::tr("Scenes and models (*.sdf *.world *.xml *.map);;All files (*)"));
  dialog.setObjectName(QStringLiteral("openSceneDialog"));
  dialog.setFileMode(QFileDialog::ExistingFile);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return false;
  const auto opened = bench.open(dialog.selectedFiles().first().toStdString());
  return wasDone(bench, opened.map([](SceneFile*) {}));
}

bool saveScene(SceneBench& bench, QWidget* parent) {
  SceneFile* file = bench.current();
  if (file != nullptr && file->path().empty()) return saveSceneAs(bench, parent);
  if (file != nullptr && !mayOverwriteScene(bench, *file, parent)) return false;
  return wasDone(bench, bench.save());
}

bool saveSceneAs(SceneBench& bench, QWidget* parent) {
  if (bench.current() == nullptr) return false;
  const bool isNew = bench.current()->path().empty();
  QFileDialog dialog(parent, SceneDialogText::tr("Save scene file"),
                     isNew ? folderOfNewFiles(bench) : shownFolder(bench),
                     SceneDialogText::tr("Scenes and models (*.sdf *.world *.xml *.map);;All files (*)"));
  dialog.setObjectName(QStringLiteral("saveSceneDialog"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("sdf"));
  dialog.selectFile(bench.current()->name());
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return false;
  const std::filesystem::path path = dialog.selectedFiles().first().toStdString();
  std::error_code unknown;
  const bool isItself = std::filesystem::equivalent(path, bench.current()->path(), unknown);
  return isItself ? saveScene(bench, parent) : wasDone(bench, bench.saveAs(path));
}

bool saveAllScenes(SceneBench& bench, QWidget* parent) {
  const auto files = bench.files();
  for (SceneFile* file : files) {
    if (!file->isChanged()) continue;
    if (!file->path().empty()) {
      if (!mayOverwriteScene(bench, *file, parent)) return false;
      continue;
    }
    bench.setCurrent(file);
    if (!saveSceneAs(bench, parent)) return false;
  }
  return wasDone(bench, bench.saveAll());
}

bool mayOverwriteScene(SceneBench& bench, SceneFile& file, QWidget* parent) {
  if (!file.isChangedOutside()) return true;
  QMessageBox box(QMessageBox::Warning, SceneDialogText::tr("Scene"),
                  SceneDialogText::tr("The file %1 was changed by another program since it was read here.")
                      .arg(file.name()),
                  QMessageBox::Cancel, parent);
  box.setObjectName(QStringLiteral("sceneChangedOutside"));
  box.setInformativeText(
      SceneDialogText::tr("Overwrite it with the text of the editor, or reload it? Undo restores the text of "
                          "the editor."));
  const auto* overwrite = box.addButton(SceneDialogText::tr("Overwrite"), QMessageBox::DestructiveRole);
  const auto* again = box.addButton(SceneDialogText::tr("Read again"), QMessageBox::AcceptRole);
  box.setDefaultButton(QMessageBox::Cancel);
  box.exec();
  if (box.clickedButton() == overwrite) {
    file.allowOverwriting();
    return true;
  }
  return box.clickedButton() == again && wasDone(bench, sceneEdits(bench.context()).discard(file));
}

bool discardScene(SceneBench& bench, QWidget* parent) {
  SceneFile* file = bench.current();
  if (file == nullptr) return false;
  std::error_code unknown;
  if (!file->path().empty() && std::filesystem::exists(file->path(), unknown))
    return wasDone(bench, sceneEdits(bench.context()).discard(*file));
  if (!mayLoseScene(bench, parent)) return false;
  if (file->isChanged()) bench.close(*file);
  return true;
}

bool mayLoseScene(SceneBench& bench, QWidget* parent) {
  const SceneFile* file = bench.current();
  if (file == nullptr || !file->isChanged()) return true;
  return mayLose(SceneDialogText::tr("The scene file %1 was changed and not saved.").arg(file->name()),
                 parent, [&] { return saveScene(bench, parent); });
}

bool mayLoseScenes(SceneBench& bench, QWidget* parent) {
  if (!bench.hasUnsaved()) return true;
  QStringList names;
  for (const SceneFile* file : bench.files()) {
    if (file->isChanged()) names << file->name();
  }
  return mayLose(
      SceneDialogText::tr("Scene files were changed and not saved: %1").arg(names.join(QStringLiteral(", "))),
      parent, [&] { return saveAllScenes(bench, parent); });
}

}  // namespace widgets
