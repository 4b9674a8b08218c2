// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <memory>
#include <string>

#include "colortool/samples/Samples.h"
#include "colortool/table/ColorTable.h"

namespace robotcontrol {
class ColorTable;
class RequestResult;
}  // namespace robotcontrol
namespace robotlink {
class Session;
}

namespace widgets {

class ColorBench;

/// Sends the trained table to the program of the selected robot, and checks that it arrived: the reply has
/// the checksum of the table that the robot uses. GUI thread; a child of the bench.
class ColorSender final : public QObject {
  Q_OBJECT
 public:
  /// kIdle: nothing was sent, or the last failure is outdated.
  /// kSending: a reply is pending, for at most five seconds.
  /// kConfirmed: the robot uses the table that was sent last.
  /// kFailed: no robot, no reply, a refusal, or another checksum.
  enum class State : std::uint8_t { kIdle, kSending, kConfirmed, kFailed };

  explicit ColorSender(ColorBench& bench);

  /// Sends the newest table. If a reply is pending it is sent after that.
  void send();
  /// Whether each new table is sent automatically, as soon as the last one was answered.
  void setAutoSend(bool on);
  bool autoSend() const { return autoSend_; }

  State state() const { return state_; }
  /// Called in each tick: clears a failure that is outdated because another robot is selected or the table is
  /// another one.
  void tick();
  /// The state for the user: "red1 uses it (3f2a91bc)", or what failed.
  const QString& text() const { return text_; }

 Q_SIGNALS:
  /// State, text or autoSend() changed.
  void changed();

 private:
  /// Sends the table if autoSend() is on and it is new.
  void sendNew();
  void describeSource(robotcontrol::ColorTable& table) const;
  void take(const robotcontrol::RequestResult& result);
  void report(State state, const QString& text);

  ColorBench& bench_;
  bool autoSend_ = false;
  /// send() was called while a reply was pending.
  bool again_ = false;
  State state_ = State::kIdle;
  QString text_;
  /// The robot to which a table was sent last.
  std::string robot_;
  /// Checksum of that table.
  std::uint64_t expected_ = 0;
  /// Number of the last request, so that late replies are ignored.
  std::uint64_t asked_ = 0;
  /// The table that was sent last.
  std::shared_ptr<const colortool::ColorTable> sent_;
  /// Ends the wait for a reply.
  QTimer patience_;
};

/// The sender of a bench, created on the first call.
ColorSender& colorSender(ColorBench& bench);

}  // namespace widgets
