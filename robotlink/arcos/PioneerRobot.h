// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/arcos/MotionGoal.h"
#include "robotlink/arcos/RobotState.h"
#include "robotlink/arcos/RobotType.h"
#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/Packet.h"
#include "robotlink/arcos/codec/RangeScan.h"
#include "robotlink/arcos/stream/OpenStream.h"

namespace robotlink::arcos {

class PioneerConnection;

/// A Pioneer, simulated or real: they differ in the URL, in nothing else.
///
///   PioneerRobot robot("tcp://localhost:8101");           // or "serial:///dev/ttyUSB0?baud=9600"
///   if (const auto begun = robot.begin(); !begun) { ... begun.error().text ... }
///   robot.setMotors(true);
///   while (robot.read()) {                                // sense: waits for what the robot says each 100
///   ms
///     const bool free = robot.nearestEcho(-0.5, 0.5) > 1; // plan
///     robot.drive(free ? 0.3 : 0, free ? 0 : 0.5);        // act
///   }
///
/// It is passive: it has no thread and calls nobody. What keeps the robot's watchdog content goes out in
/// read() and in every command, so a program that stops calling stops the robot after two seconds.
/// Thread-safe: any thread may call anything at any time; getters and commands do not wait for a read() that
/// is under way.
///
/// SI units and radians; poses are in the frame of the robot's odometry. Errors carry a sentence for people;
/// once the line is lost, all fails until begin() has connected anew. The robot's side of it: ARCOS (see
/// CLIENT.md).
class PioneerRobot {
 public:
  /// How the line is opened, each time that begin() is called.
  using Opener = StreamOpener;

  explicit PioneerRobot(std::string url);
  /// Over a line of the caller's making, by a clock that goes on while that line waits for bytes.
  PioneerRobot(Opener opener, std::shared_ptr<const Clock> clock);
  /// Ends the connection.
  ~PioneerRobot();
  PioneerRobot(const PioneerRobot&) = delete;
  PioneerRobot& operator=(const PioneerRobot&) = delete;

  // --- The connection

  /// Opens the line, greets the robot, and waits for the first word of its state. Motors are off then. Also
  /// connects anew after the line was lost. Blocks for `timeLimit` at most, and for as long as opening the
  /// line takes.
  Result<void> begin(Duration timeLimit = std::chrono::seconds(8));
  /// Stops the robot and closes the line. A read() of another thread returns with an error.
  void end();
  bool isConnected() const;
  /// What went wrong last, as a sentence; empty if nothing did.
  std::string problem() const;

  /// Takes all that the robot has said; if there was no word of its state since the last read(), waits for
  /// one, but at most `timeout` (0: does not wait). True if the state is new.
  Result<bool> read(Duration timeout = std::chrono::milliseconds(200));
  /// Sends any command, or any packet as it is.
  Result<void> write(const Command& command);
  Result<void> write(const Packet& packet);

  // --- What is known of it; as of the last read()

  RobotState state() const;
  Pose2 pose() const { return state().pose; }
  double heading() const { return state().pose.heading; }
  double speed() const { return state().speed; }
  double rotation() const { return state().rotation; }
  double battery() const { return state().battery; }
  bool stalled() const { return state().stalled(); }
  bool bumped() const { return state().bumped(); }
  bool motorsOn() const { return state().motorsOn; }
  /// m, by number; the sonars' maximum if there is no such sonar, or no echo.
  double sonar(std::size_t number) const;
  std::vector<SonarReading> sonars() const { return state().sonars; }
  /// The latest scan; none if the robot has no laser on this line, or it is off.
  std::optional<RangeScan> laser() const;
  /// How long a range counts as one of now; each sonar measures about three times in it.
  static constexpr Duration kEchoTime = std::chrono::seconds(1);
  /// Where sonars and laser see something now, in the robot's frame: what to keep clear of.
  std::vector<Vector2> echoes() const;
  /// m from the robot's centre to the nearest of the echoes in directions from `fromAngle` counter-clockwise
  /// to `toAngle` (rad, 0 is ahead); infinite if there is none.
  double nearestEcho(double fromAngle, double toAngle) const;

  /// How it called itself in the handshake: "p3at-sh" and the like.
  std::string name() const;
  RobotType type() const;
  /// A simulator says that it is one.
  bool isSimulated() const;
  /// The latest packet of this number that came over this connection, for what has no getter (gyroscope,
  /// encoders, I/O, ...).
  std::optional<Packet> latest(std::uint8_t packetId) const;
  /// Since begin().
  struct LinkCounts {
    std::uint64_t states = 0;  // information packets
    std::uint64_t packets = 0, checksumErrors = 0, skippedBytes = 0;
  };
  LinkCounts linkCounts() const;

  // --- What to do. Speeds hold until they are changed, or the robot has heard nothing for two seconds.

  Result<void> setMotors(bool on);
  Result<void> setSonar(bool on);
  /// Only simulators have it on this line; a real laser has a line of its own. 181 readings from right to
  /// left.
  Result<void> setLaser(bool on);
  /// Forwards, m/s; counter-clockwise, rad/s (in steps of a degree). What turns it stays when its speed is
  /// set, and vice versa.
  Result<void> setSpeed(double speed);
  Result<void> setRotation(double rotation);
  Result<void> drive(double speed, double rotation);
  /// Sets the speeds of the left and the right wheels, m/s, in steps of 0.02.
  Result<void> setWheels(double left, double right);
  /// Forwards by `distance`, m, at the speed of setLimits(). It goes on by itself: see waitForMotion().
  Result<void> move(double distance);
  /// Turns by an angle, or to a heading in the odometry's frame. It goes on by itself: see waitForMotion().
  Result<void> turn(double angle);
  Result<void> turnTo(double heading);
  /// Reads until the latest move(), turn() or turnTo() has ended, but for `timeLimit` at most; the robot then
  /// goes on. Fails if the line is lost, or if there was no such command since begin().
  Result<MotionEnd> waitForMotion(Duration timeLimit = std::chrono::seconds(60));
  /// What commands may make of it: m/s, rad/s.
  Result<void> setLimits(double speed, double rotation);
  /// Slows down and stands.
  Result<void> stop();
  /// Stands as fast as it can.
  Result<void> emergencyStop();
  /// Here is the origin, and this is ahead.
  Result<void> resetOdometry();

  // --- Inputs and outputs at the robot's user port; bit i of a byte is number i

  std::uint8_t digitalInputs() const { return state().digitalIn; }
  std::uint8_t digitalOutputs() const { return state().digitalOut; }
  /// Sets the outputs whose bits are 1 in `which` to those bits of `values`; the others stay.
  Result<void> setDigitalOutputs(std::uint8_t which, std::uint8_t values);
  Result<void> setDigitalOutput(int number, bool on);
  /// V, 0 to 5, of the analog port that was selected.
  double analogInput() const { return state().analogIn * 5.0 / 255; }
  Result<void> selectAnalogInput(int number);

  // --- Simulators only

  /// Puts it somewhere in its map, as one would carry a real robot. Its odometry stays.
  Result<void> putAt(const Pose2& poseInField);
  /// Has the simulator tell the true pose with each state.
  Result<void> setTruePose(bool on);
  /// In the map's frame; its heading to a degree. None as long as it was not told.
  std::optional<Pose2> truePose() const;

 private:
  Result<void> requireSimulator(const std::string& why) const;

  std::unique_ptr<PioneerConnection> connection_;
};

}  // namespace robotlink::arcos
