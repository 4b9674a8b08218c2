// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/remote/TokenDialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "robotlink/foxglove/security/RememberedTokens.h"
#include "widgets/Controls.h"
#include "widgets/Icon.h"

namespace app {
namespace {

QString questionFor(const QString& url, TokenDialog::Shown shown) {
  switch (shown) {
    case TokenDialog::Shown::kNone:
      return TokenDialog::tr(
                 "The robot at %1 only accepts clients with its token. It printed two when it created them: "
                 "one to control, and one to watch.")
          .arg(url);
    case TokenDialog::Shown::kEntered:
      return TokenDialog::tr(
                 "The robot at %1 does not accept this token. Enter one of the two that it printed "
                 "when it created them.")
          .arg(url);
    case TokenDialog::Shown::kRemembered:
      return TokenDialog::tr(
                 "The robot at %1 does not accept the remembered token any more. Enter one of the two that "
                 "it printed when it created them.")
          .arg(url);
  }
  return {};
}

}  // namespace

TokenDialog::TokenDialog(const std::string& url, Shown shown, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("tokenDialog"));
  setWindowTitle(tr("Token of a robot"));
  setWindowIcon(widgets::icon("lock"));
  auto* layout = new QVBoxLayout(this);
  auto* text = widgets::makeNote(this, "tokenText", tr("What is asked"));
  text->setText(questionFor(QString::fromStdString(url), shown));
  layout->addWidget(text);
  auto* form = new QFormLayout;
  token_ = new QLineEdit(this);
  widgets::describe(*token_, {"tokenField", tr("Token"), {}});
  token_->setEchoMode(QLineEdit::PasswordEchoOnEdit);
  form->addRow(tr("&Token:"), token_);
  layout->addLayout(form);
  remember_ = new QCheckBox(tr("&Remember it on this computer"), this);
  widgets::describe(
      *remember_,
      {"tokenRemember", tr("Remember it"),
       tr("In %1, which only you can read; Robot > Connect… forgets it")
           .arg(QString::fromStdString(robotlink::websocket::RememberedTokens::defaultFile().string()))});
  layout->addWidget(remember_);
  if (url.starts_with("ws://")) {
    auto* warning = widgets::makeNote(this, "tokenWarning", tr("Warning"));
    widgets::showOutcome(
        *warning, tr("This connection is not encrypted: anyone who monitors the network can read the token."),
        true);
    layout->addWidget(warning);
  }
  auto* buttons = new QDialogButtonBox(this);
  auto* accept = buttons->addButton(tr("&Connect"), QDialogButtonBox::AcceptRole);
  accept->setObjectName(QStringLiteral("tokenAccept"));
  accept->setEnabled(false);
  buttons->addButton(tr("&Disconnect"), QDialogButtonBox::RejectRole)
      ->setObjectName(QStringLiteral("tokenReject"));
  layout->addWidget(buttons);
  connect(token_, &QLineEdit::textChanged, accept,
          [accept](const QString& entered) { accept->setEnabled(!entered.trimmed().isEmpty()); });
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  setMinimumWidth(fontMetrics().averageCharWidth() * 70);
}

std::string TokenDialog::token() const {
  return token_->text().trimmed().toStdString();
}

bool TokenDialog::remembers() const {
  return remember_->isChecked();
}

}  // namespace app
