// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <set>
#include <string>

#include "robotlink/foxglove/client/ConnectionState.h"

class QDialog;
class QWidget;

namespace app {

class CommandActions;
class Workbench;

/// Asks the user about objections of remote robots: an untrusted certificate, or a missing token. One
/// question at a time, which does not block the window; it closes when its connection does. GUI
/// thread; belongs to the window; workbench and actions must outlive it.
class RemoteQuestions final : public QObject {
  Q_OBJECT
 public:
  RemoteQuestions(Workbench& workbench, CommandActions& actions, QWidget* window);
  /// Call this in each tick of the session.
  void tick();

 private:
  using Objection = robotlink::websocket::ServerObjection;
  void ask(const std::string& url, const Objection& objection);
  QDialog* askForTrust(const std::string& url, const Objection& objection);
  QDialog* askForToken(const std::string& url);

  Workbench& workbench_;
  CommandActions& actions_;
  QWidget* window_;
  QPointer<QDialog> open_;
  /// The subject of the open question.
  std::string url_;
  Objection objection_;
  /// Servers for which a token was entered.
  std::set<std::string> entered_;
};

}  // namespace app
