// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/RemoteRobots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "app/core/deploy/DeployJobs.h"
#include "app/core/recordings/RecordingJobs.h"
#include "app/core/remote/ImageCodings.h"
#include "app/core/remote/LinkAccess.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/foxglove/security/KnownServers.h"
#include "robotlink/foxglove/security/RememberedTokens.h"
#include "robotlink/foxglove/session/remote/SessionClient.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/LatchedMessages.h"
#include "robotlink/session/Session.h"

namespace app {
namespace {

using robotcontrol::KeyTable;
using robotcontrol::Request;
using robotlink::Instant;
using robotlink::Result;
namespace streams = robotlink::streams;
namespace websocket = robotlink::websocket;

/// Debug keys of packages, which recordings want as those of other robots.
constexpr char kPackageKeys[] = "package/";
/// The streams of a platform by which its newest time is known.
constexpr std::array kClocks{streams::kTransforms, streams::kSimulation, streams::kReplay};

}  // namespace

struct RemoteRobots::Line {
  std::string url, token;
  /// Whether the token is to be remembered once it was accepted.
  bool remembersToken = false;
  /// The limits that the client uses now.
  LinkLimits limits = {};
  std::unique_ptr<SessionClient> client;
  /// These use the client; null until they are needed.
  std::unique_ptr<RecordingJobs> recordings;
  std::unique_ptr<DeployJobs> deployment;
  std::uint64_t robotsVersion = 0;
  /// The beginning of the last gap that was noted in the robots' texts.
  std::optional<Instant> noted = {};
  /// The messages that were left out of its streams, by their paths.
  std::map<std::string, robotlink::MissingMessages> missing = {};

  void countLeftOut();
};

void RemoteRobots::Line::countLeftOut() {
  missing.clear();
  for (const auto& stream : client->streams()) {
    const robotlink::MissingMessages counted{stream.thinned.value_or(0), stream.dropped.value_or(0)};
    if (counted != robotlink::MissingMessages()) missing[stream.path] = counted;
  }
}

RemoteRobots::RemoteRobots(robotlink::Session& session, logplayer::Recorder& recorder,
                           const LinkLimitsMemory& limits)
    : session_(session),
      recorder_(recorder),
      limits_(limits),
      listener_(
          session.addListener({[this](const robotlink::StreamMessage& message) { record(message); }, {}})),
      notes_(std::make_shared<robotlink::BoundedQueue<robotlink::Error>>(100)) {}

RemoteRobots::~RemoteRobots() {
  session_.removeListener(listener_);
}

RemoteRobots::Line* RemoteRobots::find(const std::string& url) {
  const auto line = std::ranges::find(lines_, url, [](const auto& one) { return one->url; });
  return line == lines_.end() ? nullptr : line->get();
}

Result<std::string> RemoteRobots::connect(const std::string& url, const std::string& token) {
  // A person decides whom to trust; see trust().
  auto connection = linkOptions(url, token, askWhomToTrust());
  if (!connection) return tl::unexpected(connection.error());
  const std::string name = toString(connection->url);
  Line* line = find(name);
  if (line == nullptr) line = lines_.emplace_back(std::make_unique<Line>()).get();
  line->url = name;
  line->recordings.reset();
  line->deployment.reset();
  line->client.reset();
  SessionClient::Options options;
  line->token = connection->token;
  line->remembersToken = false;
  options.connection = std::move(*connection);
  options.isTaken = [this, line](const std::string& robot) { return isTaken(robot, line); };
  options.leadingTime = [this, line] { return leadingTime(*line); };
  options.convert = decodedImage;
  options.alsoWanted = [this](const std::string& path) { return recorded_.contains(path); };
  line->client = std::make_unique<SessionClient>(session_, std::move(options));
  line->limits = {};
  applyLimits();
  ++version_;
  return name;
}

Result<void> RemoteRobots::disconnect(const std::string& url) {
  const auto parsed = websocket::parseServerUrl(url);
  const Line* line = parsed ? find(toString(*parsed)) : nullptr;
  if (line == nullptr) return robotlink::failure("remote.none", "nothing is connected at " + url, {}, {url});
  if (leader_ == line) leader_ = nullptr;
  std::erase_if(lines_, [&](const auto& one) { return one.get() == line; });
  ++version_;
  showRobots();
  return {};
}

/// Foreign servers do not support these, and get no message as long as nothing is limited.
void RemoteRobots::applyLimits() {
  for (const auto& line : lines_) {
    const LinkLimits chosen = limits_.limits(line->url);
    if (std::exchange(line->limits, chosen) != chosen) apply(chosen, *line->client);
  }
}

std::vector<websocket::RemoteStream> RemoteRobots::streams(const std::string& url) const {
  const auto line = std::ranges::find(lines_, url, [](const auto& one) { return one->url; });
  return line == lines_.end() ? std::vector<websocket::RemoteStream>() : (*line)->client->streams();
}

DeployJobs* RemoteRobots::deployment(const std::string& url) {
  Line* line = find(url);
  if (line == nullptr) return nullptr;
  if (!line->deployment) line->deployment = std::make_unique<DeployJobs>(callsOf(line->client->client()));
  return line->deployment.get();
}

RecordingJobs* RemoteRobots::recordings(const std::string& url) {
  Line* line = find(url);
  if (line == nullptr) return nullptr;
  if (!line->recordings) line->recordings = std::make_unique<RecordingJobs>(callsOf(line->client->client()));
  return line->recordings.get();
}

Result<void> RemoteRobots::steer(const std::string& robot, bool giveUp) {
  for (const auto& line : lines_) {
    if (std::ranges::count(line->client->robots(), robot) == 0) continue;
    line->client->steer(robot, giveUp, [notes = notes_, robot](const Result<void>& done) {
      if (!done) notes->push({"steering.refused", robot + ": " + done.error().text, {robot}, {}});
    });
    return {};
  }
  return robotlink::failure("steering.none", robot + " is not a remote robot", {}, {robot});
}

Result<void> RemoteRobots::rememberToken(const std::string& url) {
  Line* line = find(url);
  if (line == nullptr) return robotlink::failure("remote.none", "nothing is connected at " + url, {}, {url});
  line->remembersToken = true;
  return {};
}

bool RemoteRobots::hasToken(const std::string& url) {
  return websocket::RememberedTokens().find(url).has_value();
}

Result<void> RemoteRobots::forgetToken(const std::string& url) {
  return websocket::RememberedTokens().forget(url);
}

void RemoteRobots::keepTokens() {
  for (const auto& line : lines_) {
    if (!line->remembersToken || !line->client->state().isConnected()) continue;
    line->remembersToken = false;
    const auto kept = websocket::RememberedTokens().add(line->url, line->token);
    if (!kept) notes_->push(kept.error());
  }
}

Result<void> RemoteRobots::trust(const std::string& url, const std::string& fingerprint) {
  Line* line = find(url);
  const auto objection = line == nullptr ? websocket::ServerObjection() : line->client->state().objection;
  if (objection.fingerprint.empty() || objection.fingerprint != fingerprint)
    return robotlink::failure("remote.fingerprint",
                              "the robot at " + url + " does not ask to be trusted by " + fingerprint, {},
                              {url, fingerprint});
  const auto added = websocket::KnownServers().add(objection.server, fingerprint);
  if (!added) return added;
  const bool remembers = line->remembersToken;
  const auto connected = connect(url, std::string(line->token));
  if (!connected) return tl::unexpected(connected.error());
  line->remembersToken = remembers;
  return {};
}

std::vector<RemoteRobots::Connection> RemoteRobots::connections() const {
  std::vector<Connection> all;
  for (const auto& line : lines_)
    all.push_back({line->url, line->client->state(), line->client->stateText() + inWords(line->limits),
                   limits(line->url), line->client->robots(), line->client->hasService("recordings/list"),
                   line->client->hasService("deploy/put")});
  return all;
}

std::vector<std::string> RemoteRobots::robots() const {
  std::vector<std::string> all;
  for (const auto& line : lines_) {
    const auto& robots = line->client->robots();
    all.insert(all.end(), robots.begin(), robots.end());
  }
  return all;
}

KnownRobot RemoteRobots::known(const std::string& robot) const {
  const auto found = described_.find(robot);
  return found == described_.end() ? KnownRobot() : found->second.known;
}

/// Remote robots that were connected before and have such a name are reconnected, under another one:
/// else STOP, and everything else, would reach one of the two.
void RemoteRobots::setPlatform(std::optional<std::set<std::string>> robots) {
  platform_ = std::move(robots);
  if (!platform_) return;
  const auto isOurs = [this](const std::string& robot) { return platform_->contains(robot); };
  for (const auto& line : lines_) {
    if (!std::ranges::any_of(line->client->robots(), isOurs)) continue;
    const bool remembers = line->remembersToken;
    const auto connected = connect(std::string(line->url), std::string(line->token));
    if (!connected) notes_->push(connected.error());
    line->remembersToken = remembers;
  }
}

bool RemoteRobots::isTaken(const std::string& robot, const Line* by) const {
  if (platform_ && platform_->contains(robot)) return true;
  return std::ranges::any_of(lines_, [&](const auto& line) {
    return line.get() != by && line->client && std::ranges::count(line->client->robots(), robot) > 0;
  });
}

std::optional<Instant> RemoteRobots::leadingTime(const Line& of) const {
  if (!platform_) {
    if (leader_ == nullptr || leader_ == &of) return std::nullopt;
    return leader_->client->newest().value_or(Instant());
  }
  Instant newest;
  for (const char* clock : kClocks) {
    const auto* message = session_.store().latest(clock, Instant::max());
    if (message != nullptr) newest = std::max(newest, message->time);
  }
  return newest;
}

void RemoteRobots::tick() {
  if (lines_.empty()) return;
  findLeader();
  for (const auto& line : lines_) {
    line->client->tick();
    const std::uint64_t version = line->client->robotsVersion();
    if (std::exchange(line->robotsVersion, version) != version) ++version_;
  }
  for (const auto& line : lines_) noteGaps(*line);
  keepTokens();
  applyLimits();
  describeRobots();
  showRobots();
  subscribeRecorded();
}

/// Chooses the first line heard, but foreign servers, which have no simulation, after the others; if none was
/// heard, the first. When another one leads, the session's time continues.
void RemoteRobots::findLeader() {
  const auto isHeard = [](const Line& line) { return line.client && line.client->newest().has_value(); };
  const auto hasWorld = [&](const Line& line) { return isHeard(line) && line.client->hasSession(); };
  if (leader_ != nullptr && hasWorld(*leader_)) return;
  auto found = std::ranges::find_if(lines_, [&](const auto& line) { return hasWorld(*line); });
  if (found == lines_.end() && leader_ != nullptr && isHeard(*leader_)) return;
  if (found == lines_.end())
    found = std::ranges::find_if(lines_, [&](const auto& line) { return isHeard(*line); });
  leader_ = found == lines_.end() ? lines_.front().get() : found->get();
}

/// Texts about gaps are among those of the robots, also in recordings.
void RemoteRobots::noteGaps(Line& line) {
  for (const auto& gap : line.client->gaps()) {
    if (!gap.to || (line.noted && gap.from <= *line.noted)) continue;
    line.noted = gap.from;
    auto text = std::make_shared<foxglove::Log>();
    robotlink::assign(*text->mutable_timestamp(), *gap.to);
    text->set_level(foxglove::Log::WARNING);
    text->set_name("link");
    text->set_message(fmt::format("Nothing was received for {:.1f} s{}{}",
                                  robotlink::seconds(*gap.to - gap.from), gap.reason.empty() ? "" : ": ",
                                  gap.reason));
    for (const std::string& robot : line.client->robots())
      session_.push({robot + "/" + streams::kLog, *gap.to, text, "link"});
  }
}

void RemoteRobots::describeRobots() {
  for (const std::string& robot : robots()) {
    const auto* message = session_.store().latest(robot + "/" + streams::kProgram, Instant::max());
    if (message == nullptr) continue;
    Described& described = described_[robot];
    if (described.setup == message->value) continue;
    described.setup = message->value;
    if (const auto* setup = dynamic_cast<const robotcontrol::ProgramSetup*>(message->value.get()))
      described.known = knownRobot(*setup);
    ++version_;
  }
}

/// Tells views how these robots are connected.
void RemoteRobots::showRobots() {
  // Left-out messages are counted less often, because there are many streams.
  constexpr unsigned kTicksBetween = 15;
  const bool counts = ticks_++ % kTicksBetween == 0;
  std::map<std::string, robotlink::RemoteRobot> shown;
  for (const auto& line : lines_) {
    if (counts) line->countLeftOut();
    std::vector<robotlink::LineGap> gaps;
    for (const auto& gap : line->client->gaps()) gaps.push_back({gap.from, gap.to, gap.reason});
    for (const std::string& robot : line->client->robots())
      shown[robot] = {line->url,     line->client->state().isConnected(), line->client->stateText(), gaps,
                      line->missing, !line->client->hasSession()};
  }
  session_.setRemoteRobots(std::move(shown));
}

bool RemoteRobots::take(const Request& request) {
  if (request.robot().empty() && platform_) return false;
  for (const auto& line : lines_) {
    if (!line->client->takes(request)) continue;
    line->client->request(request);
    return true;
  }
  return false;
}

void RemoteRobots::record(const robotlink::StreamMessage& message) {
  if (lines_.empty()) return;
  const std::string robot = robotlink::streams::robotOf(message.path);
  const bool isRemote = robot.empty() ? !platform_ : session_.remoteRobots().contains(robot);
  if (!isRemote || message.path == streams::kRecording) return;
  if ((recorder_.active() && recorder_.wants(message.path)) || robotlink::isLatched(message))
    recorder_.add({message});
}

void RemoteRobots::subscribeRecorded() {
  std::set<std::string> recorded;
  if (recorder_.status().recording()) {
    for (const auto& [robot, remote] : session_.remoteRobots()) {
      const auto* table = session_.store().latestAs<KeyTable>(robot + "/" + streams::kKeys, Instant::max());
      if (table == nullptr) continue;
      for (const auto& key : table->keys()) {
        const std::string path = robot + "/" + key.stream();
        if (key.name().starts_with(kPackageKeys) && recorder_.wants(path)) recorded.insert(path);
      }
    }
  }
  if (recorded == recorded_) return;
  recorded_ = std::move(recorded);
  for (const auto& line : lines_) line->client->updateSubscriptions();
}

}  // namespace app
