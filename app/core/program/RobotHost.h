// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/core/program/ProgramExecutor.h"
#include "app/core/program/ProgramRequests.h"
#include "robotlink/base/Error.h"
#include "robotlink/config/RobotDescription.h"

namespace robotcontrol {
class DebugQueue;
class Request;
}  // namespace robotcontrol
namespace robotlink {
class RobotProgram;
struct FieldDescription;
struct GroundMap;
struct Layout;
struct ParameterSource;
}  // namespace robotlink

namespace app {

class RecordingTap;

/// What a robot is, wherever it is: in a simulation, at the end of a line, or in a log.
struct HostedRobot {
  std::string name;  ///< "red1"
  std::string team;  ///< empty: it plays in none
  std::shared_ptr<const robotlink::RobotDescription> description;
  std::shared_ptr<const robotlink::FieldDescription>
      field;  ///< not null; that of nothing where there is none
  std::shared_ptr<const robotlink::GroundMap> map = nullptr;  ///< null: it knows none
  std::filesystem::path fieldFile = {};                       ///< empty: there is none
};

/// One robot: what it is, the platform that it is on, the program that runs there, what a person chose for
/// all its programs, and the tap of the recorder. It outlives the programs, which are made anew by resets and
/// in other layouts.
///
/// One thread at a time; listeners are called in the program's threads. The tap must outlive it.
class RobotHost {
 public:
  struct Listeners {
    std::function<void(const std::string& robot, std::shared_ptr<const robotcontrol::DebugQueue>)> queue;
    /// A process was stopped, starves, or could not get its priority.
    std::function<void(const std::string& robot, const robotlink::Process& process, const std::string& text)>
        trouble;
    /// What its platform has to say of being set up and shut down, a sentence each.
    std::function<void(const std::string& robot, const std::string& text)> platform = {};
  };
  /// A program that has not run yet, and what it was made for.
  struct Candidate {
    std::unique_ptr<robotlink::Platform> platform;  ///< null: the robot's platform stays
    std::unique_ptr<robotlink::RobotProgram> program;
    std::filesystem::path layout;

    Candidate();
    Candidate(Candidate&&) noexcept;
    Candidate& operator=(Candidate&&) noexcept;
    ~Candidate();
  };

  /// `tap` may be null: nothing is recorded. `wishes`: what a person chose for this robot before.
  RobotHost(HostedRobot robot, Listeners listeners, RecordingTap* tap, ProgramOverrides overrides = {});
  ~RobotHost();
  RobotHost(const RobotHost&) = delete;
  RobotHost& operator=(const RobotHost&) = delete;

  const HostedRobot& robot() const { return robot_; }
  const std::string& name() const { return robot_.name; }
  const robotlink::RobotDescription& description() const { return *robot_.description; }
  /// Null before the first adopt().
  robotlink::Platform* platform() const { return platform_.get(); }
  /// The file of the layout that its program was made from last.
  const std::filesystem::path& layout() const { return layout_; }

  /// A program in a layout, for this platform, or, if that is null, for the one that the robot has. What runs
  /// now goes on.
  tl::expected<Candidate, robotlink::Errors> make(std::unique_ptr<robotlink::Platform> platform,
                                                  const std::filesystem::path& file,
                                                  const robotlink::Layout& layout);
  /// It takes the place of the program before, which has to be stopped.
  void adopt(Candidate candidate);
  /// Sets the platform up, if it is a new one, and puts both into an executor that has not begun. Returns a
  /// sentence for each of the person's choices that this program cannot fulfill.
  std::vector<std::string> begin(ProgramExecutor& executor);
  /// The program ends; its processes must not run any more. The platform stays.
  void stop();

  /// Hands a request to the program, or STOP and what concerns the base to the platform.
  robotlink::Result<void> request(const robotcontrol::Request& request);
  /// Before a step: hands the program what was asked since the last one.
  void enqueueRequests();
  /// After a step.
  void reportPlatform();
  /// The answers that the program will give in its next frames, if they were not given yet; null: there are
  /// none. Only in lockstep.
  std::shared_ptr<const robotcontrol::DebugQueue> answersToCome();
  ProgramOverrides overrides() const { return requests_.overrides(); }

  /// Whether the process is one of its program's or its platform.
  bool owns(const robotlink::Process& process) const;
  void reportTrouble(const robotlink::Process& process, const std::string& text) const;

 private:
  void record(ExecutorKind executor);
  void setUp();
  robotlink::Result<void> requestPlatform(const robotcontrol::Request& request);

  const HostedRobot robot_;
  const Listeners listeners_;
  RecordingTap* const tap_;
  ProgramRequests requests_;  // to all its programs
  std::unique_ptr<robotlink::Platform> platform_;
  std::unique_ptr<robotlink::RobotProgram> program_;
  std::filesystem::path layout_;
  bool platformIsSetUp_ = false;
};

}  // namespace app
