// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/ServedPlatform.h"

#include <chrono>
#include <future>
#include <set>
#include <thread>

#include "app/core/PlatformThread.h"
#include "app/core/ServedRestarts.h"
#include "app/core/body/BodyInbox.h"
#include "app/core/body/BodyStreams.h"
#include "app/core/deploy/DeployServices.h"
#include "app/core/deploy/DeployedTables.h"
#include "app/core/platform/TextMessages.h"
#include "app/core/recordings/RecordingServices.h"
#include "app/core/remote/ImageCodings.h"
#include "app/core/remote/OfferAddress.h"
#include "app/core/remote/ProgramNotes.h"
#include "app/core/remote/RobotAnnouncer.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
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

/// Messages wait for this at most before they are passed on.
constexpr std::chrono::milliseconds kTick{5};
/// The same while there are no clients, whose first requests then wait for it.
constexpr std::chrono::milliseconds kIdleTick{50};
/// Different refusals that are printed, once each.
constexpr std::size_t kMaxRefusals = 1000;
/// Nobody scrolls back here; what clients get late is kept for each of them.
constexpr robotlink::StreamStore::Limits kHistory{std::chrono::seconds(2), 64U << 20U};

Request startOf(const LoadedPlatform& platform, double speed) {
  Request request;
  if (platform.isLogged()) {
    request.mutable_control_replay()->set_action(robotcontrol::ControlReplay::PLAY);
    if (speed > 0) request.mutable_control_replay()->set_speed(speed);
  } else {
    request.mutable_control_simulation()->set_action(robotcontrol::ControlSimulation::START);
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

/// What clients publish for bodies goes to these.
void takeCommands(SessionServer& server, const std::shared_ptr<BodyInbox>& bodies) {
  server.takeFromClients(
      {kBodyCommands, robotcontrol::BodyCommands::descriptor()->full_name(),
       [bodies, server = server.server()](const auto& client, const auto& robot, const auto& payload) {
         robotcontrol::BodyCommands commands;
         if (client.isReadOnly) return std::string("you may only watch");
         if (!commands.ParseFromString(payload)) return std::string("these commands make no sense");
         return bodies->put(robot, {client.id, shownName(client)}, std::move(commands),
                            server->clock().now());
       }});
}

}  // namespace

robotlink::Errors serve(PlatformOpening opening, const ServeOptions& options, logplayer::Recorder& recorder,
                        const std::function<bool()>& interrupted, std::ostream& out) {
  robotlink::Session session(kHistory);
  PlatformThread platform(session, recorder);
  session.setRequestSink([&](const Request& request) { platform.request(request); });
  // A part of it is what clients, robots and files say.
  const auto report = [&](const std::string& sentence) {
    out << robotlink::printable(sentence) + "\n" << std::flush;
  };
  session.setRefusalHandler(
      [&, told = std::set<std::string>()](const std::string& what, const std::string& reason) mutable {
        // What clients subscribe to is asked for again and again.
        if (told.size() < kMaxRefusals && told.insert(what + ": " + reason).second)
          report(what + ": " + reason);
      });
  SessionServer server(session, {}, report, options.steering);
  if (options.bodies) takeCommands(server, options.bodies);
  if (options.texts)
    session.addListener({[&](const robotlink::StreamMessage& message) { printLog(out, message); }, {}});
  std::optional<RecordingServices> recordings;
  if (!options.recordings.empty())
    recordings.emplace(server.server(), RecordingFolder(options.recordings), recorder);
  DeployedTables tables(session, ResourceFolder(options.resources));
  ServedRestarts restarts(session, platform);
  std::optional<DeployServices> deploying;
  if (!options.resources.empty())
    deploying.emplace(
        server.server(), ResourceFolder(options.resources),
        [&](const std::string& path) {
          tables.noteWritten(path);
          restarts.programs().noteWritten(path);
        },
        DeployServices::Programs{[&] { return restarts.programs().programs(); },
                                 [&](const auto& robot, const auto& layout, auto done) {
                                   restarts.ask(robot, layout, std::move(done));
                                 }});
  const auto access = listenAccess(options.address, options.access);
  if (!access) return {access.error()};
  server.setImageEncoders(imageEncoders());
  auto listener = Listener::open(server.server(), access->listening);
  if (!listener) return {listener.error()};
  for (const std::string& note : access->notes) out << note << std::endl;

  const auto result = std::make_shared<std::promise<Loaded>>();
  auto loaded = result->get_future();
  platform.open(std::move(opening), {}, [result](const Loaded& outcome) { result->set_value(outcome); });
  const auto tick = [&] {
    for (const auto& error : tables.tick()) report(error.describe());
    restarts.tick();
    session.tick();
    server.tick();
  };
  while (loaded.wait_for(kTick) != std::future_status::ready) {
    tick();
    if (interrupted()) return {};
  }
  const Loaded outcome = loaded.get();
  if (!outcome) return outcome.error();
  std::vector<std::string> robots;
  for (const auto& [name, robot] : outcome->robots) robots.push_back(name);
  session.setRobots(robots);
  publishPrograms(session, *outcome);
  restarts.setLoaded(*outcome);
  if (!options.resources.empty()) tables.begin();
  if (!outcome->isReal()) session.request(startOf(*outcome, options.speed));
  tick();  // who connects at once finds everything
  RobotAnnouncer announcer((*listener)->address(), *access);
  announcer.update(robotsToAnnounce(session));
  out << offerOf(*outcome, access->scheme(), **listener) << std::endl;

  std::optional<robotlink::Instant> end;
  PlatformFeed::Demand demand;
  while (!interrupted()) {
    tick();
    const bool isAlone = server.server()->clients().empty();
    const PlatformFeed::Demand wanted{!isAlone || options.seconds,
                                      server.isWanted(robotlink::streams::kTransforms)};
    if (std::exchange(demand, wanted) != wanted) platform.setDemand(wanted);
    const robotlink::Instant now = session.store().newest();
    if (options.seconds && !end && now != robotlink::Instant())
      end = now + robotlink::fromSeconds(*options.seconds);
    if (end && now >= *end) break;
    if (restarts.takeChanged()) announcer.update(robotsToAnnounce(session));
    std::this_thread::sleep_for(isAlone ? kIdleTick : kTick);
  }
  return {};
}

}  // namespace app
