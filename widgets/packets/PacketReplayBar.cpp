// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/PacketReplayBar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "widgets/Controls.h"
#include "widgets/Counted.h"

namespace widgets {

PacketReplayBar::PacketReplayBar(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("packetReplayBar"));
  createActions();
  progress_ = new QProgressBar(this);
  describe(*progress_, {"packetReplayProgress", tr("Replay progress"), {}});
  progress_->setFormat(QStringLiteral("%v / %m"));
  progress_->setMaximumWidth(160);
  state_ = new QLabel(this);
  describe(*state_, {"packetReplayState", tr("What is being replayed"), {}});
  state_->setTextFormat(Qt::PlainText);
  state_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  for (QAction* action : {play_, step_, cancel_}) layout->addWidget(makeButton(this, action));
  layout->addWidget(progress_);
  layout->addWidget(state_, 1);
  showState();
}

void PacketReplayBar::createActions() {
  play_ = makeAction(this, "play",
                     {"packetReplay", tr("Replay"),
                      tr("Sends the client's packets to the robot, at their times; continues only while this "
                         "view is visible"),
                      tr("Ctrl+Return")});
  step_ =
      makeAction(this, "step",
                 {"packetReplayStep", tr("Next packet"), tr("Sends the client's next packet"), tr("Ctrl+.")});
  cancel_ =
      makeAction(this, "halt",
                 {"packetReplayCancel", tr("Stop replay"), tr("Stops sending"), tr("Ctrl+Shift+Backspace")});
  connect(play_, &QAction::triggered, this, [this] {
    if (replay_.state() == ConversationReplay::State::kStepping) {
      replay_.setStepping(false);
      showState();
    } else {
      begin(false);
    }
  });
  connect(step_, &QAction::triggered, this, &PacketReplayBar::step);
  connect(cancel_, &QAction::triggered, this, &PacketReplayBar::cancel);
}

void PacketReplayBar::setSource(std::function<ClientHalf()> source, const QString& name) {
  replay_.cancel();
  source_ = std::move(source);
  name_ = name;
  problem_.clear();
  showState();
}

void PacketReplayBar::setRobot(const std::string& robot) {
  const QString name = QString::fromStdString(robot);
  if (name == robot_) return;
  replay_.cancel();
  robot_ = name;
  showState();
}

void PacketReplayBar::begin(bool stepping) {
  if (!source_) return;
  problem_.clear();
  replay_.begin(source_(), stepping);
  if (replay_.count() == 0) problem_ = tr("There are no packets of a client.");
  showState();
}

void PacketReplayBar::step() {
  if (replay_.state() == ConversationReplay::State::kIdle) begin(true);
  if (replay_.state() == ConversationReplay::State::kRunning) replay_.setStepping(true);
  const std::string bytes = replay_.step();
  if (!bytes.empty()) Q_EMIT send({bytes});
  showState();
}

void PacketReplayBar::cancel() {
  replay_.cancel();
  showState();
}

void PacketReplayBar::fail(const QString& reason) {
  replay_.cancel();
  problem_ = tr("Refused: %1").arg(reason);
  showState();
}

void PacketReplayBar::tick(robotlink::Instant now) {
  if (replay_.state() != ConversationReplay::State::kRunning) return;
  const std::vector<std::string> due = replay_.tick(now);
  if (!due.empty()) Q_EMIT send(due);
  showState();
}

void PacketReplayBar::showState() {
  using State = ConversationReplay::State;
  const State state = replay_.state();
  const bool ready = static_cast<bool>(source_) && !robot_.isEmpty();
  play_->setEnabled(ready && state != State::kRunning);
  step_->setEnabled(ready);
  cancel_->setEnabled(state != State::kIdle);
  progress_->setVisible(replay_.count() > 0);
  progress_->setRange(0, static_cast<int>(replay_.count()));
  progress_->setValue(static_cast<int>(replay_.done()));
  const QString leftOut =
      replay_.leftOut() > 0
          ? counted(replay_.leftOut(), tr(" (1 left out that would open or close a connection)"),
                    tr(" (%1 left out that would open or close a connection)"))
          : QString();
  QString text = problem_;
  if (text.isEmpty() && state == State::kRunning)
    text = tr("Replaying %1 to %2").arg(name_, robot_) + leftOut;
  if (text.isEmpty() && state == State::kStepping)
    text = tr("%1, packet by packet, to %2").arg(name_, robot_) + leftOut;
  if (text.isEmpty() && replay_.count() > 0 && replay_.done() == replay_.count())
    text = tr("Replay finished") + leftOut;
  if (text.isEmpty() && source_ && robot_.isEmpty()) text = tr("Connect to a robot to replay to.");
  state_->setText(text);
  state_->setToolTip(text);
}

}  // namespace widgets
