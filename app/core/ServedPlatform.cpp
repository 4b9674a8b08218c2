// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/ServedPlatform.h"

#include <chrono>
#include <future>
#include <limits>
#include <set>
#include <thread>

#include "app/core/PlatformThread.h"
#include "app/core/ServedRestarts.h"
#include "app/core/deploy/DeployServices.h"
#include "app/core/deploy/DeployedTables.h"
#include "app/core/platform/ProgramTroubles.h"
#include "app/core/platform/TextMessages.h"
#include "app/core/program/ProgramExecutor.h"
#include "app/core/recordings/RecordingServices.h"
#include "app/core/remote/BodyInbox.h"
#include "app/core/remote/BodyStreams.h"
#include "app/core/remote/ImageCodings.h"
#include "app/core/remote/OfferAddress.h"
#include "app/core/remote/ProgramNotes.h"
#include "app/core/remote/RobotAnnouncer.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/BoundedQueue.h"
#include "robotlink/base/Printable.h"
#include "robotlink/dds/LocalAddresses.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/foxglove/server/Listener.h"
#include "robotlink/foxglove/session/SessionServer.h"

namespace app {
namespace {

using robotcontrol::Request;
using robotlink::websocket::Listener;
using robotlink::websocket::SessionServer;
using Loaded = tl::expected<LoadedPlatform, robotlink::Errors>;

/// Messages wait for this at most before they are passed on: a frame of a walking robot's motion, so that
/// what comes with one frame is sent together.
constexpr std::chrono::milliseconds kTick{8};
/// The same while there are no clients, whose first requests then wait for it.
constexpr std::chrono::milliseconds kIdleTick{50};
/// Different refusals that are printed, once each.
constexpr std::size_t kMaxRefusals = 1000;
/// A server has no views that look back. Delayed messages are buffered per client.
constexpr robotlink::StreamStore::Limits kHistory{std::chrono::seconds(2), 64U << 20U};

Request startOf(const LoadedPlatform& platform, double speed, bool isPaused) {
  using Simulation = robotcontrol::ControlSimulation;
  Request request;
  if (platform.isLogged()) {
    request.mutable_control_replay()->set_action(robotcontrol::ControlReplay::PLAY);
    if (speed > 0) request.mutable_control_replay()->set_speed(speed);
  } else {
    request.mutable_control_simulation()->set_action(isPaused ? Simulation::PAUSE : Simulation::START);
    request.mutable_control_simulation()->set_speed(speed);
  }
  return request;
}

/// "red1, red2 at ws://127.0.0.1:8765".
std::string offerOf(const LoadedPlatform& platform, const std::string& scheme, const Listener& listener) {
  std::string robots, urls;
  for (const auto& [name, robot] : platform.robots) robots += (robots.empty() ? "" : ", ") + name;
  for (const std::string& url : offerUrls(scheme, listener.address(), robotlink::dds::localAddresses()))
    urls += (urls.empty() ? "" : ", ") + url;
  return (robots.empty() ? platform.title : robots) + " at " + urls;
}

/// Prints a text of a program.
void printLog(std::ostream& out, const robotlink::StreamMessage& message) {
  const auto* text = dynamic_cast<const foxglove::Log*>(message.value.get());
  if (text == nullptr) return;
  const std::string robot = message.path.substr(0, message.path.find('/'));
  printText(out, message.time, robot + "/" + text->name(), text->message());
}

/// Passes on what goes wrong with the program of a robot.
void noteTrouble(ProgramTroubles& troubles, const robotlink::StreamMessage& message) {
  const std::string robot = message.path.substr(0, message.path.find('/'));
  const auto* status = dynamic_cast<const robotcontrol::HostingStatus*>(message.value.get());
  if (status != nullptr) troubles.note(robot, *status);
  const auto* text = dynamic_cast<const foxglove::Log*>(message.value.get());
  const bool isStop = text != nullptr && text->level() == foxglove::Log::ERROR &&
                      text->message().find(kStoppedText) != std::string::npos;
  if (isStop) troubles.note(robot, text->message());
}

/// Passes on, once each, which controllers were switched off; remote ones that are late are only named.
void noteControllers(const std::shared_ptr<ProgramTroubles>& troubles, std::set<std::string>& noted,
                     const robotlink::StreamMessage& message) {
  const auto* states = dynamic_cast<const robotcontrol::ControllerStates*>(message.value.get());
  if (states == nullptr) return;
  for (const auto& state : states->controllers()) {
    if (state.trouble().empty() || !noted.insert(state.path() + state.trouble()).second) continue;
    troubles->note(state.path(), "Controller " + state.path() +
                                     (state.is_external() ? ": " : std::string(" ") + kStoppedText) +
                                     state.trouble());
  }
}

/// Passes what clients publish for bodies to this inbox.
void takeCommands(SessionServer& server, const std::shared_ptr<BodyInbox>& bodies) {
  server.takeFromClients(
      {kBodyCommands, robotcontrol::BodyCommands::descriptor()->full_name(),
       [bodies, server = server.server()](const auto& client, const auto& robot, const auto& payload) {
         robotcontrol::BodyCommands commands;
         if (client.isReadOnly) return std::string("you may only watch");
         if (!commands.ParseFromString(payload)) return std::string("these commands are not valid");
         return bodies->put(robot, {client.id, shownName(client)}, std::move(commands),
                            server->clock().now());
       }});
}

/// Serves a platform, with all that clients are offered in addition to its streams.
class Service {
 public:
  using Interrupted = std::function<bool()>;

  /// The arguments must outlive it.
  Service(const ServeOptions& options, logplayer::Recorder& recorder, std::ostream& out)
      : options_(options),
        out_(out),
        platform_(session_, recorder),
        server_(
            session_, {}, [this](const std::string& sentence) { report(sentence); }, options.steering),
        tables_(session_, ResourceFolder(options.resources)),
        restarts_(session_, platform_) {
    session_.setRequestSink([this](const Request& request) { platform_.request(request); });
    platform_.onRobotsChanged([this](const Loaded& loaded) {
      if (loaded) changes_.push(*loaded);
    });
    session_.setRefusalHandler(
        [this](const auto& what, const auto& reason) { reportOnce(what + ": " + reason); });
    // Only the workbench records on this request; clients record here with the services recordings/start.
    server_.withhold("control_recording");
    if (options.bodies) takeCommands(server_, options.bodies);
    if (options.texts)
      session_.addListener({[&out](const robotlink::StreamMessage& message) { printLog(out, message); }, {}});
    if (options.troubles)
      session_.addListener({[troubles = options.troubles](const robotlink::StreamMessage& message) {
                              noteTrouble(*troubles, message);
                            },
                            {}});
    if (options.troubles)
      session_.addListener({[troubles = options.troubles, noted = std::set<std::string>()](
                                const robotlink::StreamMessage& message) mutable {
                              noteControllers(troubles, noted, message);
                            },
                            {}});
    if (!options.recordings.empty())
      recordings_.emplace(server_.server(), RecordingFolder(options.recordings), recorder);
    if (!options.resources.empty()) offerDeploying();
    server_.setImageEncoders(imageEncoders());
  }

  /// Serves until the user interrupts it, or until the time of the options is over.
  robotlink::Errors run(PlatformOpening opening, const Interrupted& interrupted) {
    if (auto listening = listen(); !listening) return {listening.error()};
    const auto loaded = open(std::move(opening), interrupted);
    if (!loaded) return {};
    if (!*loaded) return loaded->error();
    begin(**loaded);
    while (!interrupted()) {
      tick();
      const bool isAlone = server_.server()->clientCount() == 0;
      followDemand(isAlone);
      if (isOver()) break;
      if (restarts_.takeChanged()) announcer_->update(robotsToAnnounce(session_));
      std::this_thread::sleep_for(isAlone ? kIdleTick : kTick);
    }
    return {};
  }

 private:
  /// Prints a sentence, a part of which is what clients, robots and files say.
  void report(const std::string& sentence) { out_ << robotlink::printable(sentence) + "\n" << std::flush; }
  /// Reports a refusal only once, since clients repeat their subscriptions.
  void reportOnce(const std::string& refusal) {
    if (refusals_.size() < kMaxRefusals && refusals_.insert(refusal).second) report(refusal);
  }
  void offerDeploying();
  robotlink::Result<void> listen();
  /// Opens the platform, and waits for that. Nothing if it was interrupted meanwhile.
  std::optional<Loaded> open(PlatformOpening opening, const Interrupted& interrupted);
  /// Starts the platform, and says where it is offered.
  void begin(const LoadedPlatform& loaded);
  void tick();
  /// Offers the robots that there are.
  void offerRobots(const LoadedPlatform& loaded);
  /// Tells the platform what of it is read.
  void followDemand(bool isAlone);
  bool isOver();

  const ServeOptions& options_;
  std::ostream& out_;
  /// The refusals that have been printed.
  std::set<std::string> refusals_;
  /// From the platform's thread. Unbounded: each belongs to a request, of which there are not more.
  robotlink::BoundedQueue<LoadedPlatform> changes_{std::numeric_limits<std::size_t>::max()};
  robotlink::Session session_{kHistory};
  PlatformThread platform_;
  SessionServer server_;
  std::optional<RecordingServices> recordings_;
  DeployedTables tables_;
  ServedRestarts restarts_;
  std::optional<DeployServices> deploying_;
  std::optional<ListenAccess> access_;
  std::unique_ptr<Listener> listener_;
  std::optional<RobotAnnouncer> announcer_;
  /// The instant at which the time of the options is over; unset before the platform has a time.
  std::optional<robotlink::Instant> end_;
  PlatformFeed::Demand demand_;
};

void Service::offerDeploying() {
  deploying_.emplace(
      server_.server(), ResourceFolder(options_.resources),
      [this](const std::string& path) {
        tables_.noteWritten(path);
        restarts_.programs().noteWritten(path);
      },
      DeployServices::Programs{[this] { return restarts_.programs().programs(); },
                               [this](const auto& robot, const auto& layout, auto done) {
                                 restarts_.ask(robot, layout, std::move(done));
                               }});
}

robotlink::Result<void> Service::listen() {
  auto access = listenAccess(options_.address, options_.access);
  if (!access) return tl::unexpected(access.error());
  auto listener = Listener::open(server_.server(), access->listening);
  if (!listener) return tl::unexpected(listener.error());
  access_ = std::move(*access);
  listener_ = std::move(*listener);
  for (const std::string& note : access_->notes) out_ << note << std::endl;
  return {};
}

std::optional<Loaded> Service::open(PlatformOpening opening, const Interrupted& interrupted) {
  const auto result = std::make_shared<std::promise<Loaded>>();
  auto loaded = result->get_future();
  platform_.open(std::move(opening), {}, [result](const Loaded& outcome) { result->set_value(outcome); });
  while (loaded.wait_for(kTick) != std::future_status::ready) {
    tick();
    if (interrupted()) return std::nullopt;
  }
  return loaded.get();
}

void Service::offerRobots(const LoadedPlatform& loaded) {
  std::vector<std::string> robots;
  for (const auto& [name, robot] : loaded.robots) robots.push_back(name);
  session_.setRobots(robots);
  publishPrograms(session_, loaded);
  restarts_.setLoaded(loaded);
  if (announcer_) announcer_->update(robotsToAnnounce(session_));
}

void Service::begin(const LoadedPlatform& loaded) {
  offerRobots(loaded);
  if (!options_.resources.empty()) tables_.begin();
  if (!loaded.isReal()) session_.request(startOf(loaded, options_.speed, options_.isPaused));
  tick();  // who connects at once finds everything
  announcer_.emplace(listener_->address(), *access_);
  announcer_->update(robotsToAnnounce(session_));
  out_ << offerOf(loaded, access_->scheme(), *listener_) << std::endl;
  if (options_.isPaused)
    out_ << "It is paused until a client calls control_simulation with {\"action\": \"START\"}" << std::endl;
}

void Service::tick() {
  for (const LoadedPlatform& loaded : changes_.drain()) offerRobots(loaded);
  for (const auto& error : tables_.tick()) report(error.describe());
  restarts_.tick();
  const robotlink::websocket::Server::Batch batch(*server_.server());
  session_.tick();
  server_.tick();
}

void Service::followDemand(bool isAlone) {
  const PlatformFeed::Demand wanted{!isAlone || options_.seconds,
                                    server_.isWanted(robotlink::streams::kTransforms),
                                    server_.isWanted(robotlink::streams::kForces)};
  if (std::exchange(demand_, wanted) != wanted) platform_.setDemand(wanted);
}

bool Service::isOver() {
  const robotlink::Instant now = session_.store().newest();
  if (options_.seconds && !end_ && now != robotlink::Instant())
    end_ = now + robotlink::fromSeconds(*options_.seconds);
  return end_ && now >= *end_;
}

}  // namespace

robotlink::Errors serve(PlatformOpening opening, const ServeOptions& options, logplayer::Recorder& recorder,
                        const std::function<bool()>& interrupted, std::ostream& out) {
  return Service(options, recorder, out).run(std::move(opening), interrupted);
}

}  // namespace app
