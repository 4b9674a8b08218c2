// SPDX-License-Identifier: GPL-3.0-or-later
// The part of DebugKeysView that keeps sets of keys under names.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <map>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/session/KeyPresets.h"
#include "widgets/DebugKeysView.h"

namespace widgets {
namespace {

robotlink::KeyPresets presets() {
  return robotlink::KeyPresets(robotlink::userDirectory() / "presets");
}

}  // namespace

void DebugKeysView::listPresets() {
  const QString name = presets_->currentText();
  presets_->clear();
  for (const std::string& known : presets().names()) presets_->addItem(QString::fromStdString(known));
  presets_->setCurrentIndex(presets_->findText(name));
  presets_->setEditText(name);
}

void DebugKeysView::loadPreset(const QString& name) {
  const auto preset = presets().load(name.toStdString());
  if (!preset) {
    state_->setText(QString::fromStdString(preset.error().describe()));
    return;
  }
  std::map<std::string, KeyValue> wanted;
  for (const auto& key : preset->keys()) wanted[key.name()] = keyValue(key.mode());
  const std::vector<KeyEntry> keys = model_.keys();
  for (const KeyEntry& key : keys) {
    const auto found = wanted.find(key.name);
    const KeyValue value = found == wanted.end() ? KeyValue{} : found->second;
    if (model_.shownValue(key) != value) model_.choose(key.name, value);
  }
  state_->setText(tr("Switched to the preset %1").arg(name));
}

void DebugKeysView::savePreset() {
  robotcontrol::KeyTable table;
  for (const KeyEntry& key : model_.keys()) {
    const KeyValue value = model_.shownValue(key);
    if (value.kind == KeyValue::Kind::kOff) continue;
    auto& saved = *table.add_keys();
    saved.set_name(key.name);
    assign(*saved.mutable_mode(), value);
  }
  const QString name = presets_->currentText().trimmed();
  if (name.isEmpty()) {
    presets_->lineEdit()->setFocus();
    state_->setText(tr("Type a name for the preset, then save."));
    return;
  }
  const auto saved = presets().save(name.toStdString(), table);
  state_->setText(saved ? tr("Saved the preset %1").arg(name)
                        : QString::fromStdString(saved.error().describe()));
  listPresets();
}

void DebugKeysView::removePreset() {
  const QString name = presets_->currentText().trimmed();
  const auto removed = presets().remove(name.toStdString());
  if (removed) presets_->setEditText({});
  listPresets();
  if (removed) presets_->setEditText({});
  state_->setText(removed ? tr("Deleted the preset %1").arg(name)
                          : QString::fromStdString(removed.error().describe()));
}

}  // namespace widgets
