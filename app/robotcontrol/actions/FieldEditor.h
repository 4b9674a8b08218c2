// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QString>

#include "app/core/platform/PlatformForm.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QSpinBox;
class QToolButton;
class QWidget;

namespace app {

/// A text of a form, translated.
QString formText(const std::string& text);
/// The object name of a field's widget: "connectHost" for the form "connect" and the field "host".
QString widgetName(const std::string& form, const std::string& field);

/// The widgets in which a user edits one field of a form: a line, a number, a box to tick, or choices, with
/// buttons for a file dialog and for listing the choices again. GUI thread; the widgets belong to `parent`.
class FieldEditor final : public QObject {
  Q_OBJECT
 public:
  /// The field must outlive this object.
  FieldEditor(const PlatformField& field, const std::string& form, QWidget* parent);

  const PlatformField& field() const { return field_; }
  /// The widgets, from left to right.
  const QList<QWidget*>& widgets() const { return widgets_; }
  /// The one that has the focus when the caption's key is pressed; it is also the wide one, except numbers.
  QWidget* focusWidget() const { return widgets_.front(); }
  /// The one that uses the space that is left; null if none does.
  QWidget* wideWidget() const;
  /// The box that has to be ticked for the field to count; null if there is none.
  QCheckBox* toggle() const { return toggle_; }
  /// Adds a widget that is shown and enabled together with the editor.
  void addCompanion(QWidget* widget) { companions_ << widget; }

  /// The value of the field; 0 or empty while it is toggled off.
  FormValue value() const;
  /// Changes the field if it has another value; changed() is not emitted.
  void setValue(const FormValue& value);
  /// Replaces the choices; the value stays.
  void setItems(const PlatformField::Items& items);
  void setEnabled(bool enabled);
  void setVisible(bool visible);

 Q_SIGNALS:
  /// The user has changed the value.
  void changed();

 private:
  void createLine();
  void createNumber();
  void createFlag();
  void createChoice();
  void createButtons();
  /// The buttons for a file dialog and for listing choices again.
  void createTools();
  /// Names a widget, and adds it to the row.
  void addWidget(QWidget* widget, const QString& suffix = {});
  /// Asks for a file.
  void browse();
  QString chosenText() const;
  void chooseText(const QString& value);

  const PlatformField& field_;
  const std::string form_;
  QWidget* parent_;
  QList<QWidget*> widgets_, companions_;
  // One of these editors is not null.
  QLineEdit* line_ = nullptr;
  QSpinBox* whole_ = nullptr;
  QDoubleSpinBox* number_ = nullptr;
  QCheckBox* flag_ = nullptr;
  QComboBox* choice_ = nullptr;
  QButtonGroup* buttons_ = nullptr;
  /// See toggle().
  QCheckBox* toggle_ = nullptr;
};

}  // namespace app
