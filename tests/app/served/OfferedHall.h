// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <future>
#include <stdexcept>
#include <string>
#include <thread>

#include "app/core/PlatformThread.h"
#include "app/core/remote/ProgramNotes.h"
#include "app/core/remote/SessionOffer.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/Session.h"

namespace app::test {

/// A remote simulated robot: its program runs in threads of its own and is offered to others, as by
/// `robotctl sim --listen`. The line to it can be cut.
class OfferedHall {
 public:
  explicit OfferedHall(PlatformOpening opening = SimulationFeed::opening(defaultSimulation())) {
    std::promise<std::string> url;
    auto known = url.get_future();
    thread_ = std::thread([this, opening = std::move(opening), &url] { run(opening, url); });
    url_ = known.get();
  }
  ~OfferedHall() {
    ended_ = true;
    thread_.join();
  }
  OfferedHall(const OfferedHall&) = delete;
  OfferedHall& operator=(const OfferedHall&) = delete;

  /// "ws://127.0.0.1:40123"
  const std::string& url() const { return url_; }
  /// Cuts the line to all clients, until it is called with false.
  void unplug(bool unplugged) { unplugged_ = unplugged; }
  /// Whether STOP is engaged.
  bool isStopped() const { return isStopped_; }
  /// Whether the debug key "ball-percept/disc" is on.
  bool drawsDisc() const { return drawsDisc_; }
  /// Whether the program uses a color table that was sent.
  bool hasTable() const { return hasTable_; }
  /// Whether the solution of ball-percept is circle-fit.
  bool fitsCircles() const { return fitsCircles_; }

 private:
  void run(const PlatformOpening& opening, std::promise<std::string>& url) {
    robotlink::Session session({std::chrono::seconds(2), 64U << 20U});
    logplayer::Recorder recorder({});
    PlatformThread platform(session, recorder);
    session.setRequestSink([&](const robotcontrol::Request& request) { platform.request(request); });
    SessionOffer offer(session);
    if (!offer.begin("127.0.0.1:0")) throw std::runtime_error("no port is free");
    const std::string address = offer.url().substr(std::string("ws://").size());
    auto loaded = std::make_shared<std::promise<LoadedPlatform>>();
    auto result = loaded->get_future();
    platform.open(opening, {}, [loaded](const auto& outcome) { loaded->set_value(outcome.value()); });
    const LoadedPlatform opened = result.get();
    std::vector<std::string> robots;
    for (const auto& [name, robot] : opened.robots) robots.push_back(name);
    session.setRobots(robots);
    publishPrograms(session, opened);
    robotcontrol::Request start;
    start.mutable_control_simulation()->set_action(robotcontrol::ControlSimulation::START);
    start.mutable_control_simulation()->set_speed(1);
    session.request(std::move(start));
    url.set_value("ws://" + address);
    while (!ended_) {
      session.tick();
      offer.tick();
      look(session);
      if (unplugged_ && offer.isOffered()) offer.end();
      if (!unplugged_ && !offer.isOffered()) static_cast<void>(offer.begin(address));
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    offer.end();
  }
  void look(robotlink::Session& session) {
    const auto now = session.store().newest();
    const auto* status = session.store().latestAs<robotcontrol::SimulationStatus>("simulation", now);
    isStopped_ = status != nullptr && status->stopped_robots_size() > 0;
    const auto* keys = session.store().latestAs<robotcontrol::KeyTable>("red1/tables/keys", now);
    const auto* solutions =
        session.store().latestAs<robotcontrol::SolutionTable>("red1/tables/solutions", now);
    const auto* table = session.store().latestAs<robotcontrol::ColorTable>("red1/tables/colors", now);
    bool disc = false, circle = false;
    for (int i = 0; keys != nullptr && i < keys->keys_size(); ++i) {
      const auto& key = keys->keys(i);
      disc = disc || (key.name() == "ball-percept/disc" && key.mode().kind() != robotcontrol::KeyMode::OFF);
    }
    for (int i = 0; solutions != nullptr && i < solutions->tasks_size(); ++i) {
      const auto& task = solutions->tasks(i);
      circle = circle || (task.name() == "ball-percept" && task.active() == "circle-fit");
    }
    drawsDisc_ = disc;
    fitsCircles_ = circle;
    hasTable_ = table != nullptr && table->source().ends_with(".c64");
  }

  std::string url_;
  std::atomic<bool> ended_{false}, unplugged_{false}, isStopped_{false}, drawsDisc_{false}, hasTable_{false},
      fitsCircles_{false};
  std::thread thread_;
};

}  // namespace app::test
