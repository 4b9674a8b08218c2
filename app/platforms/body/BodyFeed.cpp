// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/body/BodyFeed.h"

#include <thread>

#include "app/core/platform/HostingMemory.h"
#include "app/core/platform/RobotPublishing.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RobotFiles.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/base/TextParts.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/packages/GamePackages.h"

namespace app {

using robotlink::Errors;
using robotlink::websocket::ConnectionState;

namespace {

/// Readings come at 125 Hz and wait for the next step.
constexpr std::chrono::milliseconds kBodyStep{4};
constexpr std::chrono::milliseconds kBodyLook{5};

Errors bodyError(const std::string& text) {
  return {{"body.none", text, {}, {}}};
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
    if (before != context.overrides.end()) chosen.program.overrides = before->second;
    // The only robot that was open there, whatever its name.
    if (chosen.robot.empty() && context.overrides.size() == 1)
      chosen.program.overrides = context.overrides.begin()->second;
    chosen.program.hosting = hostingAtOpening(chosen.program.hosting, context.hosting, kAdapter);
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
  auto feed = std::unique_ptr<BodyFeed>(new BodyFeed(std::move(options), session, recorder, hosting, limits));
  for (const auto part : {&BodyFeed::findBody, &BodyFeed::describeRobot, &BodyFeed::startProgram})
    if (Errors errors = (feed.get()->*part)(); !errors.empty()) return tl::unexpected(std::move(errors));
  return feed;
}

tl::expected<FoundBody, Errors> BodyFeed::find(BodyOptions options) {
  robotlink::Session session;
  logplayer::Recorder recorder({});
  BodyFeed feed(std::move(options), session, recorder, nullptr, nullptr);
  for (const auto part : {&BodyFeed::findBody, &BodyFeed::describeRobot})
    if (Errors errors = (feed.*part)(); !errors.empty()) return tl::unexpected(std::move(errors));
  return FoundBody{feed.program_->robot(), feed.link_->body()->offer};
}

BodyFeed::BodyFeed(BodyOptions options, robotlink::Session& session, logplayer::Recorder& recorder,
                   HostingMemory* hosting, const LinkLimitsMemory* limits)
    : RealTimeFeed(session, recorder, hosting, kAdapter, kBodyStep),
      options_(std::move(options)),
      limits_(limits) {}

BodyFeed::~BodyFeed() {
  program_.reset();  // first, because the program uses the link
}

LinkLimits BodyFeed::limits() const {
  return limits_ == nullptr ? options_.limits : limits_->limits(options_.url);
}

Errors BodyFeed::findBody() {
  auto connection = linkOptions(options_.url, options_.token, options_.isTrusted);
  if (!connection) return {connection.error()};
  // The URL has no token that may be in the address, since users see it.
  options_.url = url_ = toString(connection->url);
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
    return "there is no robot " + wanted + " at " + options_.url + ", only " + robotlink::joined(robots) +
           "; choose one of them";
  const auto runsThere = is(BodyLink::Kind::kWithProgram);
  if (wanted.empty() ? !std::ranges::all_of(robots, runsThere) : !runsThere(wanted)) return {};
  return "the program of " + (wanted.empty() ? robotlink::joined(robots) : wanted) + " runs at " +
         options_.url + "; connect with \"program: there\", or start 'robotctl platform ... --listen' there";
}

std::string BodyFeed::whatIsMissing() const {
  const auto state = link_->state();
  if (!state.isConnected()) return state.reason.empty() ? "nothing answers there" : state.reason;
  const std::vector<std::string>& robots = link_->robots();
  if (robots.empty()) return "there is no robot at this address";
  const bool isBody = std::ranges::any_of(
      robots, [this](const auto& robot) { return link_->kindOf(robot) == BodyLink::Kind::kBody; });
  return isBody ? "it does not say which sensors it has; does 'robotctl platform' run there?"
                : "the program there does not say whether " + robotlink::joined(robots) + " is a body";
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
  if (!options_.program.map.empty()) {
    auto read = robotlink::GroundMap::load(options_.program.map);
    if (!read) return read.error();
    map = std::make_shared<const robotlink::GroundMap>(std::move(*read));
  }
  // A program in a process of its own also uses the body's texts about itself, if they could be read.
  const bool isRead = body.known.description && (body.known.field || body.setup->field().text().empty());
  if (isRead) options_.program.own.texts = body.setup;
  auto clock = std::make_unique<BodyClock>(local_);
  clock_ = clock.get();
  program_ =
      std::make_unique<RealTimeProgram>(options_.program,
                                        HostedRobot{body.offer.robot(), body.offer.team(), description, field,
                                                    map, fieldFileOf(*field), options_.program.map},
                                        std::move(clock), listenersOf(gate_), &recorder_);
  return {};
}

Errors BodyFeed::startProgram() {
  if (Errors errors = program_->checkSolutions(); !errors.empty()) return errors;
  // Team messages that arrive here directly are not received through the body, too.
  std::set<std::string> leftOut;
  if (options_.program.team.port) leftOut = {robotlink::kTeamMessages.name, robotlink::kTeamMessage.name};
  auto platform = std::make_unique<RemoteBodyPlatform>(*link_, *clock_, local_, leftOut);
  platform_ = platform.get();
  return program_->start(std::move(platform));
}

// ---- Running it

void BodyFeed::stepProgram() {
  followLimits();
  program_->step();
  noteRefusal();
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

LoadedPlatform BodyFeed::describe() const {
  LoadedPlatform loaded = RealTimeFeed::describe();
  loaded.title = program_->name() + " at " + url_;
  if (!program_->robot().field->name.empty()) loaded.field = program_->robot().field;
  return loaded;
}

}  // namespace app
