// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/remote/RemoteDialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/core/remote/RemoteRobots.h"
#include "app/robotcontrol/remote/DialogParts.h"
#include "app/robotcontrol/remote/FoundRobots.h"
#include "robotlink/base/Error.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/foxglove/client/ServerUrl.h"
#include "widgets/Controls.h"
#include "widgets/Icon.h"

namespace app {
namespace {

using Phase = robotlink::websocket::ConnectionState::Phase;

constexpr int kMaxRemembered = 10;
constexpr int kConnectionLines = 4;

QString joined(const std::vector<std::string>& robots) {
  QStringList names;
  for (const std::string& robot : robots) names << QString::fromStdString(robot);
  return names.join(QStringLiteral(", "));
}

/// Empty: the whole stream is here.
QString missingOf(const robotlink::websocket::RemoteStream& stream) {
  const auto thinned = stream.thinned.value_or(0), dropped = stream.dropped.value_or(0);
  if (!stream.isDecoded)
    return RemoteDialog::tr("not decoded: %1").arg(QString::fromStdString(stream.encoding));
  if (thinned + dropped == 0) return {};
  return dropped == 0 ? RemoteDialog::tr("%1 thinned").arg(thinned)
                      : RemoteDialog::tr("%1 thinned, %2 lost").arg(thinned).arg(dropped);
}

}  // namespace

RemoteDialog::RemoteDialog(robotlink::CommandTable& commands, const RemoteRobots& robots, QWidget* parent)
    : QDialog(parent), commands_(commands), robots_(robots) {
  setObjectName(QStringLiteral("remoteDialog"));
  setWindowTitle(tr("Connect to robots"));
  setWindowIcon(widgets::icon("connect"));
  auto* layout = new QVBoxLayout(this);
  auto* what = new QLabel(tr("Connects remote robots: there, robotctl sim or robotctl run was started with "
                             "--listen, or somebody chose Robot > Offer this session. They are shown in "
                             "addition to those that are open here. Where only robotctl platform was "
                             "started, the program runs here, in place of what is open. Robots that announce "
                             "themselves are listed; click one to use its address."),
                          this);
  what->setWordWrap(true);
  layout->addWidget(what);
  createFound();
  createFields();
  createState();
  createConnections();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  setMinimumWidth(fontMetrics().averageCharWidth() * 92);
  // The layout's minimum knows too little of wrapped text.
  const QMargins margins = layout->contentsMargins();
  what->setMinimumHeight(what->heightForWidth(minimumWidth() - margins.left() - margins.right()));
  url_->lineEdit()->selectAll();
}

void RemoteDialog::createFound() {
  found_ = new FoundRobots(this);
  static_cast<QVBoxLayout*>(layout())->addWidget(found_, 1);
  connect(found_, &FoundRobots::picked, this, &RemoteDialog::take);
  connect(found_, &FoundRobots::wanted, this, [this](const auto& robots) {
    take(robots);
    connect_->click();
  });
}

void RemoteDialog::take(const robotlink::dds::AnnouncedRobots& robots) {
  url_->setEditText(QString::fromStdString(robots.url()));
  const bool isBody = std::ranges::all_of(robots.robots, [](const auto& robot) { return robot.isBody; });
  program_->setCurrentIndex(isBody ? 1 : 0);
}

void RemoteDialog::createFields() {
  auto* form = new QFormLayout;
  url_ = new QComboBox(this);
  widgets::describe(*url_, {"remoteUrl", tr("URL"), tr("ws://HOST[:PORT]; the list has the recent ones")});
  url_->setEditable(true);
  url_->setInsertPolicy(QComboBox::NoInsert);
  url_->setEditText(QStringLiteral("ws://127.0.0.1:8765"));
  form->addRow(tr("&URL:"), url_);
  QLayout* token = createToken();
  form->addRow(tr("&Token:"), token);
  static_cast<QLabel*>(form->labelForField(token))->setBuddy(token_);
  program_ = new QComboBox(this);
  widgets::describe(*program_,
                    {"remoteProgram", tr("Program"),
                     tr("Where the robot's program runs: there, where it is watched and steered; or here, "
                        "if there is only the body (robotctl platform)")});
  program_->addItem(tr("there: it is watched and steered"));
  program_->addItem(tr("here: only the body is there"));
  form->addRow(tr("&Program:"), program_);
  QLayout* limits = createLimits();
  form->addRow(tr("&Images:"), limits);
  static_cast<QLabel*>(form->labelForField(limits))->setBuddy(images_);
  static_cast<QVBoxLayout*>(layout())->addLayout(form);
  connect(url_, &QComboBox::editTextChanged, this, &RemoteDialog::showProgram);
}

void RemoteDialog::createState() {
  state_ = makeState(this, "remoteState", 3);
  layout()->addWidget(state_);
  progress_ = new QProgressBar(this);
  progress_->setObjectName(QStringLiteral("remoteProgress"));
  progress_->setRange(0, 0);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(8);
  hideInPlace(*progress_);
  layout()->addWidget(progress_);
}

QLayout* RemoteDialog::createToken() {
  token_ = new QLineEdit(this);
  widgets::describe(*token_,
                    {"remoteToken", tr("Token"),
                     tr("The robot prints it when it creates it. A robot that needs one asks for it; "
                        "it can be remembered then")});
  token_->setEchoMode(QLineEdit::PasswordEchoOnEdit);
  forget_ = makePushButton(
      this, {"remoteForgetToken", tr("&Forget"), tr("Forgets the token that is remembered for this robot")});
  forget_->setAccessibleName(tr("Forget the token"));
  connect(forget_, &QPushButton::clicked, this, &RemoteDialog::forgetToken);
  connect(url_, &QComboBox::editTextChanged, this, &RemoteDialog::showToken);
  auto* row = new QHBoxLayout;
  row->addWidget(token_, 1);
  row->addWidget(forget_);
  showToken();
  return row;
}

QLayout* RemoteDialog::createLimits() {
  images_ = new QComboBox(this);
  widgets::describe(*images_,
                    {"remoteImages", tr("Images"),
                     tr("How the robots at this URL send images; JPEG needs a tenth of the bandwidth")});
  images_->addItem(tr("raw, or JPEG if the link is too slow"), QStringLiteral("auto"));
  images_->addItem(tr("always raw"), QStringLiteral("raw"));
  images_->addItem(tr("as JPEG"), QStringLiteral("jpeg"));
  images_->addItem(tr("as PNG"), QStringLiteral("png"));
  rate_ = new QDoubleSpinBox(this);
  widgets::describe(*rate_,
                    {"remoteImageRate", tr("Images a second"),
                     tr("Maximum images per second of each stream from the robots at this URL. Images left "
                        "out count as thinned")});
  rate_->setRange(0, 1000);
  rate_->setDecimals(1);
  rate_->setSuffix(tr(" a second"));
  rate_->setSpecialValueText(tr("all"));
  rate_->setKeyboardTracking(false);
  limit_ = new QDoubleSpinBox(this);
  widgets::describe(*limit_, {"remoteLimit", tr("Limit"),
                              tr("Maximum data rate of the robots at this URL. Newer images and states "
                                 "replace those still waiting; texts and results arrive late")});
  limit_->setRange(0, 1e6);
  limit_->setDecimals(0);
  limit_->setSingleStep(100);
  limit_->setSuffix(tr(" kB/s"));
  limit_->setSpecialValueText(tr("no limit"));
  limit_->setKeyboardTracking(false);
  auto* label = new QLabel(tr("at &most"), this);
  label->setBuddy(limit_);
  auto* row = new QHBoxLayout;
  row->addWidget(images_, 1);
  row->addWidget(rate_);
  row->addWidget(label);
  row->addWidget(limit_);
  connect(images_, QOverload<int>::of(&QComboBox::activated), this, &RemoteDialog::changeLimits);
  for (QDoubleSpinBox* box : {rate_, limit_})
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &RemoteDialog::changeLimits);
  connect(url_, &QComboBox::editTextChanged, this, &RemoteDialog::showLimits);
  return row;
}

void RemoteDialog::showLimits() {
  const std::string url = enteredUrl();
  const bool isRecent =
      std::ranges::any_of(recent_, [&](const Recent& one) { return one.url == QString::fromStdString(url); });
  if (!isRecent && !isConnected(url)) return;
  const LinkLimits limits = robots_.limits(url);
  const QSignalBlocker quietRate(rate_), quietLimit(limit_);
  rate_->setValue(limits.imagesPerSecond);
  limit_->setValue(1e-3 * limits.bytesPerSecond);
  images_->setCurrentIndex(images_->findData(QString::fromLatin1(nameOf(limits.images))));
}

bool RemoteDialog::isConnected(const std::string& url) const {
  if (!hosted_.isEmpty() && hosted_ == QString::fromStdString(url)) return true;
  const auto connections = robots_.connections();
  return std::ranges::count(connections, url, &RemoteRobots::Connection::url) > 0;
}

void RemoteDialog::changeLimits() {
  if (const std::string url = enteredUrl(); isConnected(url)) applyLimits(url);
}

void RemoteDialog::applyLimits(const std::string& url) {
  for (QDoubleSpinBox* box : {rate_, limit_}) {
    const QSignalBlocker quiet(box);
    box->interpretText();
  }
  const auto done = commands_.run(
      "remote.limit",
      {url, 1e3 * limit_->value(), images_->currentData().toString().toStdString(), rate_->value()});
  if (!done) fail(QString::fromStdString(done.error().text));
}

std::string RemoteDialog::enteredUrl() const {
  QString url = url_->currentText().trimmed();
  if (!url.contains(QStringLiteral("://"))) url.prepend(QStringLiteral("ws://"));
  const auto parsed = robotlink::websocket::parseServerUrl(url.toStdString());
  return parsed ? toString(*parsed) : std::string();
}

void RemoteDialog::showProgram() {
  const QString url = QString::fromStdString(enteredUrl());
  const auto known = std::ranges::find_if(recent_, [&](const Recent& one) { return one.url == url; });
  if (known != recent_.end()) program_->setCurrentIndex(known->isHosted ? 1 : 0);
}

void RemoteDialog::showToken() {
  const bool isRemembered = RemoteRobots::hasToken(enteredUrl());
  token_->setPlaceholderText(isRemembered ? tr("remembered") : tr("none"));
  forget_->setVisible(isRemembered);
}

void RemoteDialog::forgetToken() {
  const auto done = commands_.run("remote.forget-token", {enteredUrl()});
  if (!done) fail(QString::fromStdString(done.error().describe()));
  showToken();
}

void RemoteDialog::showEvent(QShowEvent* event) {
  showToken();
  showLimits();
  QDialog::showEvent(event);
}

void RemoteDialog::createConnections() {
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  connect_ = makePushButton(this, {"remoteConnect", tr("&Connect"), tr("Connects to the server at this URL")},
                            "connect");
  connect_->setDefault(true);
  disconnect_ =
      makePushButton(this, {"remoteDisconnect", tr("&Disconnect"),
                            tr("Ends the selected connection and removes its robots from the window")});
  row->addWidget(connect_);
  row->addWidget(disconnect_);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
  using Kind = widgets::ColumnKind;
  connections_ = makeList(this, {"remoteConnections", tr("Connections"), {}},
                          {{tr("State"), Kind::kText},
                           {tr("Robots"), Kind::kName, QStringLiteral("red1, red2, blue1")},
                           {tr("Address"), Kind::kName, QStringLiteral("ws://192.168.100.100:8765")}},
                          kConnectionLines);
  connections_->setRootIsDecorated(true);
  static_cast<QVBoxLayout*>(layout())->addWidget(connections_, 1);
  connect(connect_, &QPushButton::clicked, this, &RemoteDialog::connectUrl);
  connect(url_->lineEdit(), &QLineEdit::returnPressed, connect_, &QPushButton::click);
  connect(disconnect_, &QPushButton::clicked, this, &RemoteDialog::disconnectSelected);
  connect(connections_, &QTreeWidget::itemSelectionChanged, this, &RemoteDialog::showSelected);
}

void RemoteDialog::setRecent(const QList<Recent>& servers) {
  recent_ = servers.mid(0, kMaxRemembered);
  QLineEdit& line = *url_->lineEdit();
  const QString text = line.text();
  const int cursor = line.cursorPosition(), from = line.selectionStart(), length = line.selectionLength();
  url_->clear();
  for (const Recent& server : recent_) {
    url_->addItem(server.url);
    url_->setItemData(url_->count() - 1, server.robots, Qt::ToolTipRole);
  }
  const bool isEdited = isVisible() || recent_.isEmpty();
  url_->setEditText(isEdited ? text : recent_.front().url);
  if (!isEdited) return;
  // The text that the user is entering keeps its cursor and selection. A selection ends at its cursor.
  line.setCursorPosition(cursor);
  if (from >= 0) line.setSelection(cursor == from ? from + length : from, cursor == from ? -length : length);
}

void RemoteDialog::remember(const Recent& server) {
  QList<Recent> servers = recent_;
  const auto same = [&](const Recent& other) { return other.url == server.url; };
  servers.erase(std::remove_if(servers.begin(), servers.end(), same), servers.end());
  servers.prepend(server);
  setRecent(servers);
}

void RemoteDialog::rememberConnected() {
  for (const auto& connection : robots_.connections()) {
    const Recent server{QString::fromStdString(connection.url), joined(connection.robots)};
    const auto known =
        std::ranges::find_if(recent_, [&](const Recent& other) { return other.url == server.url; });
    if (connection.state.connections == 0 || server.robots.isEmpty()) continue;
    if (known == recent_.end()) {
      remember(server);
    } else {
      known->robots = server.robots;
    }
  }
}

void RemoteDialog::connectUrl() {
  QString url = url_->currentText().trimmed();
  if (!url.contains(QStringLiteral("://"))) url.prepend(QStringLiteral("ws://"));
  const auto parsed = robotlink::websocket::parseServerUrl(url.toStdString());
  if (!parsed) return fail(QString::fromStdString(parsed.error().text));
  wanted_ = QString::fromStdString(toString(*parsed));
  widgets::setMeaning(*state_, {});
  wantsProgram_ = program_->currentIndex() == 1;
  applyLimits(wanted_.toStdString());
  if (wantsProgram_) return hostUrl(url.toStdString());
  const auto done = commands_.run("remote.connect", {url.toStdString(), token_->text().toStdString()});
  if (!done) return fail(QString::fromStdString(done.error().text));
  const auto known = std::ranges::find_if(recent_, [this](const Recent& one) { return one.url == wanted_; });
  remember({wanted_, known == recent_.end() ? QString() : known->robots});
  showConnections();
  showProgress();
}

void RemoteDialog::hostUrl(const std::string& url) {
  const auto done = commands_.run(
      "remote.host", {url, token_->text().toStdString(), std::string(), std::string(), std::string()});
  if (!done) return fail(QString::fromStdString(done.error().text));
  remember({wanted_, QString(), true});
  progress_->show();
  widgets::showOutcome(*state_, tr("Looking for a body at %1…").arg(wanted_), false);
}

void RemoteDialog::showHosted(const QString& url, const QString& robot) {
  if (std::exchange(hosted_, url) != url && !url.isEmpty()) remember({url, robot, true});
  if (!wantsProgram_ || wanted_.isEmpty() || url != wanted_) return;
  wantsProgram_ = false;
  wanted_.clear();
  token_->clear();
  progress_->hide();
  state_->clear();
  accept();
}

void RemoteDialog::showAsked() {
  if (wantsProgram_ && !wanted_.isEmpty())
    widgets::showOutcome(*state_, tr("%1 has a question before it accepts the connection.").arg(wanted_),
                         false);
}

void RemoteDialog::failHosted(const QString& reason) {
  if (!wantsProgram_ || wanted_.isEmpty()) return;
  wantsProgram_ = false;
  fail(reason);
}

void RemoteDialog::disconnectSelected() {
  const QTreeWidgetItem* row = connections_->currentItem();
  if (row == nullptr) return;
  if (row->parent() != nullptr) row = row->parent();
  const QString url = row->text(2);
  if (url == wanted_) {
    wanted_.clear();
    widgets::setMeaning(*state_, {});
    state_->clear();
  }
  const auto done = commands_.run("remote.disconnect", {url.toStdString()});
  if (!done) fail(QString::fromStdString(done.error().text));
  showConnections();
  showProgress();
}

void RemoteDialog::fail(const QString& reason) {
  wanted_.clear();
  progress_->hide();
  widgets::showOutcome(*state_, reason, true);
}

void RemoteDialog::tick() {
  rememberConnected();
  if (!isVisible()) return;
  showConnections();
  showProgress();
}

void RemoteDialog::showConnections() {
  const auto connections = robots_.connections();
  const int count = static_cast<int>(connections.size());
  setRowCount(*connections_, count);
  for (int i = 0; i < count; ++i) {
    const auto& connection = connections[static_cast<std::size_t>(i)];
    QTreeWidgetItem& row = *connections_->topLevelItem(i);
    row.setText(0, QString::fromStdString(connection.text));
    row.setToolTip(0, row.text(0));
    row.setText(1, joined(connection.robots));
    row.setToolTip(1, row.text(1));
    row.setText(2, QString::fromStdString(connection.url));
    row.setData(0, Qt::UserRole, connection.state.connections == 0);
    showMissing(row, connection.url);
    if (connections_->currentItem() == nullptr || row.text(2) == wanted_) connections_->setCurrentItem(&row);
  }
  showSelected();
}

void RemoteDialog::showMissing(QTreeWidgetItem& row, const std::string& url) {
  row.setChildIndicatorPolicy(QTreeWidgetItem::ShowIndicator);
  if (!row.isExpanded()) return;
  int count = 0;
  for (const auto& stream : robots_.streams(url)) {
    const QString text = missingOf(stream);
    if (text.isEmpty()) continue;
    QTreeWidgetItem* child = count < row.childCount() ? row.child(count) : new QTreeWidgetItem(&row);
    child->setText(0, text);
    child->setText(1, QString::fromStdString(stream.path));
    child->setToolTip(1, child->text(1));
    ++count;
  }
  if (count == 0) {
    if (row.childCount() == 0) new QTreeWidgetItem(&row);
    row.child(count)->setText(0, tr("everything sent"));
    row.child(count++)->setText(1, QString());
  }
  while (row.childCount() > count) delete row.takeChild(count);
}

void RemoteDialog::showSelected() {
  const QTreeWidgetItem* row = connections_->currentItem();
  if (row != nullptr && row->parent() != nullptr) row = row->parent();
  disconnect_->setEnabled(row != nullptr);
  const bool isNew = row != nullptr && row->data(0, Qt::UserRole).toBool();
  disconnect_->setText(isNew ? tr("C&ancel") : tr("&Disconnect"));
}

void RemoteDialog::showProgress() {
  if (wantsProgram_) return;
  const auto connections = robots_.connections();
  const auto found = std::ranges::find_if(connections, [this](const auto& connection) {
    return QString::fromStdString(connection.url) == wanted_;
  });
  progress_->setVisible(found != connections.end());
  if (found == connections.end()) return;
  const bool refused = found->state.phase == Phase::kRefused;
  if (found->state.isConnected() && !found->robots.empty()) {
    wanted_.clear();
    token_->clear();
    progress_->hide();
    state_->clear();
    return accept();
  }
  const QString text = QString::fromStdString(found->state.reason);
  if (text.isEmpty()) return widgets::showOutcome(*state_, tr("Connecting to %1…").arg(wanted_), false);
  widgets::showOutcome(*state_, refused ? text : tr("%1\nTrying again…").arg(text), true);
}

}  // namespace app
