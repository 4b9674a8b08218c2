// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <filesystem>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace widgets {

class SceneLanguage;

/// Asks for the properties of a new room: its name, size, walls, a doorway, and a robot. It closes when the
/// text is made, and otherwise shows the reason. GUI thread.
class NewSceneDialog final : public QDialog {
  Q_OBJECT
 public:
  /// `file`: where the scene may be, for the models that it can include. The language must outlive it.
  NewSceneDialog(const SceneLanguage& language, std::filesystem::path file, QWidget* parent);

  QString name() const;
  /// The text of the room; empty until the dialog was accepted.
  const QString& text() const { return text_; }
  void accept() override;

 private:
  QDoubleSpinBox* addLength(QFormLayout& form, const char* name, const QString& label, double value,
                            double least, double most);

  const SceneLanguage& language_;
  const std::filesystem::path file_;
  QString text_;
  QLineEdit* name_ = nullptr;
  QDoubleSpinBox *width_ = nullptr, *depth_ = nullptr, *height_ = nullptr;
  QCheckBox* doorway_ = nullptr;
  QComboBox* robot_ = nullptr;
  QLabel* refusal_ = nullptr;
};

}  // namespace widgets
