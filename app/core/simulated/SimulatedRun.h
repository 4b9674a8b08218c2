// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/program/RobotHost.h"
#include "app/core/simulated/ArcosPorts.h"
#include "app/core/simulated/KickOff.h"
#include "app/core/simulated/SimulatedWorld.h"
#include "robotlink/config/RobotDescription.h"
#include "simcore/Scene.h"

namespace logplayer {
class Recorder;
}
namespace robotcontrol {
class Request;
}
namespace robotlink {
class RobotProgram;
struct FieldDescription;
struct GroundMap;
struct Layout;
}  // namespace robotlink

namespace app {

class RecordingTap;

/// What a run is made of. Paths are files; defaults are those of the resources.
struct RunOptions {
  std::filesystem::path scene;
  std::filesystem::path layout;  ///< of all robots; empty: that of their kind
  /// By what kind of robot it is ("ers210"); kinds without one have the layout of their description.
  std::map<std::string, std::filesystem::path> layouts = {};
  SimulatedWorld::Options world;
  std::optional<simcore::RobotsToAdd> robots = {};  ///< beside those of the scene; not given: a map has one
  /// TCP ports at which programs outside find the robots on wheels.
  std::optional<ArcosPorts::Options> ports = {};
  ExecutorKind executor = ExecutorKind::kLockstep;
  std::map<std::string, std::string> solutions;  ///< task -> solution at the start, instead of the layout's
  /// After a goal the ball comes back to the middle and the robots to their places; see KickOff.
  bool kickOffs = true;
  simcore::LoadProgress progress = {};  ///< of the scene; may give up its loading
  bool classImages =
      false;  ///< the true classes are sent with all images, whether or not somebody asks for them
};

/// The teams that robots can be added to: "both", "red" or "blue".
std::vector<std::string> teamsNamed(const std::string& name);

/// A simulated world with the programs of all its robots, stepped by its caller.
///
/// Built as a whole or refused with all reasons. One thread at a time; listeners are called in that thread by
/// the lockstep executor, and in the processes' threads by the other one.
class SimulatedRun {
 public:
  struct Listeners {
    std::function<void(const std::string& robot, std::shared_ptr<const robotcontrol::DebugQueue>)> queue;
    /// A process was stopped, starves, or could not get its priority.
    std::function<void(const std::string& robot, const robotlink::Process& process, const std::string& text)>
        trouble;
    /// An image with its true classes (oracle/classes); while it is set these are found for all images.
    std::function<void(const std::string& robot, const foxglove::RawImage& image,
                       const foxglove::RawImage& classes)>
        labeled = {};
    /// What programs outside did at the robots' ports, a line each.
    std::function<void(const std::string& text)> ports = {};
    /// A goal, a kick-off: a sentence each.
    std::function<void(robotlink::Instant time, const std::string& text)> game = {};
    /// What a robot's platform has to say of being set up and shut down, a sentence each.
    std::function<void(const std::string& robot, const std::string& text)> platform = {};
  };

  /// `recorder`: is told all that a log may hold; it must outlive the run. Null: there is none.
  static tl::expected<std::unique_ptr<SimulatedRun>, robotlink::Errors> create(
      RunOptions options, Listeners listeners, logplayer::Recorder* recorder = nullptr);
  ~SimulatedRun();

  /// One step of the platforms, and of all processes that it lets run.
  void step();
  /// While no step is made, in lockstep: tells the listener of queues what the programs will answer in their
  /// next frames to what they were asked and have not answered, with the tables and parameters that follow
  /// from it. Neither the programs nor what is recorded know of it, so that a run is the same however long it
  /// is paused.
  void publishComingAnswers();
  /// World and programs as they were at the start, with another seed; what a person chose for the programs
  /// stays as it is. If the programs cannot be made anew, all goes on as before.
  robotlink::Errors reset(std::uint64_t seed);
  /// Starts the programs anew in another layout, while the world stays as it is: those of the robots of all
  /// kinds that can be run in it. If there are none, all goes on as before. What a person chose stays so
  /// where the layout has it.
  robotlink::Errors setLayout(const std::filesystem::path& file);
  /// What of the choices the programs that run now cannot fulfill, a sentence each.
  const std::vector<std::string>& lostChoices() const { return lostChoices_; }

  SimulatedWorld& world() { return *world_; }
  const SimulatedWorld& world() const { return *world_; }
  const RunOptions& options() const { return options_; }
  std::vector<std::string> robots() const;
  std::shared_ptr<const robotlink::RobotDescription> description(const std::string& robot) const;
  std::shared_ptr<const robotlink::FieldDescription> field() const { return field_; }
  /// Null: this is no game on a field, or nobody brings the ball back.
  const KickOff* game() const { return kickOff_.get(); }
  /// The file of the layout in which the first robot's program runs.
  std::filesystem::path layout() const;

  /// Opens the ports that the options ask for, if they are not open; closes them, so that another run can
  /// have them.
  robotlink::Result<void> openPorts();
  void closePorts() { ports_.reset(); }
  /// Null: programs outside cannot drive the robots.
  const ArcosPorts* ports() const { return ports_.get(); }
  std::shared_ptr<const robotlink::GroundMap> map() const;  ///< that the world was made from; null: from none
  /// Hands a request to a robot's program, or STOP and what concerns its base to its platform. Fails if there
  /// is no such robot or its queue is full.
  robotlink::Result<void> request(const robotcontrol::Request& request);
  std::vector<std::string> stoppedRobots() const;

 private:
  SimulatedRun(RunOptions options, Listeners listeners, logplayer::Recorder* recorder);
  robotlink::Errors load();
  robotlink::Errors describeRobots();
  robotlink::Errors checkChosenSolutions() const;
  using Layouts = std::map<std::string, std::filesystem::path>;
  using Candidates = std::vector<RobotHost::Candidate>;  // one for each robot
  std::filesystem::path layoutOf(const RobotHost& robot, const Layouts& chosen) const;
  tl::expected<Candidates, robotlink::Errors> makePrograms(const Layouts& layouts);
  robotlink::Errors whyNot(const std::string& kind, const std::filesystem::path& layout);
  tl::expected<RobotHost::Candidate, robotlink::Errors> makeProgram(RobotHost& robot,
                                                                    const std::filesystem::path& file,
                                                                    const robotlink::Layout& layout);
  RobotHost* find(const std::string& robot) const;
  void startPrograms(Candidates candidates);
  void recordWorld();
  void recordStep();
  void stopPrograms();
  void reportTrouble(const robotlink::Process& process, const std::string& text);
  void watchGame();

  RunOptions options_;
  Listeners listeners_;
  std::shared_ptr<const robotlink::FieldDescription> field_;
  std::unique_ptr<SimulatedWorld> world_;
  std::unique_ptr<KickOff> kickOff_;   // null: see game()
  std::unique_ptr<ArcosPorts> ports_;  // null: there are none
  std::unique_ptr<RecordingTap> tap_;  // null: there is no recorder
  std::vector<std::unique_ptr<RobotHost>> robots_;
  std::vector<std::string> lostChoices_;
  int stepsToTransforms_ = 0;
  std::unique_ptr<ProgramExecutor> executor_;
};

}  // namespace app
