// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <vector>

#include "app/core/platform/PlatformForm.h"

class QBoxLayout;
class QFormLayout;
class QHBoxLayout;
class QLabel;
class QWidget;

namespace app {

class FieldEditor;

/// The widgets of a form's fields, in rows and boxes as the form declares them. A widget's object name is
/// that of the form and that of the field: "connectHost". GUI thread; belongs to the dialog.
class FormFields final : public QObject {
  Q_OBJECT
 public:
  /// Adds the widgets to the end of a layout of `parent`. The form must outlive this object.
  FormFields(const PlatformForm& form, QBoxLayout& layout, QWidget* parent);
  ~FormFields() override;

  /// The values in the fields.
  FormValues values() const;
  /// Shows a state of the form.
  void show(const FormState& state);
  /// Sets the choices of a field.
  void setItems(const std::string& field, const PlatformField::Items& items);
  /// Asks again for the choices of fields that change while they are shown.
  void listAgain();

 Q_SIGNALS:
  /// The user has changed a field.
  void changed(const QString& field);

 private:
  /// Editors that are side by side, and their caption.
  struct Row {
    QWidget* caption = nullptr;
    QWidget* box = nullptr;
    std::vector<std::string> fields;
  };
  /// Adds the widgets of a field.
  void add(const PlatformField& field);
  /// Adds an editor to the last row.
  void addToRow(const PlatformField& field, FieldEditor& editor);
  /// The label for a field's note, below its row; made when it is first used.
  QLabel& noteOf(const std::string& field);
  void showNotes(const FormState& state);
  /// The layout of a group, which is made when it is first used.
  QFormLayout& groupLayout(const std::string& title);

  const PlatformForm& form_;
  QBoxLayout& layout_;
  QWidget* parent_;
  std::map<std::string, QFormLayout*> groups_;
  std::map<std::string, std::unique_ptr<FieldEditor>> editors_;
  std::map<std::string, QLabel*> notes_;
  std::vector<Row> rows_;
};

}  // namespace app
