// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/modules/perception/LoggedRobot.h"
#include "robotlink/debugging/SharedDebugQueue.h"

#include <stdexcept>

#include "foxglove/Image.pb.h"
#include "logplayer/bhuman/QueueImport.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/process/Platform.h"

namespace modules {

namespace {

const std::filesystem::path kResources = ROBOTCONTROL_SOURCE_DIR "/resources";

robotlink::Layout layoutWith(const std::string& segmentation, const std::string& ballPercept) {
  return robotlink::parseLayout(
             "version: 1\nname: eyes\nprocesses:\n"
             "  - name: cognition\n    blocking: [camera/image]\n    tasks: [segmentation: " +
                 segmentation + ", ball-percept: " + ballPercept +
                 "]\n  - {name: debug, debug: true, period_ms: 8}\n",
             "eyes.yaml")
      .value();
}

robotlink::RobotSetup nao() {
  robotlink::RobotSetup robot;
  robot.name = "nao";
  robot.team = "red";
  robot.description = robotlink::readRobotDescription(kResources / "robots/nao.yaml").value();
  robot.field = std::make_shared<const robotlink::FieldDescription>(
      robotlink::FieldDescription::load(kResources / "fields/2009.yaml").value());
  return robot;
}

}  // namespace

/// Sends a view when there is a new one.
class LoggedRobot::Eyes final : public robotlink::Platform {
 public:
  using Platform::Platform;
  ~Eyes() override { stop(); }
  void actuate() override {}
  void engageStop(bool) override {}
  void show(const LoggedView& view) { view_ = view; }

 protected:
  void execute() override {
    if (!view_.image) return;
    pose_.AnySender::send(view_.pose);
    image_.AnySender::send(view_.image);
    view_ = {};
  }

 private:
  robotlink::Sender<foxglove::RawImage> image_{*this, robotlink::kCameraImage.name, robotlink::Blocking::kNo};
  robotlink::Sender<robotcontrol::CameraPose> pose_{*this, robotlink::kCameraPose.name,
                                                    robotlink::Blocking::kNo};
  LoggedView view_;
};

std::vector<LoggedView> readViews(const std::string& logFile) {
  using namespace logplayer::bhuman;
  std::vector<LoggedView> views;
  const auto bytes = openFile(logFile);
  if (!bytes) return views;
  const auto keep = [&views](const FrameConverter::Frame& frame) {
    LoggedView view{nullptr, nullptr, frame.front().time};
    for (const auto& message : frame) {
      if (message.path == "nao/camera/image") view.image = message.value;
      if (message.path == "nao/camera/pose") view.pose = message.value;
    }
    if (view.image && view.pose) views.push_back(view);
    return robotlink::Result<void>();
  };
  if (!importQueue(**bytes, "nao", keep, {})) views.clear();
  return views;
}

LoggedRobot::LoggedRobot(const std::string& segmentation, const std::string& ballPercept)
    : eyes_(std::make_unique<Eyes>("eyes", clock_)) {
  auto made = robotlink::RobotProgram::create(nao(), layoutWith(segmentation, ballPercept), *eyes_,
                                              {.folder = kResources / "parameters/nao"});
  if (!made) throw std::runtime_error(describe(made.error()));
  program_ = std::move(*made);
  program_->debugProcess().setListener([this](const auto& queue) { hear(*queue); });
  robotlink::LockstepExecutor::Options options;
  options.advance = [this] { clock_.advance(std::chrono::milliseconds(8)); };
  options.onFailed = [this](const robotlink::Process& process) { failures_.push_back(process.failure()); };
  executor_ = std::make_unique<robotlink::LockstepExecutor>(std::move(options));
  for (robotlink::Process* process : program_->processes()) executor_->add(*process);
  executor_->add(*eyes_);
  for (const char* package : {robotlink::kBallPercept.name, robotlink::kColorRegions.name}) {
    robotcontrol::Request request;
    request.mutable_set_key()->set_name(std::string("package/") + package);
    request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
    program_->debugProcess().request(request);
  }
}

LoggedRobot::~LoggedRobot() {
  executor_->clear();
}

void LoggedRobot::hear(const robotlink::SharedDebugQueue& queue) {
  for (const auto& message : queue.messages) {
    if (const auto* result = message.as<robotcontrol::RequestResult>()) results_.push_back(*result);
    if (const auto* percept = message.as<robotcontrol::BallPercept>()) percept_ = *percept;
    if (const auto* regions = message.as<robotcontrol::ColorRegions>()) regions_ = *regions;
  }
}

robotcontrol::BallPercept LoggedRobot::look(const LoggedView& view) {
  percept_.Clear();
  regions_.Clear();
  // Keys and tables that were just asked for arrive first.
  for (int i = 0; i < 4; ++i) executor_->step();
  eyes_->show(view);
  for (int i = 0; i < 4; ++i) executor_->step();
  return percept_;
}

std::string LoggedRobot::ask(robotcontrol::Request request) {
  request.set_id(++lastId_);
  program_->debugProcess().request(request);
  for (int i = 0; i < 10; ++i) {
    executor_->step();
    for (const auto& result : results_)
      if (result.id() == lastId_) return result.accepted() ? "" : result.reason();
  }
  return "no answer";
}

std::string LoggedRobot::setColorTable(const robotcontrol::ColorTable& table) {
  robotcontrol::Request request;
  *request.mutable_set_color_table()->mutable_table() = table;
  return ask(request);
}

}  // namespace modules
