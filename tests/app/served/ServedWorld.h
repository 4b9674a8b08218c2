// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "app/platforms/simulated/ArcosPorts.h"
#include "app/platforms/simulated/world/SimulatedWorld.h"
#include "robotlink/base/Resources.h"
#include "simcore/Scene.h"

/// The shipped world with one Pioneer, whose port is served by a thread in real time.
class ServedWorld {
 public:
  ServedWorld() {
    auto scene = simcore::Scene::load(robotlink::resource("scenes/pioneer.sdf"));
    if (!scene) throw std::runtime_error(robotlink::describe(scene.error()));
    auto world = app::SimulatedWorld::create(*scene, {});
    if (!world) throw std::runtime_error(world.error().describe());
    world_ = std::move(*world);
    openPorts(0);
    thread_ = std::thread([this] { run(); });
  }
  ~ServedWorld() {
    end_ = true;
    thread_.join();
  }
  ServedWorld(const ServedWorld&) = delete;
  ServedWorld& operator=(const ServedWorld&) = delete;

  const std::string& url() const { return url_; }
  /// Disconnects all clients and closes the port, until it is called with false.
  void unplug(bool unplugged) { unplugged_ = unplugged; }
  /// Whether the robot's motors are on.
  bool motorsOn() const { return motorsOn_; }
  /// How far the robot is from the origin along the x axis of the world, m.
  double x() const { return x_; }

 private:
  void openPorts(std::uint16_t port) {
    auto ports = app::ArcosPorts::open(*world_, {.address = "127.0.0.1", .firstPort = port});
    if (!ports) throw std::runtime_error(ports.error().describe());
    ports_ = std::move(*ports);
    port_ = ports_->ports().port(0);
    url_ = ports_->url(0);
  }
  void run() {
    auto due = std::chrono::steady_clock::now();
    while (!end_) {
      due += app::SimulatedWorld::kStep;
      if (unplugged_ && ports_) ports_.reset();
      if (!unplugged_ && !ports_) openPorts(port_);
      if (ports_) {
        ports_->serve(due);
      } else {
        std::this_thread::sleep_until(due);
      }
      world_->advance();
      const auto& robot = *world_->pioneers().front();
      motorsOn_ = robot.session().motion().motorsOn();
      x_ = world_->simulation().modelPose(robot.robot())->translation().x();
      if (ports_) ports_->deliver();
    }
  }

  std::unique_ptr<app::SimulatedWorld> world_;
  std::unique_ptr<app::ArcosPorts> ports_;
  std::uint16_t port_ = 0;
  std::string url_;
  std::atomic<bool> end_{false}, unplugged_{false}, motorsOn_{false};
  std::atomic<double> x_{0};
  std::thread thread_;
};
