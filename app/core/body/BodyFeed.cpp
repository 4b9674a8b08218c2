// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/body/BodyFeed.h"

#include <thread>

#include "app/core/platform/HostingMemory.h"
#include "app/core/platform/RobotPublishing.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RealHosting.h"
#include "app/core/program/RobotFiles.h"
#include "app/core/program/SceneMessages.h"
#include "app/core/program/SolutionChoices.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/Streams.h"

namespace app {

using robotlink::Errors;
using robotlink::websocket::ConnectionState;

namespace {

/// Readings come at 125 Hz and wait for the next step.
constexpr std::chrono::milliseconds kBodyStep{4};
constexpr std::chrono::milliseconds kBodyStatusEvery{100};
constexpr std::chrono::milliseconds kBodyLook{5};

Errors bodyError(const std::string& text) {
  return {{"body.none", text, {}, {}}};
}

/// "red1, red2".
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

// ---- Making it

PlatformOpening BodyFeed::opening(BodyOptions options) {
  const auto url = robotlink::websocket::parseServerUrl(options.url);
  options.refusal = std::make_shared<BodyRefusal>();
  PlatformOpening opening{kAdapter, {url ? toString(*url) : options.url}, {}};
  opening.make = [options](const PlatformContext& context) -> PlatformOpening::Made {
    BodyOptions chosen = options;
    const auto before = context.overrides.find(chosen.robot);
    if (before != context.overrides.end()) chosen.overrides = before->second;
    // The only robot that was open there, whatever its name.
    if (chosen.robot.empty() && context.overrides.size() == 1)
      chosen.overrides = context.overrides.begin()->second;
    chosen.hosting = hostingAtOpening(chosen.hosting, context.hosting, kAdapter);
    return create(std::move(chosen), context.session, context.recorder, context.hosting, context.limits);
  };
  opening.refusal = [refusal = options.refusal] { return refusal->get(); };
  opening.withToken = [options](const std::string& token) {
    BodyOptions chosen = options;
    if (!token.empty()) chosen.token = token;
    return BodyFeed::opening(std::move(chosen));
  };
  return opening;
}

tl::expected<std::unique_ptr<BodyFeed>, Errors> BodyFeed::create(BodyOptions options,
                                                                 robotlink::Session& session,
                                                                 logplayer::Recorder& recorder,
                                                                 HostingMemory* hosting,
                                                                 const LinkLimitsMemory* limits) {
  auto feed = std::unique_ptr<BodyFeed>(new BodyFeed(std::move(options), session, recorder));
  feed->hosting_ = hosting;
  feed->limits_ = limits;
  for (const auto part : {&BodyFeed::findBody, &BodyFeed::describeRobot, &BodyFeed::startProgram})
    if (Errors errors = (feed.get()->*part)(); !errors.empty()) return tl::unexpected(std::move(errors));
  return feed;
}

tl::expected<FoundBody, Errors> BodyFeed::find(BodyOptions options) {
  robotlink::Session session;
  logplayer::Recorder recorder({});
  BodyFeed feed(std::move(options), session, recorder);
  for (const auto part : {&BodyFeed::findBody, &BodyFeed::describeRobot})
    if (Errors errors = (feed.*part)(); !errors.empty()) return tl::unexpected(std::move(errors));
  return FoundBody{feed.robot_->robot(), feed.link_->body()->offer};
}

BodyFeed::BodyFeed(BodyOptions options, robotlink::Session& session, logplayer::Recorder& recorder)
    : options_(std::move(options)),
      gate_(session),
      recorder_(recorder),
      tap_(std::make_unique<RecordingTap>(recorder)) {}

BodyFeed::~BodyFeed() {
  stopProgram();
  if (stopSwitch_) stopSwitch_->forget();
  tap_->clear();
}

LinkLimits BodyFeed::limits() const {
  return limits_ == nullptr ? options_.limits : limits_->limits(options_.url);
}

Errors BodyFeed::findBody() {
  auto connection = linkOptions(options_.url, options_.token, options_.isTrusted);
  if (!connection) return {connection.error()};
  // Without a token that may be in it, since users see it.
  options_.url = toString(connection->url);
  BodyLink::Options linking;
  linking.connection = std::move(*connection);
  linking.robot = options_.robot;
  linking.limits = limits();
  link_ = std::make_unique<BodyLink>(std::move(linking));
  robotlink::Instant heardAt = local_.now();
  std::uint64_t progress = 0;
  while (!link_->body()) {
    link_->tick();
    const auto state = link_->state();
    if (state.phase == ConnectionState::Phase::kRefused) return {refusalOf(options_.url, state)};
    if (const std::string why = whyNoBody(); !why.empty()) return bodyError(why);
    const std::uint64_t now = link_->progress();
    if (std::exchange(progress, now) != now) heardAt = local_.now();
    if (local_.now() - heardAt > options_.patience)
      return bodyError("no body" + (options_.robot.empty() ? "" : " of " + options_.robot) +
                       " was found at " + options_.url + ": " + whatIsMissing());
    std::this_thread::sleep_for(kBodyLook);
  }
  if (!link_->state().takesMessages)
    return bodyError("with this token you may only watch " + link_->body()->offer.robot() + " at " +
                     options_.url + "; its program needs the token to control it");
  return {};
}

std::string BodyFeed::whyNoBody() const {
  const std::string& wanted = options_.robot;
  const std::vector<std::string>& robots = link_->robots();
  const auto is = [this](BodyLink::Kind kind) {
    return [this, kind](const std::string& robot) { return link_->kindOf(robot) == kind; };
  };
  if (std::ranges::all_of(robots, is(BodyLink::Kind::kUnknown))) return {};
  if (!wanted.empty() && std::ranges::count(robots, wanted) == 0)
    return "there is no robot " + wanted + " at " + options_.url + ", only " + listed(robots) +
           "; choose one of them";
  const auto runsThere = is(BodyLink::Kind::kWithProgram);
  if (wanted.empty() ? !std::ranges::all_of(robots, runsThere) : !runsThere(wanted)) return {};
  return "the program of " + (wanted.empty() ? listed(robots) : wanted) + " runs at " + options_.url +
         "; connect with \"program: there\", or start 'robotctl platform ... --listen' there";
}

std::string BodyFeed::whatIsMissing() const {
  const auto state = link_->state();
  if (!state.isConnected()) return state.reason.empty() ? "nothing answers there" : state.reason;
  const std::vector<std::string>& robots = link_->robots();
  if (robots.empty()) return "no robot is there";
  const bool isBody = std::ranges::any_of(
      robots, [this](const auto& robot) { return link_->kindOf(robot) == BodyLink::Kind::kBody; });
  return isBody ? "it does not say which sensors it has; does 'robotctl platform' run there?"
                : "what is there does not say whether " + listed(robots) + " is a body";
}

Errors BodyFeed::describeRobot() {
  const BodyLink::Body& body = *link_->body();
  auto description = body.known.description;
  if (!description) {
    auto read = readRobot(body.offer.kind());
    if (!read) return read.error();
    description = *read;
  }
  auto field = body.known.field;
  if (!field) {
    const auto none = readField({});
    if (!none) return none.error();
    field = *none;
  }
  std::shared_ptr<const robotlink::GroundMap> map;
  if (!options_.map.empty()) {
    auto read = robotlink::GroundMap::load(options_.map);
    if (!read) return read.error();
    map = std::make_shared<const robotlink::GroundMap>(std::move(*read));
  }
  robot_ = std::make_unique<RobotHost>(HostedRobot{body.offer.robot(), body.offer.team(), description, field,
                                                   map, fieldFileOf(*field), options_.map},
                                       listenersOf(gate_), tap_.get(), options_.overrides);
  return {};
}

Errors BodyFeed::startProgram() {
  if (const auto plain = robotlink::readLayout(layoutFileInUse())) {
    Errors errors = checkSolutions(options_.solutions, robotlink::registeredTasks(), {&*plain});
    if (!errors.empty()) return errors;
  }
  auto platform = std::make_unique<RemoteBodyPlatform>(*link_, clock_, local_);
  platform_ = platform.get();
  stopSwitch_ =
      std::make_shared<StopSwitch>(name(), [this](bool engaged) { platform_->engageStop(engaged); });
  auto program = makeProgram(std::move(platform), layoutFileInUse());
  if (!program) return program.error();
  tap_->restart();
  adopt(std::move(*program));
  return {};
}

std::filesystem::path BodyFeed::layoutFileInUse() const {
  return !options_.layout.empty() ? options_.layout : layoutFile(robot_->description());
}

tl::expected<RobotHost::Candidate, Errors> BodyFeed::makeProgram(
    std::unique_ptr<robotlink::Platform> platform, const std::filesystem::path& file) {
  auto layout = readLayoutWith(file, options_.solutions);
  if (!layout) return tl::unexpected(layout.error());
  HostedProgram::Maker maker;
  if (!options_.spread.program.empty()) {
    auto spread = SpreadProgram::open(options_.spread, *layout, name(), clock_,
                                      [this](const std::string& text) { reportSpread(text); });
    if (!spread) return tl::unexpected(Errors{spread.error()});
    spread_ = std::move(*spread);
    maker = spread_->maker();
  } else if (options_.hosting.isOwn(name())) {
    maker = OwnProgram::maker(ownOptions());
  }
  return robot_->make({.platform = std::move(platform),
                       .file = file,
                       .layout = std::move(*layout),
                       .maker = std::move(maker)});
}

OwnProgram::Options BodyFeed::ownOptions() const {
  OwnProgram::Options own = options_.own;
  own.threads = own.inRealTime = true;
  // What the body says about itself counts there, too, if it could be read.
  const BodyLink::Body& body = *link_->body();
  const bool isRead = body.known.description && (body.known.field || body.setup->field().text().empty());
  if (isRead) own.texts = body.setup;
  return own;
}

void BodyFeed::reportSpread(const std::string& text) {
  if (options_.spreadReport) return options_.spreadReport(text);
  gate_.publishPlatform(name(), clock_.now(), text);
}

void BodyFeed::adopt(RobotHost::Candidate program) {
  robot_->adopt(std::move(program));
  executor_ = std::make_unique<ProgramExecutor>(ProgramExecutor::Options{
      .kind = ExecutorKind::kThreads,
      .trouble = [this](const auto& process, const auto& text) { robot_->reportTrouble(process, text); },
      .patience = kModulePatience,
      .stuck = [this](const auto&, const std::string& what) { robot_->noteStuck(what); }});
  lostChoices_ = robot_->begin(*executor_);
  if (const auto& map = robot_->robot().map)
    tap_->world({robotlink::streams::kMap, clock_.now(), mapMessage(*map, clock_.now())});
  executor_->start();
}

void BodyFeed::stopProgram() {
  if (!robot_) return;
  leftOver_.end(std::move(executor_), {robot_.get()});
  robot_->stop();
}

// ---- Running it

void BodyFeed::begin() {
  gate_.open();
  due_ = Clock::now();
  if (const auto& map = robot_->robot().map) {
    const auto now = clock_.now();
    gate_.publish({robotlink::streams::kMap, now, mapMessage(*map, now)});
    gate_.publishMapNotes(name(), now, *map);
  }
  publishStatus();
}

void BodyFeed::step() {
  leftOver_.forgetEnded();
  robot_->enqueueRequests();
  tap_->askForPackages();
  followLimits();
  executor_->step();
  noteRefusal();
  robot_->startStep();
  robot_->endStep();
  tap_->endStep();
  const auto real = Clock::now();
  // Missed steps are not made up for.
  due_ = std::max(due_ + kBodyStep, real);
  if (isRead_ && real - lastStatus_ >= kBodyStatusEvery) publishStatus();
}

void BodyFeed::followLimits() {
  if (limits_ != nullptr && std::exchange(limitsVersion_, limits_->version()) != limits_->version())
    link_->limit(limits());
}

void BodyFeed::noteRefusal() {
  if (!options_.refusal) return;
  const auto state = link_->state();
  const bool isRefused = state.phase == ConnectionState::Phase::kRefused;
  options_.refusal->set(isRefused ? Errors{refusalOf(options_.url, state)} : Errors{});
}

robotlink::Result<void> BodyFeed::requestRobot(const robotcontrol::Request& request) {
  if (request.robot() == name()) return robot_->request(request);
  return robotlink::failure("request.no-robot", "there is no robot " + request.robot(), {},
                            {request.robot()});
}

std::map<std::string, ProgramOverrides> BodyFeed::overrides() const {
  return {{name(), robot_->overrides()}};
}

Errors BodyFeed::setLayout(const std::filesystem::path& file) {
  if (spread_) return {SpreadProgram::refusalOfLayout(file)};
  auto program = makeProgram(nullptr, file);
  if (!program) return program.error();
  stopProgram();
  options_.layout = file;
  adopt(std::move(*program));
  return {};
}

void BodyFeed::publishLostOverrides() {
  for (const std::string& lost : lostChoices_)
    gate_.publishText(name(), "layout", clock_.now(), foxglove::Log::WARNING, lost);
}

robotlink::Result<void> BodyFeed::requestSimulation(const robotcontrol::Request& request) {
  if (!request.has_host_program()) return PlatformFeed::requestSimulation(request);
  const Errors errors = hostProgram(request.robot(), request.host_program());
  if (!errors.empty()) return tl::unexpected(errors.front());
  rememberHosting(hosting_, kAdapter, request.host_program(), options_.hosting);
  publishLostOverrides();
  return {};
}

Errors BodyFeed::hostProgram(const std::string& asked, const robotcontrol::HostProgram& choice) {
  using robotcontrol::HostProgram;
  if (Errors errors = refusalOfHosting(name(), asked, choice, spread_ != nullptr); !errors.empty())
    return errors;
  const HostingChoices before = options_.hosting;
  if (choice.where() != HostProgram::UNCHANGED)
    options_.hosting.choose(asked, choice.where() == HostProgram::OWN_PROCESS);
  const bool same = options_.hosting.isOwn(name()) == before.isOwn(name());
  if (same && !choice.start_again()) return {};
  auto program = makeProgram(nullptr, layoutFileInUse());
  if (!program) {
    options_.hosting = before;
    return program.error();
  }
  stopProgram();
  adopt(std::move(*program));
  return {};
}

LoadedPlatform BodyFeed::describe() const {
  LoadedPlatform loaded;
  loaded.adapter = kAdapter;
  loaded.time = TimeKind::kReal;
  loaded.sources = {options_.url};
  loaded.title = name() + " at " + options_.url;
  loaded.lostChoices = lostChoices_;
  loaded.robots[name()] = robot_->robot().description;
  if (!robot_->robot().field->name.empty()) loaded.field = robot_->robot().field;
  loaded.layout = layoutFileInUse();
  return loaded;
}

std::vector<std::string> BodyFeed::end() {
  gate_.keepReports();
  stopProgram();
  if (stopSwitch_) stopSwitch_->forget();
  robot_->endPlatform();
  return gate_.keptReports();
}

void BodyFeed::setDemand(const Demand& demand) {
  gate_.setRead(demand.anything);
  if (!std::exchange(isRead_, demand.anything) && demand.anything) publishStatus();
}

void BodyFeed::publishStatus() {
  lastStatus_ = Clock::now();
  const auto now = clock_.now();
  auto status = std::make_shared<robotcontrol::SimulationStatus>();
  status->set_time(robotlink::seconds(now));
  status->set_speed(1);
  status->set_requested_speed(1);
  status->set_running(true);
  status->set_is_real(true);
  status->set_scene(options_.url);
  status->add_robots(name());
  if (platform_->stopEngaged()) status->add_stopped_robots(name());
  gate_.publish({robotlink::streams::kSimulation, now, std::move(status)});
  gate_.publish({robotlink::streams::kRecording, now,
                 std::make_shared<robotcontrol::RecordingStatus>(recorder_.status())});
}

}  // namespace app
