// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
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

/// A replay as views see it: the session's stream "replay", and requests. refresh() is called once a tick.
/// GUI thread; the session must outlive it.
///
/// Jumps that follow each other quickly (a person drags the play head) are thinned out: while one is on its
/// way only the newest of the others is kept.
class ReplayControl final : public QObject {
  Q_OBJECT
 public:
  explicit ReplayControl(robotlink::Session& session, QObject* parent = nullptr);
  ~ReplayControl() override;

  /// Also sets where the times that views show are counted from: see setShowsTimeStamps().
  void refresh();
  /// Is a log open?
  bool open() const { return status_ != nullptr; }
  /// As last told; an empty one if no log is open.
  const robotcontrol::ReplayStatus& status() const;
  /// Where the play head stands: where it was last asked to jump to, as long as that is on its way, or what
  /// status() says.
  robotlink::Instant shown() const;
  robotlink::Instant begin() const;
  /// Where the log is opened: its first image. Before it there is little to see.
  robotlink::Instant start() const;
  robotlink::Instant end() const;
  /// Nothing if none is selected.
  std::optional<std::pair<robotlink::Instant, robotlink::Instant>> range() const;

  void play();
  void pause();
  void playOrPause();
  void stop();
  void stepFrames(int count);
  /// Of `stream`; without one, of the chosen stream.
  void stepMessages(int count, const std::string& stream = {});
  void jumpTo(robotlink::Instant time);
  void jumpBy(robotlink::Duration by) { jumpTo(shown() + by); }
  void jumpToFrame(std::uint64_t frame);
  void setSpeed(double speed);
  void setLoop(bool on);
  void setSkipGaps(bool on);
  void setStepProcess(const std::string& process);
  void setRange(robotlink::Instant from, robotlink::Instant to);
  void clearRange();
  /// One end at the play head; the other stays, or is the log's.
  void beginRangeHere();
  void endRangeHere();
  void choosePackage(const std::string& package, robotcontrol::ControlReplay::PackageSource source);
  void setOffset(const std::string& log, robotlink::Duration offset);

  /// Whether views show times as the messages bear them; else, as long as a log is open, they count from its
  /// begin.
  bool showsTimeStamps() const { return showsTimeStamps_; }
  void setShowsTimeStamps(bool on);
  /// The instant that views show as 0 s.
  robotlink::Instant origin() const;
  /// What views show for an instant, in seconds: "12.340".
  QString shownText(robotlink::Instant time) const;

  /// The stream whose messages are stepped: chosen by a person, else that of the images.
  std::string steppedStream() const { return steppedStream_; }
  void setSteppedStream(const std::string& stream);

 Q_SIGNALS:
  /// Something was refused: why.
  void refused(const QString& reason);
  void steppedStreamChanged();

 private:
  void setOrigin();
  void send(robotcontrol::ControlReplay control);
  void sendJump();

  robotlink::Session& session_;
  std::shared_ptr<const robotcontrol::ReplayStatus> status_;
  std::string steppedStream_;
  bool showsTimeStamps_ = false;
  std::optional<robotlink::Instant> aim_;  // of a jump that was not yet answered
  bool jumping_ = false;                   // one is on its way
  bool newerAim_ = false;                  // and aim_ is another one
  int ticksWaited_ = 0;
};

}  // namespace widgets
