// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drive/StateRows.h"

#include <QEvent>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>

#include "widgets/Controls.h"

namespace widgets {

StateRows::StateRows(const QString& title, const char* name, QWidget* parent)
    : QGroupBox(title, parent), grid_(new QGridLayout(this)) {
  setObjectName(QLatin1String(name));
  grid_->setContentsMargins(8, 6, 8, 6);
  grid_->setHorizontalSpacing(10);
  grid_->setVerticalSpacing(2);
  grid_->setColumnStretch(1, 1);
}

QLabel* StateRows::addTitle(const QString& title, const QString& toolTip) {
  auto* label = new QLabel(title, this);
  label->setToolTip(toolTip);
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  titles_.push_back(label);
  setMeaning(*label, Meaning::kMuted);
  grid_->addWidget(label, grid_->rowCount(), 0);
  return label;
}

void StateRows::addRow(const char* name, const QString& title, const QString& toolTip) {
  addTitle(title, toolTip);
  auto* label = new QLabel(QStringLiteral("–"), this);
  describe(*label, {name, title, toolTip});
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  grid_->addWidget(label, grid_->rowCount() - 1, 1);
  values_[name] = {label, false, false, Meaning::kMuted};
}

void StateRows::addRow(const QString& title, const QString& toolTip, QWidget* widget) {
  addTitle(title, toolTip);
  grid_->addWidget(widget, grid_->rowCount() - 1, 1);
}

void StateRows::addWidget(QWidget* widget) {
  grid_->addWidget(widget, grid_->rowCount(), 0, 1, 2, Qt::AlignLeft);
}

void StateRows::addText(const char* name, const QString& title) {
  auto* label = new QLabel(this);
  describe(*label, {name, title, {}});
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->hide();
  grid_->addWidget(label, grid_->rowCount(), 0, 1, 2);
  values_[name] = {label, true, false, Meaning::kMuted};
}

void StateRows::set(const char* name, const QString& text, Meaning meaning, bool colored) {
  Value& value = values_.at(name);
  const QString shown = text.isEmpty() && !value.wide ? QStringLiteral("–") : text;
  if (value.label->text() != shown) value.label->setText(shown);
  if (value.wide) value.label->setVisible(!text.isEmpty());
  if (colored == value.colored && meaning == value.meaning) return;
  value.colored = colored;
  value.meaning = meaning;
  color(value);
}

void StateRows::setStale(bool stale) {
  if (stale == stale_) return;
  stale_ = stale;
  for (const auto& [name, value] : values_) color(value);
}

void StateRows::color(const Value& value) const {
  if (stale_ && !value.wide)
    setMeaning(*value.label, Meaning::kMuted);
  else
    setMeaning(*value.label, value.colored ? std::optional(value.meaning) : std::nullopt);
  QFont font = value.label->font();
  font.setBold(value.colored && (!stale_ || value.wide) &&
               (value.meaning == Meaning::kBad || value.meaning == Meaning::kWarning));
  value.label->setFont(font);
}

void StateRows::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    for (const auto& [name, value] : values_) color(value);
    for (QLabel* title : titles_) setMeaning(*title, Meaning::kMuted);
  }
  QGroupBox::changeEvent(event);
}

}  // namespace widgets
