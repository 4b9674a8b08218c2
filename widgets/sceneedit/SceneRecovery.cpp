// SPDX-License-Identifier: GPL-3.0-or-later
// SceneBench: unsaved texts that survive a crash.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <utility>

#include "robotlink/base/AtomicFile.h"
#include "widgets/RecoveryFile.h"
#include "widgets/sceneedit/SceneBench.h"

namespace widgets {

using robotlink::failure;
using robotlink::Result;

namespace {

constexpr int kTicksUntilScenesKept = 60;
constexpr std::size_t kMaxRecoveryBytes = 128U << 20U;

std::string recoveryText(const std::vector<SceneFile*>& files) {
  QJsonArray unsaved;
  for (const SceneFile* file : files) {
    if (!file->isChanged()) continue;
    unsaved << QJsonObject{{QStringLiteral("file"), QString::fromStdString(file->path().string())},
                           {QStringLiteral("name"), file->name()},
                           {QStringLiteral("text"), file->text()}};
  }
  const QJsonObject all{{QStringLiteral("version"), 1}, {QStringLiteral("scenes"), unsaved}};
  return QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

}  // namespace

void SceneBench::startRecovery(const std::filesystem::path& folder) {
  recovery_ = std::make_unique<RecoveryFile>(folder, ".scenes", [this](const robotlink::Error& error) {
    const QString reason = QString::fromStdString(error.describe());
    QMetaObject::invokeMethod(
        this, [this, reason] { Q_EMIT reported(tr("Changes cannot be backed up: %1").arg(reason), true); },
        Qt::QueuedConnection);
  });
  if (!recovery_->isLeft()) return;
  if (const auto restored = restore(recovery_->file()); !restored) {
    const QString reason = QString::fromStdString(restored.error().describe());
    const QString place = QString::fromStdString(recovery_->setAside().string());
    Q_EMIT reported(tr("Unsaved scenes could not be restored: %1; they are kept in %2").arg(reason, place),
                    true);
    return;
  }
  isKept_ = true;
  ticksUnkept_ = 0;
  Q_EMIT reported(tr("The program ended without saving last time. Unsaved scene files were restored in the "
                     "scene editor; save them to keep them."),
                  false);
}

Result<void> SceneBench::restore(const std::filesystem::path& file) {
  const auto text = robotlink::readFile(file, kMaxRecoveryBytes);
  if (!text) return tl::unexpected(text.error());
  const auto all = QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object();
  if (all.value(QStringLiteral("version")).toInt() != 1)
    return failure("scene.recovery", "the file is damaged", {file.string(), 0, 0});
  for (const QJsonValue& one : all.value(QStringLiteral("scenes")).toArray()) {
    const QJsonObject scene = one.toObject();
    startAnew(scene.value(QStringLiteral("text")).toString(),
              scene.value(QStringLiteral("file")).toString().toStdString(),
              scene.value(QStringLiteral("name")).toString());
  }
  return {};
}

void SceneBench::tickRecovery() {
  if (recovery_ == nullptr || ticksUnkept_ == 0 || ++ticksUnkept_ < kTicksUntilScenesKept) return;
  ticksUnkept_ = 0;
  if (hasUnsaved()) {
    isKept_ = true;
    recovery_->keep([text = recoveryText(files())](const std::filesystem::path& file) {
      return robotlink::writeFileAtomically(file, text);
    });
  } else if (std::exchange(isKept_, false)) {
    recovery_->drop();
  }
}

void SceneBench::keepNow() {
  if (recovery_ == nullptr) return;
  if (ticksUnkept_ > 0) ticksUnkept_ = kTicksUntilScenesKept;
  tickRecovery();
  recovery_->finish();
}

void SceneBench::forget() {
  if (std::exchange(isKept_, false) && recovery_ != nullptr) recovery_->drop();
  ticksUnkept_ = 0;
}

}  // namespace widgets
