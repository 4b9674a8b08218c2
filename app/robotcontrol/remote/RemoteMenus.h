// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QObject>

class QMenu;
class QWidget;

namespace app {

class CommandActions;
class OfferDialog;
class RecordingsDialog;
class RemoteDialog;
class RemoteQuestions;
class RobotsDialog;
class Workbench;

/// The entries of menus for remote robots, with their dialogs: connecting such robots, their recordings,
/// and offering this session to others. GUI thread; belongs to the window; workbench and actions must outlive
/// it.
class RemoteMenus final : public QObject {
  Q_OBJECT
 public:
  /// `window` is the parent of dialogs.
  RemoteMenus(Workbench& workbench, CommandActions& actions, QWidget* window);

  /// Adds "Connect..." and "Connect again" with the servers that were connected last.
  void addConnect(QMenu& menu);
  /// Adds "Offer this session...".
  void addOffer(QMenu& menu);
  /// Adds "Robots...": sets of them.
  void addRobots(QMenu& menu);
  /// Adds "Recordings at the robot...".
  void addRecordings(QMenu& menu);
  void showConnect();
  void showOffer();
  /// Call this in each tick of the session.
  void tick();
  /// Call this when a platform could not be opened.
  void fail(const QString& reason);

  /// Loads and saves the user's last entries in the state of the window.
  void load(const QJsonObject& window);
  void save(QJsonObject& window) const;

 private:
  static void show(QWidget& dialog);
  /// Lets the dialogs show which robots announce themselves, as long as one is visible.
  void followSearch();
  /// Shows in the dialog how a body is getting on whose program is to run here.
  void followHosted();
  /// Lists the servers that were connected last.
  void fillAgain();
  /// Runs the program of a remote body here.
  void host(const std::string& url);

  Workbench& workbench_;
  QMenu* again_ = nullptr;
  RemoteDialog* connect_;
  OfferDialog* offer_;
  RecordingsDialog* recordings_;
  RemoteQuestions* questions_;
  RobotsDialog* robots_;
};

}  // namespace app
