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
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/program/RobotProgram.h"
#include "robotlink/process/LockstepExecutor.h"
#include "robotlink/process/Platform.h"

namespace robotlink::test {

/// A platform whose sensors count: every image and every joint state contains the number of its step. It
/// stores all joint requests. The tasks that are registered with it are ball-percept [region, broken,
/// untidy], ball-model [last, oracle, throwing], behavior [go, obey] and motion [walk].
class ToyPlatform final : public Platform {
 public:
  using Platform::Platform;
  ~ToyPlatform() override { stop(); }

  void actuate() override;
  void engageStop(bool) override {}
  /// Every `n`-th step has an image.
  void setImageEvery(int n) { imageEvery_ = n; }
  const std::vector<std::string>& requests() const { return requests_; }
  /// Offers "oracle/classes", which is made with each image while there is a receiver.
  std::vector<AnySender*> onRequest() override { return {&classes_}; }
  int classesMade() const { return classesMade_; }

 protected:
  void execute() override;

 private:
  Sender<foxglove::RawImage> image_{*this, "camera/image", Blocking::kNo};
  Sender<foxglove::JointStates> joints_{*this, "joints/states", Blocking::kNo};
  Receiver<robotcontrol::JointRequest> request_{*this, "joints/request", Blocking::kNo};
  Sender<foxglove::RawImage> classes_{*this, "oracle/classes", Blocking::kNo};
  /// Serialized.
  std::vector<std::string> requests_;
  int classesMade_ = 0;
  int imageEvery_ = 5;
  int step_ = 0;
};

/// A layout of the toy tasks: cognition waits for images, motion for joint states.
extern const char* const kToyLayout;

/// A toy robot with a program in lockstep at 8 ms per step, and the debugging interface of a workbench.
class ToyRobot {
 public:
  explicit ToyRobot(const std::string& layout = kToyLayout, std::filesystem::path parameterFolder = {});
  ~ToyRobot();

  /// Loads another layout; returns the reasons if it is refused.
  Errors load(const std::string& layout);
  void run(int steps);
  /// Sends a request with a new id and runs until its reply arrives, for at most 100 steps; otherwise returns
  /// a refusal with the reason "no answer".
  robotcontrol::RequestResult ask(robotcontrol::Request request);
  robotcontrol::RequestResult select(const std::string& task, const std::string& solution);
  robotcontrol::RequestResult setKey(const std::string& key, robotcontrol::KeyMode::Kind kind,
                                     unsigned n = 0);

  ManualClock clock;
  ToyPlatform platform{"toy", clock};
  LockstepExecutor executor;
  std::unique_ptr<RobotProgram> program;
  std::filesystem::path parameterFolder;
  /// All debug messages in order.
  std::vector<robotcontrol::DebugMessage> heard;
  std::vector<std::string> starved;
  std::vector<std::string> failed;

  /// The messages on a path.
  std::vector<const robotcontrol::DebugMessage*> on(const std::string& path) const;
  /// The solution of a task according to the newest table; empty if there is none.
  std::string active(const std::string& task) const;

 private:
  std::uint64_t nextId_ = 1;
};

/// Number of existing toy solution objects, for tests of switching.
int livingSolutions();

}  // namespace robotlink::test
