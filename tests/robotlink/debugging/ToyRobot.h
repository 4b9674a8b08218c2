// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/debugging/RobotProgram.h"
#include "robotlink/process/LockstepExecutor.h"
#include "robotlink/process/Platform.h"

namespace robotlink::testing {

/// A platform whose sensors count: every image and every joint state carries the number of its step. It
/// writes down every joint request that it gets. Its tasks, registered with it, are ball-percept [region,
/// broken, untidy], ball-model [last, oracle, throwing], behavior [go, obey] and motion [walk].
class ToyPlatform final : public Platform {
 public:
  using Platform::Platform;
  ~ToyPlatform() override { stop(); }

  void actuate() override;
  void engageStop(bool) override {}
  /// Every `n`-th step has an image.
  void setImageEvery(int n) { imageEvery_ = n; }
  const std::vector<std::string>& requests() const { return requests_; }
  /// Offers "oracle/classes", made with each image while somebody receives it.
  std::vector<AnySender*> onRequest() override { return {&classes_}; }
  int classesMade() const { return classesMade_; }

 protected:
  void execute() override;

 private:
  Sender<foxglove::RawImage> image_{*this, "camera/image", Blocking::kNo};
  Sender<foxglove::JointStates> joints_{*this, "joints/states", Blocking::kNo};
  Receiver<robotcontrol::JointRequest> request_{*this, "joints/request", Blocking::kNo};
  Sender<foxglove::RawImage> classes_{*this, "oracle/classes", Blocking::kNo};
  std::vector<std::string> requests_;  // serialised
  int classesMade_ = 0;
  int imageEvery_ = 5;
  int step_ = 0;
};

/// A layout of the toy tasks: cognition waits for images, motion for joint states.
extern const char* const kToyLayout;

/// A toy robot with a program in lockstep at 8 ms a step, and the ears of a workbench.
class ToyRobot {
 public:
  explicit ToyRobot(const std::string& layout = kToyLayout, std::filesystem::path parameterFolder = {});
  ~ToyRobot();

  /// Puts another layout on the platform; the reasons, if it is refused.
  Errors load(const std::string& layout);
  void run(int steps);
  /// Fills the id in, runs until an answer came, at most 100 steps; not accepted and "no answer" if none did.
  robotcontrol::RequestResult ask(robotcontrol::Request request);
  robotcontrol::RequestResult select(const std::string& task, const std::string& solution);
  robotcontrol::RequestResult setKey(const std::string& key, robotcontrol::KeyMode::Kind kind,
                                     unsigned n = 0);

  ManualClock clock;
  ToyPlatform platform{"toy", clock};
  LockstepExecutor executor;
  std::unique_ptr<RobotProgram> program;
  std::filesystem::path parameterFolder;
  std::vector<robotcontrol::DebugMessage> heard;  ///< everything, in order
  std::vector<std::string> starved;
  std::vector<std::string> failed;

  /// What was heard on a path.
  std::vector<const robotcontrol::DebugMessage*> on(const std::string& path) const;
  /// Which solution a task uses, by the newest table; empty if there is none.
  std::string active(const std::string& task) const;

 private:
  std::uint64_t nextId_ = 1;
};

/// How many objects of toy solutions live; for tests of switching.
int livingSolutions();

}  // namespace robotlink::testing
