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
  const auto questions = workbench_.questions();
  if (open_ != nullptr) {
    if (std::ranges::count(questions, LinkQuestion{url_, objection_}) > 0) return;
    open_->disconnect(this);
    open_->close();
    open_ = nullptr;
  }
  for (const auto& connection : workbench_.remote().connections())
    if (connection.state.isConnected()) entered_.erase(connection.url);
  if (const auto* loaded = workbench_.loaded(); loaded != nullptr && !workbench_.loading())
    for (const std::string& source : loaded->sources) entered_.erase(source);
  if (!questions.empty()) ask(questions.front().url, questions.front().objection);
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
    actions_.run(QStringLiteral("remote.show-token"), {url, dialog->token()});
    if (dialog->remembers()) actions_.run(QStringLiteral("remote.remember-token"), {url});
  });
  return dialog;
}

}  // namespace app
