// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drive/ConnectDialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QToolButton>

#include "robotcontrol/Driving.pb.h"
#include "robotlink/arcos/stream/StreamUrl.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/CommandTable.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/Icon.h"
#include "widgets/TypedStreams.h"
#include "widgets/drive/LinkWords.h"

namespace widgets {
namespace {

namespace arcos = robotlink::arcos;

constexpr char kFirstAddress[] = "tcp://localhost:8101";

QHBoxLayout* makeRow(QWidget* widget) {
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  return row;
}

void colorText(QLabel& label, bool bad) {
  QPalette colors = label.parentWidget()->palette();
  colors.setColor(QPalette::WindowText, colorOf(bad ? Meaning::kBad : Meaning::kMuted, colors));
  label.setPalette(colors);
}

QString meaningOf(const arcos::StreamUrl& url) {
  if (const auto* tcp = std::get_if<arcos::TcpAddress>(&url))
    return ConnectDialog::tr("over the network: %1, port %2")
        .arg(QString::fromStdString(tcp->host))
        .arg(tcp->port);
  const auto& serial = std::get<arcos::SerialAddress>(url);
  return ConnectDialog::tr("over the serial line %1 at %2 baud")
      .arg(QString::fromStdString(serial.device))
      .arg(serial.baud);
}

}  // namespace

ConnectDialog::ConnectDialog(robotlink::Session& session, robotlink::CommandTable& commands, Choices choices,
                             QWidget* parent)
    : QDialog(parent),
      session_(session),
      commands_(commands),
      choices_(std::move(choices)),
      recent_(choices_.recent) {
  setObjectName(QStringLiteral("connectDialog"));
  setWindowTitle(tr("Connect to a robot"));
  setWindowIcon(icon("connect"));
  createViews();
  connectSignals();
  listRecent();
  address_->setCurrentText(recent_.isEmpty() ? QLatin1String(kFirstAddress) : recent_.first());
  readAddress();
}

void ConnectDialog::createViews() {
  address_ = new QComboBox(this);
  describe(*address_,
           {"connectAddress", tr("Address"),
            tr("HOST:PORT, tcp://HOST[:PORT] or serial://DEVICE[?baud=RATE]; the list has the recent ones")});
  address_->setEditable(true);
  address_->setInsertPolicy(QComboBox::NoInsert);
  address_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  meaning_ = new QLabel(this);
  describe(*meaning_, {"connectMeaning", tr("What the address means"), {}});
  meaning_->setWordWrap(true);
  auto* form = new QFormLayout;
  form->addRow(tr("&Address:"), address_);
  form->addRow(QString(), meaning_);
  form->addRow(tr("Line:"), createKinds());
  form->addRow(QString(), pages_);
  form->addRow(tr("&Map:"), createMap());
  form->addRow(tr("&Layout:"), createLayouts());
  state_ = new QLabel(this);
  describe(*state_, {"connectState", tr("State of the connection"), {}});
  state_->setWordWrap(true);
  state_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  state_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  progress_ = new QProgressBar(this);
  progress_->setObjectName(QStringLiteral("connectProgress"));
  progress_->setRange(0, 0);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(8);
  QSizePolicy keepsPlace = progress_->sizePolicy();
  keepsPlace.setRetainSizeWhenHidden(true);
  progress_->setSizePolicy(keepsPlace);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect_ = buttons->addButton(tr("&Connect"), QDialogButtonBox::ActionRole);
  describe(*connect_,
           {"connectButton", tr("Connect"), tr("Opens the line and starts the robot's program here")});
  connect_->setIcon(icon("connect"));
  connect_->setDefault(true);
  connectNow_ = buttons->addButton(tr("Connect &now"), QDialogButtonBox::ActionRole);
  describe(*connectNow_,
           {"connectNow", tr("Connect now"), tr("Tries again at once, instead of after the pause")});
  connectNow_->setVisible(false);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  setMinimumWidth(fontMetrics().averageCharWidth() * 64);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(state_);
  layout->addWidget(progress_);
  layout->addWidget(buttons);
  showState(tr("A lost line is reopened automatically."), false, false);
}

QWidget* ConnectDialog::createKinds() {
  auto* kinds = new QWidget(this);
  tcp_ = new QRadioButton(tr("&Network (TCP)"), kinds);
  describe(*tcp_, {"connectTcp", tr("Network (TCP)"),
                   tr("A simulated robot, or one whose line a computer forwards")});
  serial_ = new QRadioButton(tr("&Serial"), kinds);
  describe(*serial_, {"connectSerial", tr("Serial"), tr("A robot at a serial port of this computer")});
  QHBoxLayout* row = makeRow(kinds);
  row->addWidget(tcp_);
  row->addWidget(serial_);
  row->addStretch(1);
  pages_ = new QStackedWidget(this);
  pages_->addWidget(createTcp());
  pages_->addWidget(createSerial());
  return kinds;
}

QWidget* ConnectDialog::createTcp() {
  auto* page = new QWidget(this);
  host_ = new QLineEdit(page);
  describe(*host_, {"connectHost", tr("Host"), tr("Name or address of the computer; localhost is this one")});
  tcpPort_ = new QSpinBox(page);
  describe(*tcpPort_, {"connectPort", tr("Port"), tr("8101 is the first robot's, 8102 the next one's")});
  tcpPort_->setRange(1, 65535);
  tcpPort_->setValue(arcos::kDefaultPort);
  QHBoxLayout* row = makeRow(page);
  row->addWidget(host_, 1);
  row->addWidget(new QLabel(tr("port"), page));
  row->addWidget(tcpPort_);
  return page;
}

QWidget* ConnectDialog::createSerial() {
  auto* page = new QWidget(this);
  port_ = new QComboBox(page);
  describe(*port_,
           {"connectDevice", tr("Serial port"), tr("Ports of this computer; another one can be typed")});
  port_->setEditable(true);
  port_->setInsertPolicy(QComboBox::NoInsert);
  port_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  auto* again = new QToolButton(page);
  describe(*again, {"connectLookAgain", tr("Look again"), tr("Searches for serial ports")});
  again->setIcon(icon("refresh"));
  connect(again, &QToolButton::clicked, this, &ConnectDialog::listPorts);
  baud_ = new QComboBox(page);
  describe(*baud_, {"connectBaud", tr("Baud"), tr("As set in the robot; Pioneers start with 9600")});
  for (const int rate : {9600, 19200, 38400, 57600, 115200}) baud_->addItem(QString::number(rate), rate);
  QHBoxLayout* row = makeRow(page);
  row->addWidget(port_, 1);
  row->addWidget(again);
  row->addWidget(new QLabel(tr("baud"), page));
  row->addWidget(baud_);
  return page;
}

QWidget* ConnectDialog::createMap() {
  auto* widget = new QWidget(this);
  map_ = new QLineEdit(choices_.map, widget);
  describe(*map_,
           {"connectMap", tr("Map"), tr("Map of where the robot drives, for localization; may be empty")});
  map_->setPlaceholderText(tr("none: no localization in a map"));
  map_->setClearButtonEnabled(true);
  auto* browse = new QToolButton(widget);
  describe(*browse, {"connectBrowse", tr("Choose a map"), tr("Chooses a .map file")});
  browse->setIcon(icon("open"));
  connect(browse, &QToolButton::clicked, this, [this] {
    const QString file = QFileDialog::getOpenFileName(this, tr("Choose a map"), map_->text(),
                                                      tr("Maps (*.map);;All files (*)"));
    if (!file.isEmpty()) map_->setText(file);
  });
  QHBoxLayout* row = makeRow(widget);
  row->addWidget(map_, 1);
  row->addWidget(browse);
  return widget;
}

QWidget* ConnectDialog::createLayouts() {
  layout_ = new QComboBox(this);
  describe(*layout_,
           {"connectLayout", tr("Layout"), tr("Which process of the robot's program does which tasks")});
  layout_->addItem(tr("of the robot"), QString());
  for (const auto& [name, value] : choices_.layouts) layout_->addItem(name, value);
  return layout_;
}

void ConnectDialog::connectSignals() {
  connect(address_, &QComboBox::editTextChanged, this, &ConnectDialog::readAddress);
  connect(tcp_, &QRadioButton::clicked, this, &ConnectDialog::writeAddress);
  connect(serial_, &QRadioButton::clicked, this, [this] {
    listPorts();
    writeAddress();
  });
  connect(host_, &QLineEdit::textEdited, this, &ConnectDialog::writeAddress);
  connect(tcpPort_, QOverload<int>::of(&QSpinBox::valueChanged), this, &ConnectDialog::writeAddress);
  connect(port_, &QComboBox::editTextChanged, this, &ConnectDialog::writeAddress);
  connect(baud_, QOverload<int>::of(&QComboBox::activated), this, &ConnectDialog::writeAddress);
  connect(connect_, &QPushButton::clicked, this, &ConnectDialog::connectRobot);
  connect(connectNow_, &QPushButton::clicked, this, &ConnectDialog::connectNow);
}

void ConnectDialog::showEvent(QShowEvent* event) {
  listPorts();
  QDialog::showEvent(event);
}

void ConnectDialog::listPorts() {
  if (!choices_.serialPorts) return;
  const QSignalBlocker quiet(port_);
  const QString typed = port_->currentText();
  port_->clear();
  const auto ports = choices_.serialPorts();
  for (const auto& port : ports) {
    const QString device = QString::fromStdString(port.device);
    port_->addItem(device, device);
    port_->setItemData(port_->count() - 1, QString::fromStdString(port.description), Qt::ToolTipRole);
  }
  port_->lineEdit()->setPlaceholderText(ports.empty() ? tr("no serial port found; type its path")
                                                      : QString());
  port_->setCurrentText(typed.isEmpty() && !ports.empty() ? QString::fromStdString(ports.front().device)
                                                          : typed);
  const int found = port_->findData(port_->currentText());
  port_->setToolTip(found < 0 ? tr("Ports of this computer; another one can be typed")
                              : port_->itemData(found, Qt::ToolTipRole).toString());
}

void ConnectDialog::listRecent() {
  const QSignalBlocker quiet(address_);
  const QString typed = address_->currentText();
  address_->clear();
  address_->addItems(recent_);
  address_->setCurrentText(typed);
}

void ConnectDialog::readAddress() {
  const auto url = arcos::parseUrl(address_->currentText().trimmed().toStdString());
  meaning_->setText(url ? meaningOf(*url) : QString::fromStdString(url.error().text));
  colorText(*meaning_, !url);
  connect_->setEnabled(url.has_value() && wanted_.isEmpty());
  if (!url) return;
  const QSignalBlocker quietHost(host_), quietPort(tcpPort_), quietDevice(port_), quietBaud(baud_);
  if (const auto* tcp = std::get_if<arcos::TcpAddress>(&*url)) {
    tcp_->setChecked(true);
    host_->setText(QString::fromStdString(tcp->host));
    tcpPort_->setValue(tcp->port);
  } else {
    const auto& serial = std::get<arcos::SerialAddress>(*url);
    serial_->setChecked(true);
    port_->setCurrentText(QString::fromStdString(serial.device));
    if (baud_->findData(serial.baud) < 0) baud_->addItem(QString::number(serial.baud), serial.baud);
    baud_->setCurrentIndex(baud_->findData(serial.baud));
  }
  pages_->setCurrentIndex(tcp_->isChecked() ? 0 : 1);
}

void ConnectDialog::writeAddress() {
  const bool tcp = tcp_->isChecked();
  pages_->setCurrentIndex(tcp ? 0 : 1);
  const arcos::StreamUrl url =
      tcp ? arcos::StreamUrl(arcos::TcpAddress{host_->text().trimmed().toStdString(),
                                               static_cast<std::uint16_t>(tcpPort_->value())})
          : arcos::StreamUrl(arcos::SerialAddress{port_->currentText().trimmed().toStdString(),
                                                  baud_->currentData().toInt()});
  const QSignalBlocker quiet(address_);
  address_->setCurrentText(QString::fromStdString(arcos::toString(url)));
  const auto checked = arcos::parseUrl(address_->currentText().toStdString());
  meaning_->setText(checked ? meaningOf(*checked) : QString::fromStdString(checked.error().text));
  colorText(*meaning_, !checked);
  connect_->setEnabled(checked.has_value() && wanted_.isEmpty());
}

QString ConnectDialog::map() const {
  return map_->text().trimmed();
}

void ConnectDialog::connectRobot() {
  const auto url = arcos::parseUrl(address_->currentText().trimmed().toStdString());
  if (!url) return readAddress();
  const std::string address = arcos::toString(*url);
  wanted_ = QString::fromStdString(address);
  recent_.removeAll(wanted_);
  recent_.prepend(wanted_);
  while (recent_.size() > kMaxRecent) recent_.removeLast();
  listRecent();
  Q_EMIT recentChanged();
  const auto done = commands_.run(
      "robot.connect", {address, layout_->currentData().toString().toStdString(), map().toStdString()});
  if (!done) return fail(QString::fromStdString(done.error().text));
  connect_->setEnabled(false);
  showState(tr("Opening %1…").arg(wanted_), false, true);
}

void ConnectDialog::connectNow() {
  if (const auto done = commands_.run("robot.connect-now"); !done)
    showState(QString::fromStdString(done.error().text), true, true);
}

void ConnectDialog::fail(const QString& reason) {
  if (wanted_.isEmpty()) return;
  wanted_.clear();
  showState(reason, true, false);
  readAddress();
}

void ConnectDialog::tick() {
  if (wanted_.isEmpty()) return;
  for (const std::string& robot : session_.robots())
    subscription_.want(session_, robot, {robotlink::kLinkStatus.name});
  for (const auto* message :
       latestOfType(session_.store(), {}, "robotcontrol.LinkStatus", session_.timeline().newest())) {
    const auto* status =
        message == nullptr ? nullptr : dynamic_cast<const robotcontrol::LinkStatus*>(message->value.get());
    if (status == nullptr || QString::fromStdString(status->address()) != wanted_) continue;
    const LinkWords words = linkWords(*status, 0);
    const QString text = QString::fromStdString(status->text());
    if (status->state() == robotcontrol::LinkStatus::CONNECTED) {
      const QString address = std::exchange(wanted_, QString());
      showState(tr("Connected to %1.").arg(words.robot.isEmpty() ? address : words.robot), false, false);
      readAddress();
      accept();
      Q_EMIT connected(address);
      return;
    }
    showState(text.isEmpty() ? words.state : text, words.meaning == Meaning::kBad, true);
    return connectNow_->setVisible(status->state() == robotcontrol::LinkStatus::LOST);
  }
}

void ConnectDialog::showState(const QString& text, bool bad, bool busy) {
  state_->setText(text);
  connectNow_->setVisible(false);
  colorText(*state_, bad);
  progress_->setVisible(busy);
}

}  // namespace widgets
