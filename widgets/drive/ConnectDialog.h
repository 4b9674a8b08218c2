// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QStringList>
#include <functional>
#include <utility>
#include <vector>

#include "robotlink/arcos/stream/SerialPorts.h"
#include "widgets/PackageWish.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QRadioButton;
class QSpinBox;
class QStackedWidget;

namespace robotlink {
class CommandTable;
class Session;
}  // namespace robotlink

namespace widgets {

/// Connects a robot over TCP or a serial line: recent addresses, serial ports that are there, a map to drive
/// by, a layout. Runs the command robot.connect and shows how the connection comes about, in words, until it
/// stands. It is not modal: its owner calls tick() in each of the session's. GUI thread; session and commands
/// must outlive it.
class ConnectDialog final : public QDialog {
  Q_OBJECT
 public:
  struct Choices {
    QStringList recent;  ///< addresses, newest first
    /// Asked when the dialog is opened and when somebody wants to look again.
    std::function<std::vector<robotlink::arcos::SerialPort>()> serialPorts;
    std::vector<std::pair<QString, QString>> layouts;  ///< what they are called, and what robot.connect takes
    QString map;                                       ///< the last one
  };
  static constexpr int kMostRecent = 10;

  ConnectDialog(robotlink::Session& session, robotlink::CommandTable& commands, Choices choices,
                QWidget* parent = nullptr);

  void tick();
  /// What was asked for cannot be had: a layout that is refused, a map that is damaged.
  void fail(const QString& reason);
  const QStringList& recent() const { return recent_; }
  QString map() const;

 Q_SIGNALS:
  /// An address was connected to: it is the first of recent() now.
  void recentChanged();
  /// The robot answers.
  void connected(const QString& address);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void createViews();
  QWidget* createKinds();
  QWidget* createTcp();
  QWidget* createSerial();
  QWidget* createMap();
  QWidget* createLayouts();
  void connectSignals();
  void listPorts();
  void listRecent();
  /// The fields follow the text, or the text the fields.
  void readAddress();
  void writeAddress();
  void connectRobot();
  void connectNow();
  void showState(const QString& text, bool bad, bool busy);

  robotlink::Session& session_;
  robotlink::CommandTable& commands_;
  Choices choices_;
  QStringList recent_;
  PackageWish wish_;
  QString wanted_;  // the address that is being connected to; empty: none
  QComboBox *address_ = nullptr, *port_ = nullptr, *baud_ = nullptr, *layout_ = nullptr;
  QLabel *meaning_ = nullptr, *state_ = nullptr;
  QRadioButton *tcp_ = nullptr, *serial_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  QLineEdit *host_ = nullptr, *map_ = nullptr;
  QSpinBox* tcpPort_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton *connect_ = nullptr, *connectNow_ = nullptr;
};

}  // namespace widgets
