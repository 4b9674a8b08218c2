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
#include <QToolButton>
#include <algorithm>

#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/Requests.h"
#include "widgets/RobotChoice.h"
#include "widgets/data/RequestText.h"

namespace widgets {

PublishPanel::PublishPanel(ViewContext& context, QWidget* parent)
    : QWidget(parent), context_(context), forms_(requestForms()) {
  setObjectName(QStringLiteral("publishPanel"));
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
      this, "loop", {"publishRepeat", tr("Repeat"), tr("Sends the message again and again, as it is then")});
  connect(repeat_, &QAction::toggled, this, &PublishPanel::setRepeating);
  reset_ =
      makeAction(this, "reset",
                 {"publishReset", tr("Reset the message"), tr("Shows the message as it is by default"), {}});
  connect(reset_, &QAction::triggered, this,
          [this] { text_->setPlainText(QString::fromStdString(form()->json)); });
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
  auto request = readRequest(form()->what, robot, text_->toPlainText().toStdString());
  if (!request) {
    showOutcome(*state_, tr("Not sent: %1").arg(QString::fromStdString(request.error().text)), true);
    return false;
  }
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
