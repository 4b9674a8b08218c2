// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robotlink/debugging/ToyRobot.h"

#include <atomic>
#include <stdexcept>

#include "robotlink/packages/Conversions.h"

namespace robotlink::test {

using namespace std::chrono_literals;

// ---- The platform

void ToyPlatform::actuate() {
  if (request_.get() == nullptr) return;
  requests_.push_back(request_.get()->SerializeAsString());
}

void ToyPlatform::execute() {
  ++step_;
  auto joints = std::make_shared<foxglove::JointStates>();
  assign(*joints->mutable_timestamp(), frameTime());
  joints->add_joints()->set_position(step_);
  joints_.send(joints);
  if (step_ % imageEvery_ != 0) return;
  auto image = std::make_shared<foxglove::RawImage>();
  assign(*image->mutable_timestamp(), frameTime());
  image->set_width(static_cast<std::uint32_t>(step_));
  image_.send(image);
  if (!classes_.connected()) return;
  ++classesMade_;
  classes_.send(image);
}

const char* const kToyLayout = R"(version: 1
name: toy
processes:
  - name: cognition
    blocking: [camera/image]
    tasks:
      - ball-percept: region
      - ball-model: last
      - behavior: go
  - name: motion
    blocking: [joints/states]
    tasks:
      - motion: walk
  - {name: debug, debug: true, period_ms: 16}
)";

// ---- The tasks

namespace {

std::atomic<int> living{0};

struct Counted {
  Counted() { ++living; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  ~Counted() { --living; }
};

const ImageDrawingKey kDotKey{"ball-percept/dot", "A toy key"};
const PlotKey kModelKey{"ball-model/plot", "Another toy key"};
const PlotKey kOracleKey{"ball-model/oracle", "A toy key of the oracle"};

/// Its parameters' x is added to what it sees; its object counts its images.
class RegionBall final : public Solution, Counted {
 public:
  explicit RegionBall(SolutionContext& context)
      : image_(context.input(kCameraImage)),
        ball_(context.output(kBallPercept)),
        debug_(context.debug()),
        parameters_(context.parameters<robotcontrol::Velocity2>()) {}

  void execute() override {
    if (!image_.isNew()) return;
    auto ball = std::make_shared<robotcontrol::BallPercept>();
    ball->set_seen(true);
    ball->set_radius_in_image(image_->width() + parameters_.x());
    ball->set_confidence(++images_);
    if (debug_.on(kDotKey)) debug_.imageDrawing(kDotKey).dot({1, 2}, colors::kRed);
    ball_.send(ball);
  }

 private:
  Input<foxglove::RawImage> image_;
  Output<robotcontrol::BallPercept> ball_;
  DebugContext& debug_;
  const robotcontrol::Velocity2& parameters_;
  int images_ = 0;
};

class BrokenBall final : public Solution {
 public:
  explicit BrokenBall(SolutionContext& context) {
    throw std::runtime_error("no color table for " + context.robot().name);
  }
  void execute() override {}
};

/// Reads what its registration does not name.
class UntidyBall final : public Solution {
 public:
  explicit UntidyBall(SolutionContext& context) : pose_(context.input(kRobotPose)) {}
  void execute() override {}

 private:
  Input<robotcontrol::RobotPose> pose_;
};

class LastBall final : public Solution, Counted {
 public:
  explicit LastBall(SolutionContext& context)
      : percept_(context.input(kBallPercept)), model_(context.output(kBallModel)), debug_(context.debug()) {}

  void execute() override {
    auto model = std::make_shared<robotcontrol::BallModel>();
    model->set_known(static_cast<bool>(percept_));
    if (percept_) model->set_standard_deviation(percept_->radius_in_image());
    model->set_seconds_since_seen(percept_.isNew() ? 0 : 1);
    if (debug_.on(kModelKey)) debug_.plot(kModelKey, model->standard_deviation(), "m");
    model_.send(model);
  }

 private:
  Input<robotcontrol::BallPercept> percept_;
  Output<robotcontrol::BallModel> model_;
  DebugContext& debug_;
};

class OracleBall final : public Solution, Counted {
 public:
  explicit OracleBall(SolutionContext& context) : world_(context.input(kOracleWorld)) {}
  void execute() override {}

 private:
  Input<robotcontrol::OracleWorld> world_;
};

class ThrowingBall final : public Solution, Counted {
 public:
  explicit ThrowingBall(SolutionContext&) {}
  void execute() override { throw std::runtime_error("the ball has no covariance"); }
};

template <bool kObeys>
class Behavior final : public Solution, Counted {
 public:
  explicit Behavior(SolutionContext& context)
      : ball_(context.input(kBallModel)),
        remote_(context.input(kRemoteMotion)),
        motion_(context.output(kMotionRequest)),
        clock_(context.clock()) {}

  void execute() override {
    auto request = std::make_shared<robotcontrol::MotionRequest>();
    if (kObeys && remote_) *request = remote_->motion();
    assign(*request->mutable_timestamp(), clock_.now());
    if (!kObeys) request->mutable_walk()->set_x(ball_ ? ball_->standard_deviation() : 0);
    motion_.send(request);
  }

 private:
  Input<robotcontrol::BallModel> ball_;
  Input<robotcontrol::RemoteMotion> remote_;
  Output<robotcontrol::MotionRequest> motion_;
  const Clock& clock_;
};

class WalkMotion final : public Solution, Counted {
 public:
  explicit WalkMotion(SolutionContext& context)
      : joints_(context.input(kJointStates)),
        motion_(context.input(kMotionRequest)),
        request_(context.output(kJointRequest)),
        status_(context.output(kMotionStatus)),
        clock_(context.clock()) {}

  void execute() override {
    auto request = std::make_shared<robotcontrol::JointRequest>();
    assign(*request->mutable_timestamp(), clock_.now());
    request->add_positions(joints_ ? joints_->joints(0).position() : 0);
    request->add_positions(motion_ ? motion_->walk().x() : -1);
    request_.send(request);
    status_.send(std::make_shared<robotcontrol::MotionStatus>());
  }

 private:
  Input<foxglove::JointStates> joints_;
  Input<robotcontrol::MotionRequest> motion_;
  Output<robotcontrol::JointRequest> request_;
  Output<robotcontrol::MotionStatus> status_;
  const Clock& clock_;
};

const SolutionRegistration kRegionBall =
    SolutionBuilder<RegionBall>("ball-percept", "region", "Counts images.")
        .needs(kCameraImage)
        .yields(kBallPercept)
        .keys({&kDotKey})
        .parameters<robotcontrol::Velocity2>();
const SolutionRegistration kBrokenBall =
    SolutionBuilder<BrokenBall>("ball-percept", "broken", "Cannot be made.")
        .needs(kCameraImage)
        .yields(kBallPercept);
const SolutionRegistration kUntidyBall =
    SolutionBuilder<UntidyBall>("ball-percept", "untidy", "Reads too much.")
        .needs(kCameraImage)
        .yields(kBallPercept);
const SolutionRegistration kLastBall =
    SolutionBuilder<LastBall>("ball-model", "last", "Believes the last percept.")
        .needs(kBallPercept)
        .yields(kBallModel)
        .keys({&kModelKey});
const SolutionRegistration kOracleBall =
    SolutionBuilder<OracleBall>("ball-model", "oracle", "Knows the truth.")
        .needs(kOracleWorld)
        .yields(kBallModel)
        .keys({&kOracleKey});
const SolutionRegistration kThrowingBall =
    SolutionBuilder<ThrowingBall>("ball-model", "throwing", "Throws.").needs(kBallPercept).yields(kBallModel);
const SolutionRegistration kGo = SolutionBuilder<Behavior<false>>("behavior", "go", "Goes.")
                                     .needs(kBallModel)
                                     .uses(kRemoteMotion)
                                     .yields(kMotionRequest);
const SolutionRegistration kObey = SolutionBuilder<Behavior<true>>("behavior", "obey", "Obeys.")
                                       .needs(kBallModel)
                                       .uses(kRemoteMotion)
                                       .yields(kMotionRequest);
const SolutionRegistration kWalk = SolutionBuilder<WalkMotion>("motion", "walk", "Walks.")
                                       .needs(kJointStates)
                                       .needs(kMotionRequest)
                                       .yields(kJointRequest)
                                       .yields(kMotionStatus);

LockstepExecutor::Options optionsOf(ToyRobot& robot) {
  LockstepExecutor::Options options;
  options.advance = [&robot] { robot.clock.advance(8ms); };
  options.onStarved = [&robot](const Process& process, const std::string& what) {
    robot.starved.push_back(process.name() + " waits for " + what);
  };
  options.onFailed = [&robot](const Process& process) {
    robot.failed.push_back(process.name() + ": " + process.failure());
  };
  return options;
}

}  // namespace

int livingSolutions() {
  return living;
}

// ---- The robot

ToyRobot::ToyRobot(const std::string& layout, std::filesystem::path folder)
    : executor(optionsOf(*this)), parameterFolder(std::move(folder)) {
  const Errors errors = load(layout);
  if (!errors.empty()) throw std::runtime_error(describe(errors));
}

ToyRobot::~ToyRobot() {
  executor.clear();
}

Errors ToyRobot::load(const std::string& layout) {
  auto parsed = parseLayout(layout, "toy.yaml");
  if (!parsed) return parsed.error();
  RobotSetup setup;
  setup.name = "red1";
  setup.team = "red";
  auto made = RobotProgram::create(setup, std::move(*parsed), platform, {.folder = parameterFolder});
  if (!made) return made.error();
  executor.clear();
  program = std::move(*made);
  program->debugProcess().setListener([this](const std::shared_ptr<const SharedDebugQueue>& queue) {
    const robotcontrol::DebugQueue wire = toWire(*queue);
    heard.insert(heard.end(), wire.messages().begin(), wire.messages().end());
  });
  for (Process* process : program->processes()) executor.add(*process);
  executor.add(platform);
  return {};
}

void ToyRobot::run(int steps) {
  for (int i = 0; i < steps; ++i) executor.step();
}

robotcontrol::RequestResult ToyRobot::ask(robotcontrol::Request request) {
  const std::uint64_t id = nextId_++;
  request.set_id(id);
  program->debugProcess().request(request);
  const std::size_t before = heard.size();
  for (int i = 0; i < 100; ++i) {
    run(1);
    for (std::size_t at = before; at < heard.size(); ++at) {
      if (heard[at].has_result() && heard[at].result().id() == id) return heard[at].result();
    }
  }
  robotcontrol::RequestResult none;
  none.set_reason("no answer");
  return none;
}

robotcontrol::RequestResult ToyRobot::select(const std::string& task, const std::string& solution) {
  robotcontrol::Request request;
  request.mutable_select_solution()->set_task(task);
  request.mutable_select_solution()->set_solution(solution);
  return ask(request);
}

robotcontrol::RequestResult ToyRobot::setKey(const std::string& key, robotcontrol::KeyMode::Kind kind,
                                             unsigned n) {
  robotcontrol::Request request;
  request.mutable_set_key()->set_name(key);
  request.mutable_set_key()->mutable_mode()->set_kind(kind);
  request.mutable_set_key()->mutable_mode()->set_n(n);
  return ask(request);
}

std::vector<const robotcontrol::DebugMessage*> ToyRobot::on(const std::string& path) const {
  std::vector<const robotcontrol::DebugMessage*> result;
  for (const auto& message : heard) {
    if (message.path() == path) result.push_back(&message);
  }
  return result;
}

std::string ToyRobot::active(const std::string& task) const {
  const auto tables = on("tables/solutions");
  if (tables.empty()) return {};
  for (const auto& row : tables.back()->solutions().tasks()) {
    if (row.name() == task) return row.active();
  }
  return {};
}

}  // namespace robotlink::test
