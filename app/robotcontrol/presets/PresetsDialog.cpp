// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/presets/PresetsDialog.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>

#include "app/robotcontrol/presets/PresetActions.h"
#include "widgets/Controls.h"

namespace app {

using robotlink::Preset;
using robotlink::Result;

namespace {

constexpr int kCompareMs = 1000;

}  // namespace

PresetsDialog::PresetsDialog(PresetActions& presets, QWidget* parent) : QDialog(parent), presets_(presets) {
  setObjectName(QStringLiteral("presetsDialog"));
  setWindowTitle(tr("Presets"));
  createWidgets();
  connectSignals();
  list();
  resize(720, 480);
}

void PresetsDialog::createWidgets() {
  list_ = new QListWidget(this);
  widgets::describe(*list_, {"presetsList", tr("Presets"), {}});
  differences_ = new QPlainTextEdit(this);
  widgets::describe(*differences_, {"presetsDifferences", tr("Differences from the current settings"), {}});
  differences_->setReadOnly(true);
  name_ = new QLineEdit(this);
  widgets::describe(*name_, {"presetsName", tr("Name"), tr("The name to save under, or the new name")});
  name_->setPlaceholderText(tr("Name"));
  const QString titles[Preset::kParts] = {tr("Debug &keys"), tr("S&olutions"), tr("&Parameters"),
                                          tr("&Views"), tr("&Camera")};
  auto* parts = new QHBoxLayout;
  parts->addWidget(name_, 1);
  for (int part = 0; part < Preset::kParts; ++part) {
    auto* box = new QCheckBox(titles[part], this);
    box->setObjectName(QStringLiteral("presetsPart%1").arg(part));
    box->setChecked(true);
    parts->addWidget(box);
    parts_.push_back(box);
  }
  parts_[Preset::kCamera]->setToolTip(
      tr("The settings of the camera, known only while the view Camera is open"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  const auto add = [&](const char* name, const QString& text) {
    auto* button = buttons->addButton(text, QDialogButtonBox::ActionRole);
    button->setObjectName(QLatin1String(name));
    button->setAutoDefault(false);
    return button;
  };
  save_ = add("presetsSave", tr("&Save"));
  load_ = add("presetsLoad", tr("&Load"));
  rename_ = add("presetsRename", tr("&Rename"));
  delete_ = add("presetsDelete", tr("&Delete"));
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  state_ = widgets::makeNote(this, "presetsState", tr("Last result"));
  auto* top = new QHBoxLayout;
  top->addWidget(list_, 1);
  top->addWidget(differences_, 2);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(top, 1);
  layout->addLayout(parts);
  layout->addWidget(state_);
  layout->addWidget(buttons);
}

void PresetsDialog::connectSignals() {
  connect(&presets_, &PresetActions::changed, this, &PresetsDialog::list);
  connect(list_, &QListWidget::currentTextChanged, this, [this](const QString& name) {
    name_->setText(name);
    differences_->clear();
    compare();
  });
  connect(save_, &QPushButton::clicked, this, [this] {
    const QString name = name_->text().trimmed();
    report(presets_.save(name.toStdString(), chosenParts()), tr("Saved: %1").arg(name));
  });
  connect(load_, &QPushButton::clicked, this, [this] {
    const auto preset = presets_.named(current());
    report(preset ? presets_.load(*preset) : Result<void>(tl::unexpected(preset.error())),
           tr("Loaded: %1").arg(list_->currentItem()->text()));
  });
  connect(rename_, &QPushButton::clicked, this, [this] {
    report(presets_.rename(current(), name_->text().trimmed().toStdString()), tr("Renamed"));
  });
  connect(delete_, &QPushButton::clicked, this,
          [this] { report(presets_.remove(current()), tr("Deleted")); });
  // Keys, solutions and parameters are switched in other views, in scripts and by others while this is open.
  connect(&comparing_, &QTimer::timeout, this, [this] {
    if (isVisible() && !current().empty()) compare();
  });
  comparing_.start(kCompareMs);
}

void PresetsDialog::list() {
  const QString before = name_->text();
  list_->clear();
  for (const std::string& name : presets_.presets().names()) list_->addItem(QString::fromStdString(name));
  const auto found = list_->findItems(before, Qt::MatchExactly);
  list_->setCurrentItem(found.isEmpty() ? list_->item(0) : found.first());
  if (list_->count() == 0) compare();
}

std::string PresetsDialog::current() const {
  return list_->currentItem() == nullptr ? std::string() : list_->currentItem()->text().toStdString();
}

void PresetsDialog::compare() {
  for (QPushButton* button : {load_, rename_, delete_}) button->setEnabled(!current().empty());
  if (current().empty()) {
    differences_->clear();
    return differences_->setPlaceholderText(
        tr("There is no preset yet. Type a name, choose its parts, and save."));
  }
  const auto preset = presets_.named(current());
  if (!preset) return showDifferences(QString::fromStdString(preset.error().describe()));
  presets_.compare(*preset, [guard = QPointer(this), name = current()](const auto& lines) {
    if (!guard || guard->current() != name) return;
    QString text = lines ? QString() : QString::fromStdString(lines.error().describe());
    for (const std::string& line : lines.value_or(std::vector<std::string>()))
      text += QString::fromStdString(line) + QLatin1Char('\n');
    guard->showDifferences(text.isEmpty() ? tr("The current settings match this preset.") : text);
  });
}

void PresetsDialog::showDifferences(const QString& text) {
  // Setting a text ends what is selected and scrolls to its begin.
  if (differences_->toPlainText() != text) differences_->setPlainText(text);
}

std::vector<Preset::Part> PresetsDialog::chosenParts() const {
  std::vector<Preset::Part> parts;
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    if (parts_[part]->isChecked()) parts.push_back(static_cast<Preset::Part>(part));
  }
  return parts;
}

void PresetsDialog::report(const Result<void>& done, const QString& text) {
  widgets::showOutcome(*state_, done ? text : QString::fromStdString(done.error().describe()), !done);
}

}  // namespace app
