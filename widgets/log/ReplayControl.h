// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/Clock.h"

namespace robotlink {
class Session;
}

namespace widgets {

/// The replay of logs as views see it: its state from the session's stream "replay", and its control by
/// requests. refresh() is called once per tick. GUI thread; the session must outlive it.
///
/// While a jump has not been answered only the newest of further jumps is kept, so that dragging the play
/// head does not flood the replay with requests.
class ReplayControl final : public QObject {
  Q_OBJECT
 public:
  explicit ReplayControl(robotlink::Session& session, QObject* parent = nullptr);
  ~ReplayControl() override;

  /// Reads the newest status, sends a jump that is waiting, and sets the origin of times; see
  /// setShowsTimeStamps().
  void refresh();
  /// Whether a log is open.
  bool open() const { return status_ != nullptr; }
  /// The newest status; a default one if no log is open.
  const robotcontrol::ReplayStatus& status() const;
  /// Position of the play head: the target of a jump that has not been answered, else the status's time.
  robotlink::Instant shown() const;
  /// Beginning of the first log, on the timeline.
  robotlink::Instant begin() const;
  /// The position of the play head when the log is opened: the first image, before which little is visible.
  robotlink::Instant start() const;
  /// End of the last log, on the timeline.
  robotlink::Instant end() const;
  /// The selected range, of the log or, without one, of what is kept of live robots; unset if none is
  /// selected.
  std::optional<std::pair<robotlink::Instant, robotlink::Instant>> range() const;

  void play();
  void pause();
  void playOrPause();
  void stop();
  /// Steps by `count` frames of the stepping process; negative: backward.
  void stepFrames(int count);
  /// Steps by `count` messages of `stream`, or of steppedStream() if it is empty.
  void stepMessages(int count, const std::string& stream = {});
  /// Moves the play head; clamped to [begin(), end()].
  void jumpTo(robotlink::Instant time);
  void jumpBy(robotlink::Duration by) { jumpTo(shown() + by); }
  void setLoop(bool on);
  /// Selects a range, for loops, cuts and exports; the ends may be swapped.
  void setRange(robotlink::Instant from, robotlink::Instant to);
  void clearRange();
  /// Sets one end of the range to the shown instant; the other one stays, or is the log's, or that of what is
  /// kept of live robots.
  void beginRangeHere();
  void endRangeHere();
  /// Chooses whether a package is played as logged or recomputed.
  void choosePackage(const std::string& package, robotcontrol::ControlReplay::PackageSource source);
  /// Sets the time that is added to a log's times.
  void setOffset(const std::string& log, robotlink::Duration offset);

  /// Whether views show the timestamps of the messages. Otherwise, while a log is open, times count from its
  /// beginning.
  void setShowsTimeStamps(bool on);
  /// The instant that views show as 0 s.
  robotlink::Instant origin() const;
  /// The text with which views show an instant, in seconds: "12.340".
  QString shownText(robotlink::Instant time) const;

  /// The stream whose messages are stepped: the user's choice, else that of the first images (chosen by
  /// OpenLogs). Empty while none is known.
  std::string steppedStream() const { return steppedStream_; }
  void setSteppedStream(const std::string& stream);

 Q_SIGNALS:
  /// A request was refused, for this reason.
  void refused(const QString& reason);
  void steppedStreamChanged();

 private:
  /// Sets the timeline's origin.
  void setOrigin();
  /// Sends a request; a refusal is emitted as refused().
  void send(robotcontrol::ControlReplay control);
  /// Requests a jump to aim_.
  void sendJump();

  robotlink::Session& session_;
  /// Null: no log is open.
  std::shared_ptr<const robotcontrol::ReplayStatus> status_;
  std::string steppedStream_;
  bool showsTimeStamps_ = false;
  /// Target of a jump that was not answered, or of a newer one.
  std::optional<robotlink::Instant> aim_;
  /// A jump was requested and not answered.
  bool jumping_ = false;
  /// aim_ differs from the target that was requested.
  bool newerAim_ = false;
  /// The range of live robots, and the store's generation to which it belongs.
  std::optional<std::pair<robotlink::Instant, robotlink::Instant>> liveRange_;
  std::uint64_t generation_ = 0;
  /// Ticks since the jump was requested; after three seconds its reply counts as lost.
  int ticksWaited_ = 0;
};

}  // namespace widgets
