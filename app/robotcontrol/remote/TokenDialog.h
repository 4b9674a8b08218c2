// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <string>

class QCheckBox;
class QLineEdit;

namespace app {

/// Asks for the token of a remote robot that refused the one that it was shown, or demands one. GUI
/// thread.
class TokenDialog final : public QDialog {
  Q_OBJECT
 public:
  /// The kind of token that was presented to the robot.
  enum class Shown { kNone, kEntered, kRemembered };

  TokenDialog(const std::string& url, Shown shown, QWidget* parent = nullptr);
  std::string token() const;
  bool remembers() const;

 private:
  QLineEdit* token_ = nullptr;
  QCheckBox* remember_ = nullptr;
};

}  // namespace app
