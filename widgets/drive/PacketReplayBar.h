// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "widgets/models/PacketConversation.h"

class QAction;
class QLabel;
class QProgressBar;

namespace widgets {

/// Says what a client once said to the robot that is connected now: at its times, or packet by packet, with
/// progress, and with a way to stop. It knows no session: what is to be sent is told.
class PacketReplayBar final : public QWidget {
  Q_OBJECT
 public:
  explicit PacketReplayBar(QWidget* parent = nullptr);
  /// Where the client's half comes from when it is begun, and how it is called.
  void setSource(std::function<ClientHalf()> source, const QString& name);
  /// Whom it is said to; empty: nobody, and nothing can be begun.
  void setRobot(const std::string& robot);
  /// Sends what is due; `now` is the time of the robot's platform.
  void tick(robotlink::Instant now);
  /// The robot refused what was sent: it ends.
  void fail(const QString& reason);
  bool running() const { return replay_.state() != ConversationReplay::State::kIdle; }

 Q_SIGNALS:
  void send(const std::vector<std::string>& packets);

 private:
  void createActions();
  void begin(bool stepping);
  void step();
  void cancel();
  void showState();

  ConversationReplay replay_;
  std::function<ClientHalf()> source_;
  QString name_, robot_, problem_;
  QAction *play_ = nullptr, *step_ = nullptr, *cancel_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* state_ = nullptr;
};

}  // namespace widgets
