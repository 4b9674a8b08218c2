// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/remote/OfferDialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/core/remote/SessionOffer.h"
#include "app/robotcontrol/remote/DialogParts.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/foxglove/protocol/MessageCodec.h"
#include "robotlink/foxglove/server/ListenAddress.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"

namespace app {
namespace {

constexpr int kClientLines = 5;

QString joined(const std::vector<std::string>& texts, const QString& separator) {
  QStringList list;
  for (const std::string& text : texts) list << QString::fromStdString(text);
  return list.join(separator);
}

}  // namespace

OfferDialog::OfferDialog(robotlink::CommandTable& commands, const SessionOffer& offer, QWidget* parent)
    : QDialog(parent), commands_(commands), offer_(offer) {
  setObjectName(QStringLiteral("offerDialog"));
  setWindowTitle(tr("Offer this session"));
  auto* layout = new QVBoxLayout(this);
  auto* what =
      new QLabel(tr("Others can watch and steer what is open here: with RobotControl (Robot > Connect…), "
                    "robotctl watch, or any client of the Foxglove WebSocket protocol."),
                 this);
  what->setWordWrap(true);
  layout->addWidget(what);
  createFields();
  createClients();
  auto* buttons = new QDialogButtonBox(this);
  offerButton_ = buttons->addButton(tr("&Offer"), QDialogButtonBox::ActionRole);
  offerButton_->setObjectName(QStringLiteral("offerButton"));
  offerButton_->setDefault(true);
  buttons->addButton(QDialogButtonBox::Close);
  layout->addWidget(buttons);
  connect(offerButton_, &QPushButton::clicked, this, &OfferDialog::toggle);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  setMinimumWidth(fontMetrics().averageCharWidth() * 72);
  showOffer();
}

void OfferDialog::createFields() {
  auto* form = new QFormLayout;
  host_ = new QLineEdit(QStringLiteral("127.0.0.1"), this);
  widgets::describe(*host_, {"offerAddress", tr("Address"),
                             tr("The address of this machine at which others connect; 127.0.0.1 is for "
                                "programs on this machine only")});
  port_ = new QSpinBox(this);
  widgets::describe(*port_, {"offerPort", tr("Port"), tr("Usually 8765; 0: any free port")});
  port_->setRange(0, 65535);
  port_->setValue(robotlink::websocket::kDefaultPort);
  auto* where = new QHBoxLayout;
  where->addWidget(host_, 1);
  where->addWidget(new QLabel(tr("port"), this));
  where->addWidget(port_);
  form->addRow(tr("&Address:"), where);
  static_cast<QLabel*>(form->labelForField(where))->setBuddy(host_);
  url_ = new QLineEdit(this);
  widgets::describe(*url_, {"offerUrl", tr("URL for others"), tr("What others connect to")});
  url_->setReadOnly(true);
  copy_ = makePushButton(this, {"offerCopy", tr("&Copy"), tr("Copies the URL to the clipboard")}, "copy");
  connect(copy_, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(url_->text()); });
  auto* others = new QHBoxLayout;
  others->addWidget(url_, 1);
  others->addWidget(copy_);
  form->addRow(tr("Others connect to:"), others);
  form->addRow(tr("They need a token:"), createTokens());
  static_cast<QVBoxLayout*>(layout())->addLayout(form);
  state_ = widgets::makeNote(this, "offerState", tr("State"));
  layout()->addWidget(state_);
  notes_ = widgets::makeNote(this, "offerNotes", tr("How it is protected"));
  notes_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  layout()->addWidget(notes_);
}

QLayout* OfferDialog::createTokens() {
  auto* row = new QHBoxLayout;
  const auto add = [&](const char* name, const QString& text, const QString& help,
                       const std::string& (SessionOffer::*token)() const) {
    auto* button = new QPushButton(widgets::icon("copy"), text, this);
    widgets::describe(*button, {name, QString(text).remove(QLatin1Char('&')), help});
    connect(button, &QPushButton::clicked, this, [this, token] {
      QGuiApplication::clipboard()->setText(QString::fromStdString((offer_.*token)()));
    });
    row->addWidget(button);
    return button;
  };
  copyControl_ = add("offerCopyControl", tr("Copy the token to &control"),
                     tr("Copies the token for full control to the clipboard"), &SessionOffer::controlToken);
  copyWatch_ =
      add("offerCopyWatch", tr("Copy the token to &watch"),
          tr("Copies the token for watching and STOP only to the clipboard"), &SessionOffer::watchToken);
  row->addStretch(1);
  return row;
}

void OfferDialog::createClients() {
  using Kind = widgets::ColumnKind;
  clients_ = makeList(this, {"offerClients", tr("Who is connected"), {}},
                      {{tr("Who is connected"), Kind::kText},
                       {tr("Address"), Kind::kName, QStringLiteral("192.168.100.100:50000")},
                       {tr("Is sent"), Kind::kName, QStringLiteral("100.0 MB/s")},
                       {tr("Waits"), Kind::kName, QStringLiteral("100.0 MB")}},
                      kClientLines);
  clients_->setSelectionMode(QAbstractItemView::NoSelection);
  static_cast<QVBoxLayout*>(layout())->addWidget(clients_, 1);
  refused_ = widgets::makeNote(this, "offerRefused", tr("Who was refused"));
  layout()->addWidget(refused_);
}

QString OfferDialog::address() const {
  const QString host = host_->text().trimmed();
  const bool isIpv6 = host.contains(QLatin1Char(':')) && !host.startsWith(QLatin1Char('['));
  return (isIpv6 ? QStringLiteral("[%1]:%2") : QStringLiteral("%1:%2")).arg(host).arg(port_->value());
}

void OfferDialog::setAddress(const QString& address) {
  const auto parsed = robotlink::websocket::parseListenAddress(address.toStdString());
  if (!parsed) return;
  host_->setText(QString::fromStdString(parsed->address));
  port_->setValue(parsed->port);
}

void OfferDialog::toggle() {
  widgets::setMeaning(*state_, {});
  state_->clear();
  const auto done = offer_.isOffered() ? commands_.run("session.stop-offering")
                                       : commands_.run("session.offer", {address().toStdString()});
  if (!done) widgets::showOutcome(*state_, QString::fromStdString(done.error().text), true);
  showOffer();
}

void OfferDialog::showOffer() {
  const bool offered = offer_.isOffered();
  wasOffered_ = offered;
  host_->setEnabled(!offered);
  port_->setEnabled(!offered);
  url_->setText(QString::fromStdString(offer_.url()));
  url_->setPlaceholderText(tr("not offered"));
  url_->setToolTip(tr("What others connect to: %1").arg(joined(offer_.urls(), QStringLiteral(", "))));
  copy_->setEnabled(offered);
  copyControl_->setEnabled(!offer_.controlToken().empty());
  copyWatch_->setEnabled(!offer_.watchToken().empty());
  notes_->setText(joined(offer_.notes(), QStringLiteral("\n")));
  offerButton_->setText(offered ? tr("Stop &offering") : tr("&Offer"));
}

void OfferDialog::tick() {
  if (!isVisible()) return;
  if (offer_.isOffered() != wasOffered_ || url_->text() != QString::fromStdString(offer_.url())) {
    widgets::setMeaning(*state_, {});
    state_->clear();
    showOffer();
  }
  showClients();
  const auto& reports = offer_.reports();
  refused_->setText(reports.empty() ? QString() : QString::fromStdString(reports.back()));
  // Notes that wrap do not make a window higher by themselves: the fingerprint would be cut off.
  const int needed = layout()->minimumHeightForWidth(width());
  if (height() < needed) resize(width(), needed);
}

void OfferDialog::showClients() {
  const auto& clients = offer_.clients();
  const int count = static_cast<int>(clients.size());
  setRowCount(*clients_, count);
  const QLocale locale;
  const auto size = [&locale](qint64 bytes) {
    return locale.formattedDataSize(bytes, 1, QLocale::DataSizeSIFormat);
  };
  for (int i = 0; i < count; ++i) {
    const auto& client = clients[static_cast<std::size_t>(i)];
    QTreeWidgetItem& row = *clients_->topLevelItem(i);
    const QString name = client.name.empty() ? tr("unnamed") : QString::fromStdString(client.name);
    row.setText(0, client.isReadOnly ? tr("%1 (watch only)").arg(name) : name);
    row.setText(1, QString::fromStdString(client.address));
    row.setText(2, tr("%1/s").arg(size(static_cast<qint64>(client.bytesPerSecond))));
    row.setText(3, client.waitingBytes == 0 ? QString() : size(static_cast<qint64>(client.waitingBytes)));
  }
  if (!offer_.isOffered()) return;
  state_->setText(count == 0 ? tr("Offered. No client is connected yet.")
                             : widgets::counted(clients.size(), tr("Offered. 1 client is connected."),
                                                tr("Offered. %1 clients are connected.")));
}

}  // namespace app
