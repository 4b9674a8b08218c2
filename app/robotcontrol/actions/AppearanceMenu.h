// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QJsonObject>
#include <QMenu>

#include "app/robotcontrol/actions/Appearance.h"

class QActionGroup;

namespace app {

/// The menu of the colors and of the size of texts. A choice is in effect at once in the whole application.
/// GUI thread.
class AppearanceMenu final : public QMenu {
  Q_OBJECT
 public:
  /// Texts in the size that the desktop wants have 100.
  static constexpr int kMinTextSize = 70, kMaxTextSize = 250;  // percent

  explicit AppearanceMenu(QWidget* parent);

  void setAppearance(Appearance appearance);
  /// In percent; clamped to the limits.
  void setTextSize(int percent);
  int textSize() const { return textSize_; }

  /// Reads and writes the choices as members of the saved window.
  void load(const QJsonObject& window);
  void save(QJsonObject& window) const;

 Q_SIGNALS:
  /// Colors or texts look different now.
  void changed();

 private:
  void addTextSizes();
  /// Sets colors and texts of the application, and checks the entries.
  void applyChoices();

  /// The font that the desktop wants.
  const QFont font_;
  Appearance appearance_ = Appearance::kSystem;
  int textSize_ = 100;
  QActionGroup* sizes_ = nullptr;
};

}  // namespace app
