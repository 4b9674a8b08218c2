// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonValue>
#include <QMap>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <vector>

#include "robotlink/base/Error.h"
#include "widgets/View.h"

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPlainTextEdit;

namespace robotcontrol {
class Request;
}

namespace widgets {

class RobotChoice;
struct RequestForm;

/// Fills in a message to a robot (any request that can be written as text, and any package of its program)
/// and sends it, once or at a rate. A package can also be held in place of what the program offers; all that
/// are held are listed. What was typed for each kind of message is remembered. Repeating ends when a message
/// is refused, when something else is chosen, and when the panel is hidden. GUI thread.
class PublishPanel final : public QWidget {
  Q_OBJECT
 public:
  static constexpr double kMinRate = 0.1, kMaxRate = 50;  // Hz

  PublishPanel(ViewContext& context, QWidget* parent);
  ~PublishPanel() override;

  /// Lists the robots and shows the results of what was sent; call this in each tick.
  void tick();
  /// The typed texts, and the choices.
  QJsonValue state() const;
  void setState(const QJsonValue& state);

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  void createActions();
  void createViews();
  /// Shows the text of the chosen kind.
  void showForm();
  /// The chosen kind; null if the list is empty.
  const RequestForm* form() const;
  /// Sends the text; false: it is wrong, and nothing was sent.
  bool send();
  /// The same for a request that was read from it, with a note if it could not be read.
  bool sendRead(robotlink::Result<robotcontrol::Request> request);
  /// Holds the chosen package as it is typed, or releases it.
  void setHeld(bool held);
  /// Says what is held, and which packages the robot's program has.
  void showPackages();
  void setRepeating(bool on);
  void showCounts();

  ViewContext& context_;
  std::vector<RequestForm> forms_;
  /// The typed texts, by the title of the kind; without an entry it is the default.
  QMap<QString, QString> typed_;
  QString shown_;
  QComboBox* kind_ = nullptr;
  RobotChoice* robot_ = nullptr;
  QPlainTextEdit* text_ = nullptr;
  QDoubleSpinBox* rate_ = nullptr;
  QLabel* state_ = nullptr;
  QAction* send_ = nullptr;
  QAction* repeat_ = nullptr;
  QAction* reset_ = nullptr;
  QAction* hold_ = nullptr;
  QAction* release_ = nullptr;
  QLabel* held_ = nullptr;
  QTimer repeating_;
  /// The number of messages that were sent, and accepted, since the last choice.
  int sent_ = 0, accepted_ = 0;
};

}  // namespace widgets
