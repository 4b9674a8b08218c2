// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "widgets/packets/PacketConversation.h"

class QAction;
class QLabel;
class QProgressBar;

namespace widgets {

/// Sends the packets of a recorded client to the connected robot again, at their times or one by one, with
/// progress and a button to stop. It has no session: packets to be sent are a signal. GUI thread.
class PacketReplayBar final : public QWidget {
  Q_OBJECT
 public:
  explicit PacketReplayBar(QWidget* parent = nullptr);
  /// `source` returns the client's packets when a replay begins; `name` is shown. Stops a replay.
  void setSource(std::function<ClientHalf()> source, const QString& name);
  /// The robot that gets the packets; empty: none, and no replay can begin. Stops a replay if it changes.
  void setRobot(const std::string& robot);
  /// Emits send() with the packets that are due; `now` is the time of the robot's platform.
  void tick(robotlink::Instant now);
  /// The robot refused the packets: stops the replay and shows the reason.
  void fail(const QString& reason);
  /// Whether a replay is in progress.

 Q_SIGNALS:
  /// Emitted when these packets are to be sent to the robot, in this order.
  void send(const std::vector<std::string>& packets);

 private:
  void createActions();
  /// Begins a replay, by single steps or by time.
  void begin(bool stepping);
  /// Sends the next packet; begins or interrupts a replay if need be.
  void step();
  void cancel();
  void showState();

  ConversationReplay replay_;
  std::function<ClientHalf()> source_;
  /// Name of the source, name of the robot, and why the last replay failed.
  QString name_, robot_, problem_;
  QAction *play_ = nullptr, *step_ = nullptr, *cancel_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* state_ = nullptr;
};

}  // namespace widgets
