// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robotlink/arcos/sick/SickTelegram.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace robotlink::arcos {

/// The client's side of the conversation with a SICK LMS 2xx, as a state machine without a line: it finds the
/// speed at which the laser talks, sets it up for scans of 180 degrees, changes the speed, and receives scans
/// continuously. If scans fail to arrive or the line is lost, it starts over, indefinitely.
///
/// The owner opens the line at the speed that wantedLine() returns, reports that, passes bytes in both
/// directions and calls tick() about a hundred times a second. Time is passed in. One thread.
class SickSession {
 public:
  /// The unit of distances, and with it the largest one.
  enum class Unit : std::uint8_t { kCentimeters, kMillimeters };
  struct Options {
    /// For scans: 9600, 19200 or 38400. At 38400 ten scans a second come at 1 degree.
    int baud = 38400;
    /// The line has a speed that cannot be changed, as one over the network: the laser is not asked to change
    /// its own.
    bool fixedSpeed = false;
    /// Half a degree between readings rather than one.
    bool halfDegrees = false;
    /// Up to 80 m in cm, or up to 32 m in mm.
    Unit unit = Unit::kCentimeters;
  };
  enum class State : std::uint8_t {
    kPausing,    ///< the line could not be opened, or broke
    kProbing,    ///< the session tries the speeds one after the other
    kSettingUp,  ///< the laser answers
    kRunning     ///< scans come
  };
  struct Scan {
    /// When it was measured: when its last byte came, less the time that its bytes take on the line.
    Instant time;
    SickReadings readings;
  };
  struct Counters {
    std::uint64_t scans = 0;
    /// How often scans have begun.
    std::uint64_t starts = 0;
    SickParser::Counters bytes;
  };

  /// An unknown speed becomes 38400.
  explicit SickSession(Options options);

  State state() const { return state_; }
  /// A line that the session wants; with another number it wants it opened again.
  struct Line {
    int baud = 0;
    std::uint64_t number = 0;
    bool operator==(const Line&) const = default;
  };
  /// The line that should be open now; empty: it should be closed.
  std::optional<Line> wantedLine() const;
  /// The owner has opened the line that wantedLine() says.
  void lineOpened(Instant now);
  /// The line could not be opened, or broke.
  void lineLost(const Error& why, Instant now);
  void take(std::span<const std::uint8_t> bytes, Instant now);
  void tick(Instant now);
  /// Ends the scans, so that the laser is quiet for its next user; the last bytes are in takeOutgoing().
  void end();

  /// Removes and returns the bytes for the laser.
  std::vector<std::uint8_t> takeOutgoing() { return std::exchange(outgoing_, {}); }
  /// Removes and returns the newest scan; empty if there is no new one.
  std::optional<Scan> takeScan() { return std::exchange(scan_, std::nullopt); }
  Counters counters() const;
  /// Describes the current state, the problem and its remedy: a sentence without its period.
  std::string describe() const;

 private:
  /// The steps of setting up, in order; some are skipped.
  enum class Step : std::uint8_t { kStop, kVariant, kReadSetup, kLogIn, kWriteSetup, kBaud, kStart };

  /// Wants the next speed.
  void probe();
  void ask(Step step, Instant now);
  /// Sends the request of step_.
  void send(Instant now);
  /// The command and data of a step's request.
  SickTelegram requestOf(Step step) const;
  void takeTelegram(const SickTelegram& telegram, Instant now);
  void answered(const SickTelegram& telegram, Instant now);
  /// Continues after the laser said how it is set up.
  void compareSetup(const SickTelegram& telegram, Instant now);
  /// Wants a line at a speed, closing the one that is open.
  void reopen(int baud);
  /// Begins at the first speed again.
  void restart(const std::string& why);
  Duration patience() const;
  int bits() const { return options_.unit == Unit::kMillimeters ? 15 : 13; }

  Options options_;
  State state_ = State::kProbing;
  Step step_ = Step::kStop;
  /// Whether the owner has the line open at the wanted speed.
  bool open_ = false;
  /// The speed of the line, and the number of the one that is probed.
  int baud_;
  std::uint64_t number_ = 0;
  std::size_t probed_ = 0;
  int tries_ = 0;
  Instant asked_, lastScan_, pausedUntil_;
  /// The configuration of the laser, as it is sent.
  std::vector<std::uint8_t> setup_;
  /// Why it is not running; empty: nothing went wrong.
  std::string problem_;
  SickParser parser_;
  std::vector<std::uint8_t> outgoing_;
  std::optional<Scan> scan_;
  std::uint64_t scans_ = 0, starts_ = 0;
};

}  // namespace robotlink::arcos
