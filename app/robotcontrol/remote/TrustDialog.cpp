// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/remote/TrustDialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "robotlink/foxglove/security/KnownServers.h"
#include "widgets/Controls.h"
#include "widgets/Icon.h"

namespace app {

using robotlink::websocket::ServerObjection;

TrustDialog::TrustDialog(const std::string& url, const ServerObjection& objection, QWidget* parent)
    : QDialog(parent) {
  setObjectName(QStringLiteral("trustDialog"));
  const bool isNew = objection.kind == ServerObjection::Kind::kNewCertificate;
  const QString where = QString::fromStdString(url);
  setWindowTitle(isNew ? tr("A new robot") : tr("Not the same robot as before?"));
  setWindowIcon(widgets::icon(isNew ? "connect" : "warning"));
  new QVBoxLayout(this);
  if (isNew) {
    addText("trustText",
            tr("This computer has never connected to the robot at %1. Is this the fingerprint that the robot "
               "printed at its start? If so, it is remembered for the next connections.")
                .arg(where));
  } else {
    addText(
        "trustText",
        tr("The certificate of the robot at %1 has changed. Either the robot was set up again, or someone "
           "else is answering in its place and would see the token and everything that is sent.")
            .arg(where));
    widgets::setMeaning(*findChild<QLabel*>(QStringLiteral("trustText")), widgets::Meaning::kBad);
  }
  addFingerprints(objection);
  if (!isNew) {
    const QString file = QString::fromStdString(robotlink::websocket::KnownServers::defaultFile().string());
    addText("trustFile", tr("The known robots are in %1.").arg(file));
  }
  addButtons(isNew);
  setMinimumWidth(fontMetrics().averageCharWidth() * 84);
}

void TrustDialog::addText(const char* name, const QString& text) {
  auto* label = widgets::makeNote(this, name, tr("What is asked"));
  label->setText(text);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  layout()->addWidget(label);
}

void TrustDialog::addFingerprints(const ServerObjection& objection) {
  auto* form = new QFormLayout;
  const auto add = [&](const char* name, const QString& title, const std::string& fingerprint) {
    auto* field = new QLineEdit(QString::fromStdString(fingerprint), this);
    widgets::describe(*field, {name, title, {}});
    field->setReadOnly(true);
    field->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    field->setCursorPosition(0);
    form->addRow(title + QLatin1Char(':'), field);
  };
  if (!objection.knownFingerprint.empty()) add("trustKnown", tr("Before"), objection.knownFingerprint);
  add("trustFingerprint", objection.knownFingerprint.empty() ? tr("Fingerprint") : tr("Now"),
      objection.fingerprint);
  static_cast<QVBoxLayout*>(layout())->addLayout(form);
}

void TrustDialog::addButtons(bool isNew) {
  auto* buttons = new QDialogButtonBox(this);
  auto* trust = buttons->addButton(isNew ? tr("&Trust and connect") : tr("&Replace and connect"),
                                   QDialogButtonBox::AcceptRole);
  trust->setObjectName(QStringLiteral("trustAccept"));
  auto* no = buttons->addButton(tr("&Disconnect"), QDialogButtonBox::RejectRole);
  no->setObjectName(QStringLiteral("trustReject"));
  if (!isNew) {
    auto* sure =
        new QCheckBox(tr("The robot was set up again, and &printed the fingerprint shown here"), this);
    sure->setObjectName(QStringLiteral("trustSure"));
    trust->setEnabled(false);
    connect(sure, &QCheckBox::toggled, trust, &QPushButton::setEnabled);
    layout()->addWidget(sure);
  }
  no->setDefault(true);
  layout()->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  no->setFocus();
}

}  // namespace app
