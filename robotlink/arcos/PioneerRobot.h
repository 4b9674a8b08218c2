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

/// A Pioneer robot, simulated or real; the two differ only in their URL.
///
///   PioneerRobot robot("tcp://localhost:8101");           // or "serial:///dev/ttyUSB0?baud=9600"
///   if (const auto begun = robot.begin(); !begun) { ... begun.error().text ... }
///   robot.setMotors(true);
///   while (robot.read()) {                                // sense: waits for the state, sent every 100 ms
///     const bool free = robot.nearestEcho(-0.5, 0.5) > 1; // plan
///     robot.drive(free ? 0.3 : 0, free ? 0 : 0.5);        // act
///   }
///
/// Passive: it has no thread and no callbacks. The keep-alive for the robot's watchdog is sent in read() and
/// with every command, so if the program stops calling, the robot stops after two seconds. Thread-safe: any
/// thread may call anything at any time; getters and commands do not wait for a read() in progress.
///
/// SI units and radians; poses are in the odometry frame. Errors carry a sentence for users; once the line is
/// lost, every call fails until begin() has connected again. The protocol is ARCOS (see CLIENT.md).
class PioneerRobot {
 public:
  /// Opens the line; called by each begin().
  using Opener = StreamOpener;

  /// A robot at a URL of StreamUrl.h. Does not connect yet.
  explicit PioneerRobot(std::string url);
  /// For a line of the caller's own; `clock` must advance while that line waits for bytes.
  PioneerRobot(Opener opener, std::shared_ptr<const Clock> clock);
  /// Ends the connection.
  ~PioneerRobot();
  PioneerRobot(const PioneerRobot&) = delete;
  PioneerRobot& operator=(const PioneerRobot&) = delete;

  // --- Connection

  /// Opens the line, performs the handshake, and waits for the first state. The motors are off afterward.
  /// Also reconnects after the line was lost. Blocks for at most `timeLimit` plus the time to open the line.
  Result<void> begin(Duration timeLimit = std::chrono::seconds(8));
  /// Stops the robot and closes the line. A read() in another thread returns with an error.
  void end();
  bool isConnected() const;
  /// The last problem as a sentence; empty if there is none.
  std::string problem() const;

  /// Processes everything received. If there was no new state since the last read(), waits for one, at most
  /// `timeout` (0: does not wait). Returns true if the state is new, false after a timeout.
  Result<bool> read(Duration timeout = std::chrono::milliseconds(200));
  /// Sends any command, or any packet as it is.
  Result<void> write(const Command& command);
  Result<void> write(const Packet& packet);

  // --- State, as of the last read()

  RobotState state() const;
  Pose2 pose() const { return state().pose; }
  // rad, m/s, rad/s and V, as in RobotState.
  double heading() const { return state().pose.heading; }
  double speed() const { return state().speed; }
  double rotation() const { return state().rotation; }
  double battery() const { return state().battery; }
  bool stalled() const { return state().stalled(); }
  bool bumped() const { return state().bumped(); }
  bool motorsOn() const { return state().motorsOn; }
  /// In m, by the sonar's number; the sonars' maximum if there is no such sonar or no echo.
  double sonar(std::size_t number) const;
  std::vector<SonarReading> sonars() const { return state().sonars; }
  /// The latest scan; empty if the robot has no laser on this line or the laser is off.
  std::optional<RangeScan> laser() const;
  /// How long a range counts as current; each sonar measures about three times in it.
  static constexpr Duration kEchoTime = std::chrono::seconds(1);
  /// The points that sonars and laser currently see as obstacles, in the robot's frame.
  std::vector<Vector2> echoes() const;
  /// The distance from the robot's center to the nearest echo in directions from `fromAngle`
  /// counterclockwise to `toAngle` (rad, 0 is ahead), m; infinite if there is none.
  double nearestEcho(double fromAngle, double toAngle) const;

  /// The robot's name from the handshake.
  std::string name() const;
  /// The parameters of its kind: sensor poses, conversion factors.
  RobotType type() const;
  /// Whether the robot identified itself as a simulator.
  bool isSimulated() const;
  /// The latest packet with this id of this connection, for data without a getter (gyroscope, encoders, I/O,
  /// ...).
  std::optional<Packet> latest(std::uint8_t packetId) const;
  /// Counters since begin().
  struct LinkCounts {
    /// Standard information packets.
    std::uint64_t states = 0;
    std::uint64_t packets = 0, checksumErrors = 0, skippedBytes = 0;
  };
  LinkCounts linkCounts() const;

  // --- Commands. Speeds hold until they are changed, or until the robot has received nothing for two
  // seconds.

  /// The robot moves only with its motors on; begin() leaves them off.
  Result<void> setMotors(bool on);
  Result<void> setSonar(bool on);
  /// Only simulators have a laser on this line; a real laser has its own. Scans have 181 readings from -90 to
  /// 90 degrees.
  Result<void> setLaser(bool on);
  /// Sets the forward speed, m/s, or the counterclockwise rotation, rad/s (in steps of a degree). Setting
  /// one keeps the other.
  Result<void> setSpeed(double speed);
  Result<void> setRotation(double rotation);
  /// Sets both.
  Result<void> drive(double speed, double rotation);
  /// Sets the speeds of the left and the right wheels, m/s, in steps of RobotType::wheelSpeedStep.
  Result<void> setWheels(double left, double right);
  /// Drives forwards by `distance`, m, at the speed of setLimits(). Returns at once: see waitForMotion().
  Result<void> move(double distance);
  /// Turns by an angle, or to a heading in the odometry frame, rad. Returns at once: see waitForMotion().
  Result<void> turn(double angle);
  Result<void> turnTo(double heading);
  /// Reads until the latest move(), turn() or turnTo() has ended, but at most for `timeLimit`; the robot
  /// continues after a timeout. Fails if the line is lost, or if there was no such command since begin().
  Result<MotionEnd> waitForMotion(Duration timeLimit = std::chrono::seconds(60));
  /// Sets the maximal speed and rotation of all commands, m/s and rad/s.
  Result<void> setLimits(double speed, double rotation);
  /// Brakes with the normal deceleration.
  Result<void> stop();
  /// Brakes as hard as possible.
  Result<void> emergencyStop();
  /// Makes the robot's present pose the origin of its odometry.
  Result<void> resetOdometry();

  // --- Inputs and outputs of the robot's user port; bit i of a byte is number i.

  std::uint8_t digitalInputs() const { return state().digitalIn; }
  std::uint8_t digitalOutputs() const { return state().digitalOut; }
  /// Sets the outputs whose bits are 1 in `which` to the corresponding bits of `values`; the others keep
  /// their state.
  Result<void> setDigitalOutputs(std::uint8_t which, std::uint8_t values);
  Result<void> setDigitalOutput(int number, bool on);
  /// The voltage at the selected analog port, 0 to 5 V.
  double analogInput() const { return state().analogIn * 5.0 / 255; }
  /// Selects the port that analogInput() shows.
  Result<void> selectAnalogInput(int number);

  /// Moves the gripper of a robot that has one; its state is in state().gripper. Returns at once.
  Result<void> setGripper(GripperAction action);

  // --- Only for simulators; a real robot gives an error.

  /// Moves the robot to a pose in the map, as if it had been carried there. Its odometry does not change.
  Result<void> putAt(const Pose2& poseInField);
  /// Requests the true pose with each state, or cancels it.
  Result<void> setTruePose(bool on);
  /// In the map's frame, the heading with a resolution of a degree. Empty until received.
  std::optional<Pose2> truePose() const;

 private:
  /// Fails with the given sentence if the robot is not a simulator.
  Result<void> requireSimulator(const std::string& why) const;

  std::unique_ptr<PioneerConnection> connection_;
};

}  // namespace robotlink::arcos
