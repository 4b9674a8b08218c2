// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QStringList>
#include <functional>
#include <utility>
#include <vector>

#include "robotlink/arcos/stream/SerialPorts.h"
#include "widgets/PackageSubscription.h"

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

/// Connects a robot over TCP or a serial line: recent addresses, the serial ports of this computer, a map to
/// drive by, a layout. It runs the command robot.connect and shows the progress of the connection until it is
/// established, then closes itself. It is not modal: its owner calls tick() in each tick of the session. GUI
/// thread; session and commands must outlive it.
class ConnectDialog final : public QDialog {
  Q_OBJECT
 public:
  /// What the dialog offers.
  struct Choices {
    /// Recent addresses, newest first.
    QStringList recent;
    /// Returns the serial ports; called when the dialog is opened and at "Look again". May be empty.
    std::function<std::vector<robotlink::arcos::SerialPort>()> serialPorts;
    /// Titles of layouts, and what robot.connect takes for them.
    std::vector<std::pair<QString, QString>> layouts;
    /// The map that was used last; may be empty.
    QString map;
  };
  /// Number of recent addresses that are kept.
  static constexpr int kMaxRecent = 10;

  ConnectDialog(robotlink::Session& session, robotlink::CommandTable& commands, Choices choices,
                QWidget* parent = nullptr);

  /// Follows the LinkStatus of the address that is being connected to.
  void tick();
  /// Shows why connecting failed (a layout that was refused, a damaged map); ignored unless it is connecting.
  void fail(const QString& reason);
  /// The recent addresses, newest first, including the last one that was connected to.
  const QStringList& recent() const { return recent_; }
  /// Path of the map in the field; may be empty.
  QString map() const;

 Q_SIGNALS:
  /// recent() has changed: an address is being connected to.
  void recentChanged();
  /// The robot has answered; the dialog has closed.
  void connected(const QString& address);

 protected:
  /// Lists the serial ports.
  void showEvent(QShowEvent* event) override;

 private:
  void createViews();
  /// The choice between TCP and serial with a page for each.
  QWidget* createKinds();
  /// Page with host and port.
  QWidget* createTcp();
  /// Page with serial port and baud rate.
  QWidget* createSerial();
  QWidget* createMap();
  QWidget* createLayouts();
  void connectSignals();
  /// Fills the list of serial ports; the typed text is kept.
  void listPorts();
  /// Fills the list of the address field with the recent addresses.
  void listRecent();
  /// Sets the fields from the address, and says what it means.
  void readAddress();
  /// Sets the address from the fields.
  void writeAddress();
  /// Runs robot.connect with the address.
  void connectRobot();
  /// Runs robot.connect-now.
  void connectNow();
  /// Shows a text; `bad`: in the color of an error, `busy`: with a progress bar.
  void showState(const QString& text, bool bad, bool busy);

  robotlink::Session& session_;
  robotlink::CommandTable& commands_;
  Choices choices_;
  /// See recent().
  QStringList recent_;
  /// Requests that the robots' LinkStatus is published.
  PackageSubscription subscription_;
  /// The address that is being connected to; empty: none.
  QString wanted_;
  QComboBox *address_ = nullptr, *port_ = nullptr, *baud_ = nullptr, *layout_ = nullptr;
  /// What the address means, and the state of the connection.
  QLabel *meaning_ = nullptr, *state_ = nullptr;
  QRadioButton *tcp_ = nullptr, *serial_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  QLineEdit *host_ = nullptr, *map_ = nullptr;
  QSpinBox* tcpPort_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton *connect_ = nullptr, *connectNow_ = nullptr;
};

}  // namespace widgets
