// SPDX-License-Identifier: GPL-3.0-or-later
// The presets of DebugKeysView: named sets of keys in files.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <map>

#include "robotlink/base/Resources.h"
#include "robotlink/session/KeyModes.h"
#include "robotlink/session/Presets.h"
#include "widgets/keys/DebugKeysView.h"

namespace widgets {

using robotlink::Preset;

namespace {

// Name of a shipped preset; unset for the user's own.
constexpr int kShippedRole = Qt::UserRole;

robotlink::Presets presets() {
  return robotlink::Presets(robotlink::userDirectory() / "presets");
}

robotlink::Presets shippedPresets() {
  return robotlink::Presets(robotlink::resource("presets"));
}

/// The names of those that have keys, or cannot be read.
std::vector<std::string> namesIn(const robotlink::Presets& known) {
  std::vector<std::string> names = known.names();
  std::erase_if(names, [&](const std::string& name) {
    const auto preset = known.load(name);
    return preset && !preset->parts[Preset::kKeys];
  });
  return names;
}

}  // namespace

void DebugKeysView::listPresets() {
  const QString name = presets_->currentText();
  presets_->clear();
  for (const std::string& known : namesIn(presets())) presets_->addItem(QString::fromStdString(known));
  for (const std::string& known : namesIn(shippedPresets())) {
    const QString shipped = QString::fromStdString(known);
    presets_->addItem(tr("%1 (shipped)").arg(shipped), shipped);
  }
  presets_->setCurrentIndex(presets_->findText(name));
  presets_->setEditText(name);
}

QString DebugKeysView::shippedName() const {
  return presets_->itemData(presets_->findText(presets_->currentText()), kShippedRole).toString();
}

void DebugKeysView::notify(const QString& notice) {
  notice_ = notice;
  showState();
}

void DebugKeysView::loadPreset(const QString& name) {
  const QString shipped = shippedName();
  const auto preset =
      shipped.isEmpty() ? presets().load(name.toStdString()) : shippedPresets().load(shipped.toStdString());
  if (!preset) return notify(QString::fromStdString(preset.error().describe()));
  std::map<std::string, KeyValue> wanted;
  for (const auto& [key, mode] : preset->parts[Preset::kKeys].value_or(Preset::Values()))
    wanted[key] = keyValue(*robotlink::keyModeOf(mode));
  const std::vector<KeyEntry> keys = model_.keys();
  for (const KeyEntry& key : keys) {
    const auto found = wanted.find(key.name);
    const KeyValue value = found == wanted.end() ? KeyValue{} : found->second;
    if (model_.shownValue(key) != value) model_.choose(key.name, value);
  }
  notify(tr("Switched to the preset %1.").arg(name));
}

void DebugKeysView::savePreset() {
  Preset::Values keys;
  for (const KeyEntry& key : model_.keys()) {
    const KeyValue value = model_.shownValue(key);
    if (value.kind == KeyValue::Kind::kOff) continue;
    robotcontrol::KeyMode mode;
    assign(mode, value);
    keys[key.name] = robotlink::inWords(mode);
  }
  const QString name = presets_->currentText().trimmed();
  if (const QString shipped = shippedName(); name.isEmpty() || !shipped.isEmpty()) {
    presets_->lineEdit()->setFocus();
    presets_->lineEdit()->selectAll();
    return notify(
        name.isEmpty()
            ? tr("Type a name for the preset, then save.")
            : tr("%1 is a shipped preset and stays as it is. Type another name, then save.").arg(shipped));
  }
  // The other parts of a preset of this name stay.
  Preset preset = presets().load(name.toStdString()).value_or(Preset());
  preset.parts[Preset::kKeys] = keys;
  const auto saved = presets().save(name.toStdString(), preset);
  listPresets();
  notify(saved ? tr("Saved the preset %1 (keys that are on: %2).").arg(name, QString::number(keys.size()))
               : QString::fromStdString(saved.error().describe()));
}

void DebugKeysView::removePreset() {
  const QString name = presets_->currentText().trimmed();
  if (const QString shipped = shippedName(); !shipped.isEmpty()) {
    return notify(tr("%1 is a shipped preset and cannot be deleted.").arg(shipped));
  }
  const auto removed = presets().remove(name.toStdString());
  if (removed) presets_->setEditText({});
  listPresets();
  if (removed) presets_->setEditText({});
  notify(removed ? tr("Deleted the preset %1.").arg(name)
                 : QString::fromStdString(removed.error().describe()));
}

}  // namespace widgets
