// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/PublishPanel.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFontDatabase>
#include <QJsonObject>
#include <QLabel>
#include <QPlainTextEdit>
#include <QStandardItemModel>
#include <QToolButton>
#include <algorithm>

#include "robotlink/session/RobotTables.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/Requests.h"
#include "widgets/RobotChoice.h"
#include "widgets/data/RequestText.h"

namespace widgets {

PublishPanel::PublishPanel(ViewContext& context, QWidget* parent)
    : QWidget(parent), context_(context), forms_(requestForms()) {
  setObjectName(QStringLiteral("publishPanel"));
  for (RequestForm& form : packageForms()) forms_.push_back(std::move(form));
  createActions();
  createViews();
  for (const RequestForm& form : forms_) kind_->addItem(QString::fromStdString(form.title));
  connect(kind_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &PublishPanel::showForm);
  connect(robot_, &RobotChoice::choiceChanged, this, [this] { setRepeating(false); });
  connect(text_, &QPlainTextEdit::textChanged, this, [this] {
    if (text_->toPlainText() != QString::fromStdString(form()->json))
      typed_[shown_] = text_->toPlainText();
    else
      typed_.remove(shown_);
    reset_->setEnabled(typed_.contains(shown_));
  });
  connect(rate_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double rate) { repeating_.setInterval(qRound(1000 / rate)); });
  repeating_.setInterval(qRound(1000 / rate_->value()));
  connect(&repeating_, &QTimer::timeout, this, [this] {
    if (!send()) setRepeating(false);
  });
  showForm();
}

PublishPanel::~PublishPanel() = default;

void PublishPanel::createActions() {
  send_ = makeAction(this, "send",
                     {"publishSend", tr("Send"), tr("Sends the message once"),
                      QKeySequence(QStringLiteral("Ctrl+Shift+Return"))});
  connect(send_, &QAction::triggered, this, &PublishPanel::send);
  repeat_ = makeToggle(
      this, "loop",
      {"publishRepeat", tr("Repeat"), tr("Sends the message repeatedly, with its current fields")});
  connect(repeat_, &QAction::toggled, this, &PublishPanel::setRepeating);
  reset_ =
      makeAction(this, "reset",
                 {"publishReset", tr("Reset the message"), tr("Resets all fields to their defaults"), {}});
  connect(reset_, &QAction::triggered, this,
          [this] { text_->setPlainText(QString::fromStdString(form()->json)); });
  hold_ = makeAction(this, "lock",
                     {"publishHold",
                      tr("Hold"),
                      tr("Replaces every such package that the program sends, until it is released"),
                      {}});
  connect(hold_, &QAction::triggered, this, [this] { setHeld(true); });
  release_ = makeAction(this, "undo",
                        {"publishRelease",
                         tr("Release"),
                         tr("Releases the held package, so that the program provides it again"),
                         {}});
  connect(release_, &QAction::triggered, this, [this] { setHeld(false); });
}

void PublishPanel::createViews() {
  kind_ = new QComboBox(this);
  describe(*kind_, {"publishKind", tr("Message"), tr("What is sent")});
  robot_ = new RobotChoice("publishRobot", this, RobotChoice::Offer::kOne);
  rate_ = new QDoubleSpinBox(this);
  describe(*rate_, {"publishRate", tr("Rate"), tr("How often Repeat sends the message")});
  rate_->setRange(kMinRate, kMaxRate);
  rate_->setDecimals(1);
  rate_->setValue(10);
  rate_->setSuffix(tr(" Hz"));
  state_ = makeNote(this, "publishState", tr("What came of it"));
  held_ = makeNote(this, "publishHeld", tr("Packages that are held"));
  text_ = new QPlainTextEdit(this);
  describe(*text_, {"publishText", tr("The fields of the message, as JSON"), {}});
  text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  text_->setTabChangesFocus(true);
  text_->setLineWrapMode(QPlainTextEdit::NoWrap);
  setFocusProxy(text_);
  auto* top = new QHBoxLayout;
  top->addWidget(kind_);
  top->addWidget(robot_);
  top->addWidget(makeLabeledButton(this, send_));
  top->addWidget(makeLabeledButton(this, repeat_));
  top->addWidget(rate_);
  top->addWidget(makeButton(this, reset_));
  top->addStretch();
  auto* layout = makeColumn(this, {}, 4);
  layout->addLayout(top);
  layout->addWidget(text_, 1);
  auto* holding = new QHBoxLayout;
  holding->addWidget(makeLabeledButton(this, hold_));
  holding->addWidget(makeLabeledButton(this, release_));
  holding->addWidget(held_, 1);
  layout->addLayout(holding);
  layout->addWidget(state_);
}

const RequestForm* PublishPanel::form() const {
  const int index = kind_->currentIndex();
  return index < 0 ? nullptr : &forms_[static_cast<std::size_t>(index)];
}

void PublishPanel::showForm() {
  setRepeating(false);
  if (form() == nullptr) return;
  shown_ = kind_->currentText();
  text_->setPlainText(typed_.value(shown_, QString::fromStdString(form()->json)));
  reset_->setEnabled(typed_.contains(shown_));
  sent_ = accepted_ = 0;
  state_->clear();
  showPackages();
}

void PublishPanel::setRepeating(bool on) {
  if (on && !repeating_.isActive()) {
    if (send()) return repeating_.start();
    on = false;
  }
  if (on) return;
  repeating_.stop();
  repeat_->setChecked(false);
}

bool PublishPanel::send() {
  const std::string robot = robot_->robot(context_.session);
  const std::string text = text_->toPlainText().toStdString();
  return sendRead(form()->package.empty()
                      ? readRequest(form()->what, robot, text)
                      : readPackage(form()->package, robotcontrol::SetPackage::ONCE, robot, text));
}

void PublishPanel::setHeld(bool held) {
  using robotcontrol::SetPackage;
  setRepeating(false);
  sendRead(readPackage(form()->package, held ? SetPackage::HOLD : SetPackage::RELEASE,
                       robot_->robot(context_.session), text_->toPlainText().toStdString()));
}

bool PublishPanel::sendRead(robotlink::Result<robotcontrol::Request> request) {
  if (!request) {
    showOutcome(*state_, tr("Not sent: %1").arg(QString::fromStdString(request.error().text)), true);
    return false;
  }
  const std::string robot = robot_->robot(context_.session);
  ++sent_;
  ask(context_.session, robot, std::move(*request), this,
      [this, kind = shown_](bool accepted, const QString& reason) {
        if (kind != shown_) return;
        if (accepted) {
          ++accepted_;
          return showCounts();
        }
        setRepeating(false);
        showOutcome(*state_, tr("Refused: %1").arg(reason), true);
      });
  return true;
}

void PublishPanel::showCounts() {
  showOutcome(
      *state_,
      tr("%1, %2 accepted").arg(counted(sent_, tr("1 message sent"), tr("%1 messages sent"))).arg(accepted_),
      false);
}

void PublishPanel::tick() {
  robot_->refresh(context_.session);
  showPackages();
}

void PublishPanel::showPackages() {
  const std::string robot = robot_->robot(context_.session);
  const auto& store = context_.session.store();
  const auto present = robotlink::programPackages(store, robot, robotlink::Instant::max());
  const auto held = robotlink::heldPackages(store, robot, robotlink::Instant::max());
  auto* kinds = qobject_cast<QStandardItemModel*>(kind_->model());
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    const std::string& package = forms_[i].package;
    // The program's packages are not known before it has reported its processes.
    const bool isThere = package.empty() || present.empty() || present.contains(package);
    if (QStandardItem* item = kinds->item(static_cast<int>(i)); item->isEnabled() != isThere)
      item->setEnabled(isThere);
  }
  const bool isPackage = form() != nullptr && !form()->package.empty();
  hold_->setEnabled(isPackage);
  release_->setEnabled(isPackage && held.contains(form()->package));
  QStringList names;
  for (const std::string& package : held) names << QString::fromStdString(package);
  held_->setText(
      held.empty()
          ? QString()
          : tr("Held at %1: %2").arg(QString::fromStdString(robot), names.join(QStringLiteral(", "))));
}

QJsonValue PublishPanel::state() const {
  QJsonObject typed;
  for (auto entry = typed_.begin(); entry != typed_.end(); ++entry) typed.insert(entry.key(), entry.value());
  return QJsonObject{{QStringLiteral("kind"), kind_->currentText()},
                     {QStringLiteral("robot"), robot_->choice()},
                     {QStringLiteral("rate"), rate_->value()},
                     {QStringLiteral("typed"), typed}};
}

void PublishPanel::setState(const QJsonValue& state) {
  const QJsonObject saved = state.toObject();
  typed_.clear();
  const QJsonObject typed = saved.value(QStringLiteral("typed")).toObject();
  for (const QString& kind : typed.keys()) typed_[kind] = typed.value(kind).toString();
  kind_->setCurrentIndex(std::max(0, kind_->findText(saved.value(QStringLiteral("kind")).toString())));
  robot_->setChoice(saved.value(QStringLiteral("robot")).toString());
  rate_->setValue(saved.value(QStringLiteral("rate")).toDouble(rate_->value()));
  showForm();
}

void PublishPanel::hideEvent(QHideEvent* event) {
  setRepeating(false);
  QWidget::hideEvent(event);
}

}  // namespace widgets
