// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/PioneerRun.h"

#include "app/core/ProgramSetups.h"
#include "app/core/RecordingTap.h"
#include "app/core/SceneMessages.h"
#include "app/core/SolutionChoices.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/arcos/stream/StreamUrl.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/RobotProgram.h"
#include "robotlink/debugging/Streams.h"

namespace app {

using robotlink::Errors;
using robotlink::RobotProgram;

namespace {

const std::filesystem::path kPioneerFieldFile = "fields/2002.yaml";

}  // namespace

PioneerRun::PioneerRun(PioneerOptions options, Listeners listeners, logplayer::Recorder* recorder)
    : options_(std::move(options)),
      listeners_(std::move(listeners)),
      tap_(recorder != nullptr ? std::make_unique<RecordingTap>(*recorder) : nullptr),
      requests_(std::make_unique<ProgramRequests>(options_.robot)) {}

PioneerRun::~PioneerRun() {
  stop();
  if (stopSwitch_) stopSwitch_->forget();
  if (tap_) tap_->clear();
}

tl::expected<std::unique_ptr<PioneerRun>, Errors> PioneerRun::create(PioneerOptions options,
                                                                     Listeners listeners,
                                                                     logplayer::Recorder* recorder) {
  const auto url = robotlink::arcos::parseUrl(options.url);
  if (!url) return tl::unexpected(Errors{url.error()});
  options.url = robotlink::arcos::toString(*url);  // one way to write it, whichever it was given in
  auto run = std::unique_ptr<PioneerRun>(new PioneerRun(std::move(options), std::move(listeners), recorder));
  if (Errors errors = run->load(); !errors.empty()) return tl::unexpected(std::move(errors));
  return run;
}

Errors PioneerRun::load() {
  auto description = robotlink::readRobotDescription(descriptionFile(options_.kind));
  if (!description) return description.error();
  description_ = std::make_shared<const robotlink::RobotDescription>(std::move(*description));
  auto field = robotlink::FieldDescription::load(robotlink::resource(kPioneerFieldFile));
  if (!field) return field.error();
  field_ = std::make_shared<const robotlink::FieldDescription>(std::move(*field));
  if (!options_.map.empty()) {
    auto map = robotlink::GroundMap::load(options_.map);
    if (!map) return map.error();
    map_ = std::make_shared<const robotlink::GroundMap>(std::move(*map));
  }
  platform_ = std::make_unique<PioneerPlatform>(
      clock_, options_.robot, *description_,
      PioneerDriver::Options{.address = options_.url, .motorsOn = options_.motorsOn});
  if (const auto plain = robotlink::readLayout(layout())) {
    Errors errors = checkSolutions(options_.solutions, robotlink::registeredTasks(), {&*plain});
    if (!errors.empty()) return errors;
  }
  stopSwitch_ =
      std::make_shared<StopSwitch>(options_.robot, [this](bool engaged) { platform_->engageStop(engaged); });
  auto program = makeProgram(layout());
  if (!program) return program.error();
  if (tap_) tap_->restart();
  start(std::move(*program));
  return {};
}

std::filesystem::path PioneerRun::layout() const {
  return !options_.layout.empty() ? options_.layout
                                  : robotlink::resource("layouts/" + description_->layout + ".yaml");
}

tl::expected<std::unique_ptr<RobotProgram>, Errors> PioneerRun::makeProgram(
    const std::filesystem::path& file) {
  auto layout = readLayoutWith(file, options_.solutions);
  if (!layout) return tl::unexpected(layout.error());
  const robotlink::RobotSetup setup{options_.robot, "red", *description_, field_, map_};
  auto program = RobotProgram::create(setup, std::move(*layout), *platform_,
                                      {.folder = robotlink::resource("parameters/" + description_->name)});
  if (!program) return program;
  (*program)->debugProcess().setListener([this](auto queue) {
    requests_->answered(*queue);
    if (tap_) tap_->add(options_.robot, queue);
    if (listeners_.queue) listeners_.queue(options_.robot, std::move(queue));
  });
  return program;
}

void PioneerRun::start(std::unique_ptr<RobotProgram> program) {
  program_ = std::move(program);
  threads_ = std::make_unique<robotlink::ThreadExecutor>(robotlink::ThreadExecutor::Options{
      .onFailed =
          [this](const auto& process) {
            tellTrouble(process, "was stopped because it threw: " + process.failure());
          },
      .onPriorityRefused =
          [this](const auto& process, const auto& why) {
            tellTrouble(process, "runs with normal priority: " + why);
          }});
  if (tap_) {
    const ProgramFiles files{layout(), descriptionFile(options_.kind), robotlink::resource(kPioneerFieldFile),
                             "threads"};
    tap_->attach(options_.robot, *platform_, *program_, programSetup(*program_, *platform_, files));
    if (map_) tap_->world({robotlink::streams::kMap, clock_.now(), mapMessage(*map_, clock_.now())});
  }
  lostChoices_ = requests_->begin(*program_);
  handIn();
  for (robotlink::Process* process : program_->processes()) threads_->add(*process);
  threads_->start();
}

void PioneerRun::stop() {
  threads_.reset();
  if (program_) program_->stop();
  program_.reset();
}

void PioneerRun::tellTrouble(const robotlink::Process& process, const std::string& text) const {
  if (listeners_.trouble)
    listeners_.trouble(options_.robot, process, "Process " + process.name() + " " + text);
}

void PioneerRun::step() {
  if (tap_) tap_->askForPackages();
  platform_->tryBeginFrame();
  platform_->guard([&] { platform_->actuate(); });
  platform_->runFrame();
  threads_->clockAdvanced();
  if (tap_) tap_->endStep();
}

Errors PioneerRun::setLayout(const std::filesystem::path& file) {
  auto program = makeProgram(file);
  if (!program) return program.error();
  stop();
  options_.layout = file;
  start(std::move(*program));
  return {};
}

bool PioneerRun::isOfPlatform(const robotcontrol::Request& request) {
  return request.has_stop() || request.has_control_drive();
}

robotlink::Result<void> PioneerRun::request(const robotcontrol::Request& request) {
  if (request.robot() != options_.robot) {
    return robotlink::failure("request.no-robot", "there is no robot " + request.robot(), {},
                              {request.robot()});
  }
  if (request.has_stop()) {
    platform_->engageStop(request.stop().engaged());
    return {};
  }
  if (request.has_control_drive()) return platform_->control(request.control_drive());
  if (requests_->ask(request) && handIn()) return {};
  return robotlink::failure("request.queue-full",
                            options_.robot + " does not take requests now: too many wait already", {},
                            {options_.robot});
}

/// False: too many wait, some were dropped.
bool PioneerRun::handIn() {
  bool taken = true;
  for (const auto& request : requests_->take()) {
    const bool accepted = program_->debugProcess().request(request);
    if (accepted && tap_) tap_->handedIn(request);
    taken = taken && accepted;
  }
  return taken;
}

}  // namespace app
