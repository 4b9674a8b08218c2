// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/remote/RemoteQuestions.h"

#include <QDialog>
#include <algorithm>

#include "app/core/Workbench.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/remote/TokenDialog.h"
#include "app/robotcontrol/remote/TrustDialog.h"

namespace app {

RemoteQuestions::RemoteQuestions(Workbench& workbench, CommandActions& actions, QWidget* window)
    : QObject(window), workbench_(workbench), actions_(actions), window_(window) {}

void RemoteQuestions::tick() {
  const auto connections = workbench_.remote().connections();
  if (open_ != nullptr) {
    const bool isAsked = std::ranges::any_of(connections, [this](const auto& connection) {
      return connection.url == url_ && connection.state.objection == objection_;
    });
    if (isAsked) return;
    open_->disconnect(this);
    open_->close();
    open_ = nullptr;
  }
  for (const auto& connection : connections) {
    if (connection.state.isConnected()) entered_.erase(connection.url);
    if (connection.state.objection.kind == Objection::Kind::kNone) continue;
    return ask(connection.url, connection.state.objection);
  }
}

void RemoteQuestions::ask(const std::string& url, const Objection& objection) {
  url_ = url;
  objection_ = objection;
  open_ = objection.kind == Objection::Kind::kToken ? askForToken(url) : askForTrust(url, objection);
  open_->setAttribute(Qt::WA_DeleteOnClose);
  connect(open_, &QDialog::rejected, this,
          [this, url] { actions_.run(QStringLiteral("remote.disconnect"), {url}); });
  open_->show();
  open_->raise();
  open_->activateWindow();
}

QDialog* RemoteQuestions::askForTrust(const std::string& url, const Objection& objection) {
  auto* dialog = new TrustDialog(url, objection, window_);
  connect(dialog, &QDialog::accepted, this, [this, url, print = objection.fingerprint] {
    actions_.run(QStringLiteral("remote.trust"), {url, print});
  });
  return dialog;
}

QDialog* RemoteQuestions::askForToken(const std::string& url) {
  const auto shown = entered_.contains(url)        ? TokenDialog::Shown::kEntered
                     : RemoteRobots::hasToken(url) ? TokenDialog::Shown::kRemembered
                                                   : TokenDialog::Shown::kNone;
  auto* dialog = new TokenDialog(url, shown, window_);
  connect(dialog, &QDialog::accepted, this, [this, url, dialog] {
    entered_.insert(url);
    actions_.run(QStringLiteral("remote.connect"), {url, dialog->token()});
    if (dialog->remembers()) actions_.run(QStringLiteral("remote.remember-token"), {url});
  });
  return dialog;
}

}  // namespace app
