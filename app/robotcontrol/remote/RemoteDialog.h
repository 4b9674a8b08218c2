// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QList>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace robotlink {
class CommandTable;
}
namespace robotlink::dds {
struct AnnouncedRobots;
}

namespace app {

class FoundRobots;
class RemoteRobots;

/// Connects robots that run remotely, and shows the connections with their states. Not modal; it
/// closes itself when the robot that the user asked for is there; its owner calls tick() in each tick of the
/// session. GUI thread; commands and robots must outlive it.
class RemoteDialog final : public QDialog {
  Q_OBJECT
 public:
  RemoteDialog(robotlink::CommandTable& commands, const RemoteRobots& robots, QWidget* parent = nullptr);

  /// A server that was connected.
  struct Recent {
    /// The URL without a token.
    QString url;
    /// "red1, red2"
    QString robots;
    /// Whether the program ran here, and only the body there.
    bool isHosted = false;
  };
  /// The servers that were connected last, the newest first.
  const QList<Recent>& recent() const { return recent_; }
  void setRecent(const QList<Recent>& servers);
  /// Shows the states of the connections.
  void tick();
  /// Says which remote body has its program here, and its robot; empty: none. It is remembered.
  void showHosted(const QString& url, const QString& robot);
  /// Shows why a body that the user asked for could not be opened.
  void failHosted(const QString& reason);
  /// Says that the user has to answer a question before that body can be opened.
  void showAsked();
  /// The robots that announce themselves; a click takes their address.
  FoundRobots& found() { return *found_; }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void createFound();
  void createFields();
  void createState();
  QLayout* createToken();
  QLayout* createLimits();
  /// Shows the limits of the URL that was entered, if it is known.
  void showLimits();
  /// Limits connections to a URL as was entered.
  void applyLimits(const std::string& url);
  /// Applies the limits that were entered to a connection that there is already.
  void changeLimits();
  bool isConnected(const std::string& url) const;
  /// The URL that the user has entered, as connections have it; empty if it is invalid.
  std::string enteredUrl() const;
  /// Takes the address of robots that announce themselves.
  void take(const robotlink::dds::AnnouncedRobots& robots);
  /// Shows where the program ran when this URL was connected last.
  void showProgram();
  /// Shows whether a token is remembered for it.
  void showToken();
  void forgetToken();
  void createConnections();
  /// Puts a server to the front of the recent ones.
  void remember(const Recent& server);
  /// Remembers what is connected, also by commands.
  void rememberConnected();
  void connectUrl();
  /// Runs the program of the body at this URL here.
  void hostUrl(const std::string& url);
  void disconnectSelected();
  /// Shows why a URL cannot be connected.
  void fail(const QString& reason);
  void showConnections();
  /// Shows what was left out of the streams of a connection, while its row is open.
  void showMissing(QTreeWidgetItem& row, const std::string& url);
  /// Shows how the connection that the user asked for is getting on.
  void showProgress();
  void showSelected();

  robotlink::CommandTable& commands_;
  const RemoteRobots& robots_;
  FoundRobots* found_ = nullptr;
  QComboBox* url_ = nullptr;
  QComboBox* program_ = nullptr;
  QLineEdit* token_ = nullptr;
  QComboBox* images_ = nullptr;
  QDoubleSpinBox *rate_ = nullptr, *limit_ = nullptr;
  QPushButton* forget_ = nullptr;
  QLabel* state_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QTreeWidget* connections_ = nullptr;
  QPushButton *connect_ = nullptr, *disconnect_ = nullptr;
  QList<Recent> recent_;
  /// The URL that the user asked for and that is not connected yet; empty: none.
  QString wanted_;
  /// Whether its program is to run here.
  bool wantsProgram_ = false;
  /// The last text of showHosted().
  QString hosted_;
};

}  // namespace app
