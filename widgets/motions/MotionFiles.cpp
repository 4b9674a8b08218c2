// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motions/MotionFiles.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <algorithm>
#include <utility>

#include "robotcontrol/Motion.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"
#include "robotlink/motions/MotionImport.h"
#include "robotlink/motions/MotionLibrary.h"
#include "robotlink/motions/MotionWriter.h"
#include "widgets/RecoveryFile.h"
#include "widgets/motions/MotionBench.h"

namespace widgets {

using robotlink::failure;
using robotlink::Result;

namespace {

constexpr int kTicksUntilMotionKept = 60;

struct MotionFileText {
  Q_DECLARE_TR_FUNCTIONS(widgets::MotionFiles)
};
QString shownMotionPath(const std::filesystem::path& path) {
  return QString::fromStdString(path.string());
}

/// All errors of a file as one.
robotlink::Error joinedErrors(const robotlink::Errors& errors) {
  robotlink::Error all = errors.front();
  if (errors.size() > 1) all = {all.id, robotlink::describe(errors), {}, {}};
  return all;
}

}  // namespace

MotionFiles::MotionFiles(MotionBench& bench) : QObject(&bench), bench_(bench) {
  setObjectName(QStringLiteral("motionFiles"));
  connect(&bench, &MotionBench::changed, this, [this] {
    if (ticksUnkept_ == 0) ticksUnkept_ = 1;
  });
  connect(&bench.undoStack(), &QUndoStack::cleanChanged, this, &MotionFiles::titleChanged);
  connect(&bench, &MotionBench::changed, this, &MotionFiles::titleChanged);
  connect(qApp, &QCoreApplication::aboutToQuit, this, &MotionFiles::keepNow);
}

MotionFiles::~MotionFiles() = default;

bool MotionFiles::changed() const {
  return !bench_.undoStack().isClean();
}

QString MotionFiles::title() const {
  if (bench_.isEmpty()) return {};
  const QString motion = QString::fromStdString(bench_.motion().name);
  const QString name = !file_.empty()     ? shownMotionPath(file_.filename())
                       : motion.isEmpty() ? tr("unnamed")
                                          : tr("%1 (not saved)").arg(motion);
  return changed() && !file_.empty() ? name + QLatin1Char('*') : name;
}

std::filesystem::path MotionFiles::folder() const {
  return folder_.empty() ? robotlink::resource("motions") : folder_;
}

void MotionFiles::setMotion(std::string text, const std::filesystem::path& file, bool changed) {
  std::erase(text, '\r');  // lines end as editors of text here end them
  file_ = file;
  const std::string shown = file.empty() ? std::string() : file.string();
  bench_.setDocument(std::move(text), shown, changed);
  if (!changed) forget();
  Q_EMIT titleChanged();
}

Result<void> MotionFiles::startAnew(const std::string& name) {
  if (name.empty() || robotlink::motionNameOf(name + ".mof") != name)
    return failure("motion.bad-name", "a motion's name consists of letters, digits, '_' and '-'", {}, {name});
  bench_.tick();
  setMotion(robotlink::newMotion(name, bench_.document().joints()), {}, true);
  return {};
}

Result<void> MotionFiles::open(const std::filesystem::path& file) {
  std::error_code unknown;
  const auto whole = std::filesystem::absolute(file, unknown).lexically_normal();
  if (robotlink::isForeignMotion(whole)) {
    const auto motion = robotlink::importMotion(whole);
    if (!motion) return tl::unexpected(joinedErrors(motion.error()));
    setMotion(robotlink::writeMotion(*motion), {}, true);
    Q_EMIT reported(tr("Imported from %1; save it to keep it.").arg(shownMotionPath(whole.filename())),
                    false);
  } else {
    auto text = robotlink::readFile(whole, robotlink::MotionLibrary::kMaxTextBytes);
    if (!text) return tl::unexpected(text.error());
    setMotion(std::move(*text), whole, false);
  }
  folder_ = whole.parent_path();
  return {};
}

Result<void> MotionFiles::openFromRobot(const std::string& name) {
  bench_.tick();
  const auto* table = bench_.table();
  if (table != nullptr) {
    for (const auto& motion : table->motions()) {
      if (motion.name() != name) continue;
      setMotion(motion.text(), {}, false);
      return {};
    }
  }
  return failure(
      "motion.unknown",
      table == nullptr ? "the robot's program has published no motions" : "the robot has no motion " + name,
      {}, {name});
}

Result<void> MotionFiles::save() {
  if (!file_.empty()) return saveAs(file_);
  return failure("motion.no-file", "the motion has no file yet; name one: motion.save-as FILE");
}

Result<void> MotionFiles::saveAs(const std::filesystem::path& file) {
  if (bench_.isEmpty()) return failure("motion.none", "there is no motion to save");
  std::error_code unknown;
  const auto whole = std::filesystem::absolute(file, unknown).lexically_normal();
  if (robotlink::isForeignMotion(whole))
    return failure("motion.format", "motions are saved as .mof files", {whole.string(), 0, 0});
  if (const auto saved = robotlink::writeFileAtomically(whole, bench_.document().text()); !saved)
    return saved;
  file_ = whole;
  folder_ = whole.parent_path();
  bench_.setSaved(whole.string());
  forget();
  Q_EMIT titleChanged();
  Q_EMIT reported(tr("Saved: %1").arg(shownMotionPath(whole)), false);
  return {};
}

Result<void> MotionFiles::discardChanges() {
  if (!file_.empty()) return open(file_);
  setMotion({}, {}, false);
  return {};
}

void MotionFiles::forget() {
  if (std::exchange(isKept_, false)) recovery_->drop();
  ticksUnkept_ = 0;
}

void MotionFiles::startRecovery(const std::filesystem::path& folder) {
  recovery_ = std::make_unique<RecoveryFile>(folder, ".mof", [this](const robotlink::Error& error) {
    const QString reason = QString::fromStdString(error.describe());
    QMetaObject::invokeMethod(
        this, [this, reason] { Q_EMIT reported(tr("Changes cannot be backed up: %1").arg(reason), true); },
        Qt::QueuedConnection);
  });
  if (!recovery_->isLeft()) return;
  auto text = robotlink::readFile(recovery_->file(), robotlink::MotionLibrary::kMaxTextBytes);
  if (!text) {
    Q_EMIT reported(
        tr("An unsaved motion could not be restored: %1; it is kept in %2")
            .arg(QString::fromStdString(text.error().describe()), shownMotionPath(recovery_->setAside())),
        true);
    return;
  }
  setMotion(std::move(*text), {}, true);
  isKept_ = true;
  ticksUnkept_ = 0;
  Q_EMIT reported(
      tr("The program ended without saving last time. The unsaved motion %1 was restored; save it "
         "to keep it.")
          .arg(QString::fromStdString(bench_.motion().name)),
      false);
}

void MotionFiles::tick() {
  bench_.tick();
  if (recovery_ == nullptr || ticksUnkept_ == 0 || ++ticksUnkept_ < kTicksUntilMotionKept) return;
  ticksUnkept_ = 0;
  if (changed() && !bench_.isEmpty()) {
    isKept_ = true;
    recovery_->keep([text = bench_.document().text()](const std::filesystem::path& file) {
      return robotlink::writeFileAtomically(file, text);
    });
  } else if (std::exchange(isKept_, false)) {
    recovery_->drop();
  }
}

void MotionFiles::keepNow() {
  if (recovery_ == nullptr) return;
  if (ticksUnkept_ > 0) ticksUnkept_ = kTicksUntilMotionKept;
  tick();
  recovery_->finish();
}

MotionFiles& motionFiles(ViewContext& context) {
  MotionBench& bench = motionBench(context);
  auto* files = bench.findChild<MotionFiles*>(QString(), Qt::FindDirectChildrenOnly);
  return files != nullptr ? *files : *new MotionFiles(bench);
}

// ---- Dialogs

namespace {

/// Reports a failure. True: success.
bool reportFailure(MotionFiles& files, const Result<void>& result) {
  if (!result) Q_EMIT files.reported(QString::fromStdString(result.error().describe()), true);
  return result.has_value();
}

}  // namespace

bool saveMotion(MotionFiles& files, QWidget* parent) {
  return files.file().empty() ? saveMotionAs(files, parent) : reportFailure(files, files.save());
}

bool saveMotionAs(MotionFiles& files, QWidget* parent) {
  QFileDialog dialog(parent, MotionFileText::tr("Save motion"), shownMotionPath(files.folder()),
                     MotionFileText::tr("Motions (*.mof)"));
  dialog.setObjectName(QStringLiteral("saveMotionDialog"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("mof"));
  dialog.selectFile(QString::fromStdString(files.bench().motion().name) + QStringLiteral(".mof"));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return false;
  return reportFailure(files, files.saveAs(dialog.selectedFiles().first().toStdString()));
}

bool openMotion(MotionFiles& files, QWidget* parent) {
  if (!mayLoseMotion(files, parent)) return false;
  QFileDialog dialog(parent, MotionFileText::tr("Open motion"), shownMotionPath(files.folder()),
                     MotionFileText::tr("Motions (*.mof *.pos *.mot);;All files (*)"));
  dialog.setObjectName(QStringLiteral("openMotionDialog"));
  dialog.setFileMode(QFileDialog::ExistingFile);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return false;
  return reportFailure(files, files.open(dialog.selectedFiles().first().toStdString()));
}

bool mayLoseMotion(MotionFiles& files, QWidget* parent) {
  if (!files.changed() || files.bench().isEmpty()) return true;
  const QString name = QString::fromStdString(files.bench().motion().name);
  QMessageBox box(QMessageBox::Warning, MotionFileText::tr("Motion"),
                  MotionFileText::tr("The motion %1 was changed and not saved.").arg(name),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
  box.setObjectName(QStringLiteral("unsavedMotion"));
  box.setInformativeText(MotionFileText::tr("Save it?"));
  box.setDefaultButton(QMessageBox::Save);
  switch (box.exec()) {
    case QMessageBox::Save:
      return saveMotion(files, parent);
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

}  // namespace widgets
