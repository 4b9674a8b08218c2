// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

#include "app/core/platform/PlatformForm.h"
#include "widgets/PackageSubscription.h"

class QDialogButtonBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace robotlink {
class CommandTable;
class Session;
}  // namespace robotlink

namespace app {

class FormFields;
class FormMemory;

/// Asks what a user wants to be opened: the dialog of a platform's form, whose fields have the values that
/// were accepted last. It yields the arguments of the form's command.
///
/// If the form connects a robot, the dialog runs the command itself, is not modal, shows the progress of the
/// connection, and closes itself when that is established; its owner calls tick() in each tick of the
/// session. GUI thread; session, commands and memory must outlive it.
class PlatformDialog final : public QDialog {
  Q_OBJECT
 public:
  PlatformDialog(PlatformForm form, robotlink::Session& session, robotlink::CommandTable& commands,
                 FormMemory& memory, QWidget* parent = nullptr);

  const PlatformForm& form() const { return form_; }
  /// The arguments of the form's command.
  std::vector<FormValue> arguments() const;
  /// Follows the LinkStatus of the address that is being connected to.
  void tick();
  /// Shows why connecting failed (a layout that was refused, a damaged map); ignored unless it is connecting.
  void fail(const QString& reason);

 Q_SIGNALS:
  /// The robot has answered; the dialog has closed.
  void connected(const QString& address);

 protected:
  /// Lists choices that may have changed.
  void showEvent(QShowEvent* event) override;

 private:
  /// The create functions are called once, by the constructor.
  void createButtons();
  void createProgress();
  /// Sets the fields to what was accepted last, or to their initial values; called once.
  void fillIn();
  /// Adapts the form to its values; `changed` is the field that the user has changed.
  void follow(const QString& changed);
  /// Keeps the values, then closes the dialog or connects.
  void acceptChoices();
  /// Runs the form's command.
  void connectRobot();
  /// Runs robot.connect-now.
  void connectNow();
  /// Enables the button that accepts the choices.
  void enable();
  /// Shows a text; `bad`: in the color of an error, `busy`: with a progress bar.
  void showState(const QString& text, bool bad, bool busy);

  const PlatformForm form_;
  robotlink::Session& session_;
  robotlink::CommandTable& commands_;
  FormMemory& memory_;
  FormState state_;
  FormFields* fields_ = nullptr;
  /// Requests that the robots' LinkStatus is published.
  widgets::PackageSubscription subscription_;
  /// The address that is being connected to; empty: none.
  QString wanted_;
  /// Says what the choices mean, or how far the connection is.
  QLabel* hint_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
  QPushButton *accept_ = nullptr, *connectNow_ = nullptr;
};

}  // namespace app
