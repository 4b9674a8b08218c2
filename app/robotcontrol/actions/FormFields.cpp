// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/FormFields.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>

#include "app/robotcontrol/actions/FieldEditor.h"
#include "widgets/Theme.h"

namespace app {

FormFields::FormFields(const PlatformForm& form, QBoxLayout& layout, QWidget* parent)
    : QObject(parent), form_(form), layout_(layout), parent_(parent) {
  for (const PlatformField& field : form_.fields) {
    if (field.isShown) add(field);
  }
}

FormFields::~FormFields() = default;

QFormLayout& FormFields::groupLayout(const std::string& title) {
  QFormLayout*& known = groups_[title];
  if (known != nullptr) return *known;
  if (title.empty()) {
    known = new QFormLayout;
    layout_.addLayout(known);
  } else {
    auto* box = new QGroupBox(formText(title), parent_);
    known = new QFormLayout(box);
    layout_.addWidget(box);
  }
  return *known;
}

void FormFields::add(const PlatformField& field) {
  QFormLayout& layout = groupLayout(field.group);
  auto editor = std::make_unique<FieldEditor>(field, form_.name, parent_);
  connect(editor.get(), &FieldEditor::changed, this,
          [this, name = QString::fromStdString(field.name)] { Q_EMIT changed(name); });
  if (editor->toggle() != nullptr) {
    layout.addRow(editor->toggle());
    rows_.push_back({nullptr, editor->toggle(), {field.name}});
  }
  if (!field.sameRow || rows_.empty()) {
    auto* box = new QWidget(parent_);
    auto* inRow = new QHBoxLayout(box);
    inRow->setContentsMargins(0, 0, 0, 0);
    QLabel* caption = nullptr;
    if (field.kind != PlatformField::Kind::kFlag) {
      caption = new QLabel(formText(field.label), parent_);
      caption->setBuddy(editor->focusWidget());
      layout.addRow(caption, box);
    } else {
      layout.addRow(QString(), box);
    }
    rows_.push_back({caption, box, {}});
  }
  addToRow(field, *editor);
  editors_.emplace(field.name, std::move(editor));
}

void FormFields::addToRow(const PlatformField& field, FieldEditor& editor) {
  Row& row = rows_.back();
  auto* inRow = static_cast<QHBoxLayout*>(row.box->layout());
  if (field.sameRow) {
    auto* caption = new QLabel(formText(field.label), row.box);
    caption->setBuddy(editor.focusWidget());
    inRow->addWidget(caption);
    editor.addCompanion(caption);
  }
  for (QWidget* widget : editor.widgets()) inRow->addWidget(widget, widget == editor.wideWidget() ? 1 : 0);
  row.fields.push_back(field.name);
}

QLabel& FormFields::noteOf(const std::string& field) {
  QLabel*& note = notes_[field];
  if (note != nullptr) return *note;
  note = new QLabel(parent_);
  note->setObjectName(widgetName(form_.name, field) + QStringLiteral("Note"));
  note->setWordWrap(true);
  const auto row = std::ranges::find_if(
      rows_, [&](const Row& each) { return std::ranges::find(each.fields, field) != each.fields.end(); });
  QFormLayout& layout = groupLayout(form_.field(field)->group);
  int place = layout.rowCount() - 1;
  QFormLayout::ItemRole role{};
  if (row != rows_.end()) layout.getWidgetPosition(row->box, &place, &role);
  layout.insertRow(place + 1, QString(), note);
  return *note;
}

void FormFields::showNotes(const FormState& state) {
  for (const auto& [name, label] : notes_) label->setVisible(state.notes.contains(name));
  for (const auto& [name, note] : state.notes) {
    QLabel& label = noteOf(name);
    label.setText(formText(note.text));
    const auto meaning = note.bad ? widgets::Meaning::kBad : widgets::Meaning::kMuted;
    QPalette colors = parent_->palette();
    colors.setColor(QPalette::WindowText, widgets::colorOf(meaning, colors));
    label.setPalette(colors);
  }
}

FormValues FormFields::values() const {
  FormValues values;
  for (const auto& [name, editor] : editors_) values[name] = editor->value();
  return values;
}

void FormFields::show(const FormState& state) {
  for (const auto& [name, editor] : editors_) {
    if (const auto value = state.values.find(name); value != state.values.end())
      editor->setValue(value->second);
    editor->setEnabled(!state.disabled.contains(name));
    editor->setVisible(!state.hidden.contains(name));
  }
  showNotes(state);
  for (const Row& row : rows_) {
    const bool visible = std::ranges::any_of(
        row.fields, [&](const std::string& field) { return !state.hidden.contains(field); });
    row.box->setVisible(visible);
    if (row.caption != nullptr) row.caption->setVisible(visible);
  }
}

void FormFields::setItems(const std::string& field, const PlatformField::Items& items) {
  if (const auto found = editors_.find(field); found != editors_.end()) found->second->setItems(items);
}

void FormFields::listAgain() {
  for (const auto& [name, editor] : editors_) {
    if (!editor->field().listAgain.empty()) editor->setItems(editor->field().items());
  }
}

}  // namespace app
