// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/FieldEditor.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QRadioButton>
#include <QSpinBox>
#include <QToolButton>

#include "widgets/Icon.h"

namespace app {
namespace {

/// A caption as an accessible name: "&First port:" is "First port".
QString objectNameOf(const QString& caption) {
  QString name = caption;
  name.remove(QLatin1Char('&'));
  if (name.endsWith(QLatin1Char(':'))) name.chop(1);
  return name;
}

}  // namespace

QString formText(const std::string& text) {
  return QCoreApplication::translate("Platform", text.c_str());
}

QString widgetName(const std::string& form, const std::string& field) {
  QString name = QString::fromStdString(field);
  name[0] = name[0].toUpper();
  return QString::fromStdString(form) + name;
}

FieldEditor::FieldEditor(const PlatformField& field, const std::string& form, QWidget* parent)
    : field_(field), form_(form), parent_(parent) {
  using Kind = PlatformField::Kind;
  if (field_.kind == Kind::kNumber) createNumber();
  if (field_.kind == Kind::kFlag) createFlag();
  if (field_.kind == Kind::kText || field_.kind == Kind::kFile) createLine();
  if (field_.kind == Kind::kChoice && field_.buttons) createButtons();
  if (field_.kind == Kind::kChoice && !field_.buttons) createChoice();
  createTools();
  setValue(field_.initial);
  if (field_.toggle.empty()) return;
  toggle_ = new QCheckBox(formText(field_.toggle), parent_);
  toggle_->setObjectName(widgetName(form_, field_.name) + QStringLiteral("On"));
  toggle_->setToolTip(formText(field_.help));
  connect(toggle_, &QCheckBox::toggled, this, &FieldEditor::changed);
}

void FieldEditor::addWidget(QWidget* widget, const QString& suffix) {
  widget->setObjectName(widgetName(form_, field_.name) + suffix);
  if (widget->toolTip().isEmpty()) widget->setToolTip(formText(field_.help));
  if (widget->accessibleName().isEmpty()) widget->setAccessibleName(objectNameOf(formText(field_.label)));
  widgets_ << widget;
}

void FieldEditor::createLine() {
  line_ = new QLineEdit(parent_);
  line_->setPlaceholderText(formText(field_.emptyText));
  line_->setClearButtonEnabled(field_.kind == PlatformField::Kind::kFile);
  addWidget(line_);
  connect(line_, &QLineEdit::textEdited, this, &FieldEditor::changed);
}

void FieldEditor::createNumber() {
  const auto prepare = [this](auto* box) {
    box->setSpecialValueText(formText(field_.emptyText));
    if (!field_.unit.empty()) box->setSuffix(QLatin1Char(' ') + formText(field_.unit));
    addWidget(box);
  };
  if (field_.decimals > 0) {
    number_ = new QDoubleSpinBox(parent_);
    number_->setDecimals(field_.decimals);
    number_->setRange(field_.min, field_.max);
    prepare(number_);
    connect(number_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &FieldEditor::changed);
    return;
  }
  whole_ = new QSpinBox(parent_);
  whole_->setRange(static_cast<int>(field_.min), static_cast<int>(field_.max));
  prepare(whole_);
  connect(whole_, QOverload<int>::of(&QSpinBox::valueChanged), this, &FieldEditor::changed);
}

void FieldEditor::createFlag() {
  flag_ = new QCheckBox(formText(field_.label), parent_);
  addWidget(flag_);
  connect(flag_, &QCheckBox::toggled, this, &FieldEditor::changed);
}

void FieldEditor::createChoice() {
  constexpr int kWide = 24;  // characters
  choice_ = new QComboBox(parent_);
  choice_->setEditable(field_.editable);
  choice_->setInsertPolicy(QComboBox::NoInsert);
  if (field_.editable) {
    choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice_->setMinimumContentsLength(kWide);
    choice_->lineEdit()->setPlaceholderText(formText(field_.emptyText));
  }
  addWidget(choice_);
  if (field_.items) setItems(field_.items());
  if (field_.editable) {
    connect(choice_, &QComboBox::editTextChanged, this, &FieldEditor::changed);
  } else {
    connect(choice_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &FieldEditor::changed);
  }
  if (!field_.unit.empty()) addWidget(new QLabel(formText(field_.unit), parent_), QStringLiteral("Unit"));
}

void FieldEditor::createButtons() {
  buttons_ = new QButtonGroup(this);
  for (const PlatformField::Item& item : field_.items()) {
    auto* button = new QRadioButton(formText(item.title), parent_);
    addWidget(button);
    button->setObjectName(widgetName(form_, item.value));
    button->setAccessibleName(objectNameOf(formText(item.title)));
    button->setToolTip(formText(item.help));
    button->setProperty("value", QString::fromStdString(item.value));
    buttons_->addButton(button);
    connect(button, &QRadioButton::clicked, this, &FieldEditor::changed);
  }
}

void FieldEditor::createTools() {
  if (!field_.files.empty()) {
    auto* button = new QToolButton(parent_);
    button->setIcon(widgets::icon("open"));
    button->setToolTip(tr("Chooses a file"));
    addWidget(button, QStringLiteral("Browse"));
    connect(button, &QToolButton::clicked, this, &FieldEditor::browse);
  }
  if (!field_.listAgain.empty()) {
    auto* button = new QToolButton(parent_);
    button->setIcon(widgets::icon("refresh"));
    button->setToolTip(formText(field_.listAgain));
    addWidget(button, QStringLiteral("Again"));
    connect(button, &QToolButton::clicked, this, [this] { setItems(field_.items()); });
  }
}

void FieldEditor::browse() {
  const QString before = line_ != nullptr ? line_->text() : chosenText();
  const QString file =
      QFileDialog::getOpenFileName(parent_, objectNameOf(formText(field_.label)), QFileInfo(before).path(),
                                   formText(field_.files) + QStringLiteral(";;") + tr("All files (*)"));
  if (file.isEmpty()) return;
  setValue(file.toStdString());
  Q_EMIT changed();
}

QWidget* FieldEditor::wideWidget() const {
  const bool isWide = line_ != nullptr || (choice_ != nullptr && field_.editable);
  return isWide ? widgets_.front() : nullptr;
}

QString FieldEditor::chosenText() const {
  if (buttons_ != nullptr) {
    const QAbstractButton* chosen = buttons_->checkedButton();
    return chosen == nullptr ? QString() : chosen->property("value").toString();
  }
  if (!field_.editable) return choice_->currentData().toString();
  const int index = choice_->findText(choice_->currentText(), Qt::MatchExactly | Qt::MatchCaseSensitive);
  return index >= 0 ? choice_->itemData(index).toString() : choice_->currentText().trimmed();
}

FormValue FieldEditor::value() const {
  const bool off = toggle_ != nullptr && !toggle_->isChecked();
  if (whole_ != nullptr) return off ? 0.0 : static_cast<double>(whole_->value());
  if (number_ != nullptr) return off ? 0.0 : number_->value();
  if (flag_ != nullptr) return flag_->isChecked();
  if (off) return std::string();
  return (line_ != nullptr ? line_->text().trimmed() : chosenText()).toStdString();
}

void FieldEditor::chooseText(const QString& value) {
  if (buttons_ != nullptr) {
    for (QAbstractButton* button : buttons_->buttons())
      button->setChecked(button->property("value").toString() == value);
    return;
  }
  int index = choice_->findData(value);
  if (index < 0 && !field_.editable && !value.isEmpty()) {
    choice_->addItem(value, value);
    index = choice_->count() - 1;
  }
  if (index >= 0) {
    choice_->setCurrentIndex(index);
    if (field_.editable) choice_->setEditText(choice_->itemText(index));
  } else if (field_.editable) {
    choice_->setEditText(value);
  }
}

void FieldEditor::setValue(const FormValue& value) {
  if (this->value() == value) return;
  const QSignalBlocker quiet(this);
  if (toggle_ != nullptr) {
    const bool on = value != FormValue(0.0) && value != FormValue(std::string());
    toggle_->setChecked(on);
    if (!on) return;
  }
  if (const auto* flag = std::get_if<bool>(&value); flag && flag_) flag_->setChecked(*flag);
  if (const auto* number = std::get_if<double>(&value)) {
    if (whole_ != nullptr) whole_->setValue(static_cast<int>(*number));
    if (number_ != nullptr) number_->setValue(*number);
  }
  if (const auto* text = std::get_if<std::string>(&value)) {
    if (line_ != nullptr) line_->setText(QString::fromStdString(*text));
    if (choice_ != nullptr || buttons_ != nullptr) chooseText(QString::fromStdString(*text));
  }
}

void FieldEditor::setItems(const PlatformField::Items& items) {
  if (choice_ == nullptr) return;
  const QSignalBlocker quiet(this);
  const QString before = choice_->count() > 0 || field_.editable ? chosenText() : QString();
  choice_->clear();
  for (const PlatformField::Item& item : items) {
    choice_->addItem(formText(item.title), QString::fromStdString(item.value));
    if (!item.help.empty()) choice_->setItemData(choice_->count() - 1, formText(item.help), Qt::ToolTipRole);
  }
  // Without an earlier value, the first item that was found is better than none.
  const bool finds = !field_.listAgain.empty() && before.isEmpty() && !items.empty();
  chooseText(finds ? QString::fromStdString(items.front().value) : before);
}

void FieldEditor::setEnabled(bool enabled) {
  // The toggle decides about the rest of its field.
  const bool on = toggle_ == nullptr || toggle_->isChecked();
  for (QWidget* widget : widgets_ + companions_) widget->setEnabled(enabled && on);
  if (toggle_ != nullptr) toggle_->setEnabled(enabled);
}

void FieldEditor::setVisible(bool visible) {
  for (QWidget* widget : widgets_ + companions_) widget->setVisible(visible);
}

}  // namespace app
