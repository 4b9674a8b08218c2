// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/arcos/ArcosBench.h"

#include "robotlink/arcos/stream/OpenStream.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <stdexcept>

#include "tests/TestFolder.h"

namespace app {

using namespace robotlink::arcos;
using Clock = std::chrono::steady_clock;

WireClient::WireClient(const std::string& url) {
  auto opened = open(url);
  closed_ = !opened;
  if (opened) stream_ = std::move(*opened);
}

void WireClient::send(std::span<const std::uint8_t> bytes) {
  if (!stream_ || !stream_->write(bytes)) closed_ = true;
  sentBytes += bytes.size();
}

void WireClient::receive(robotlink::Instant now) {
  std::array<std::uint8_t, 4096> bytes;
  while (stream_) {
    const auto count = stream_->read(bytes, robotlink::Duration(0));
    if (!count) closed_ = true;
    if (!count || *count == 0) break;
    parser_.push(std::span(bytes).first(*count));
    while (auto found = parser_.next()) {
      EXPECT_TRUE(std::holds_alternative<Packet>(*found)) << "robots send no damage";
      if (std::holds_alternative<Packet>(*found)) store(std::get<Packet>(std::move(*found)), now);
    }
  }
}

StandardInformation WireClient::latest() const {
  for (auto packet = received.rbegin(); packet != received.rend(); ++packet) {
    if (hasId<StandardInformation>(packet->id)) return decode<StandardInformation>(*packet).value();
  }
  ADD_FAILURE() << "no information packet came";
  return {};
}

SimulatedWorld::Options ArcosBench::quiet() {
  SimulatedWorld::Options options;
  options.noise = false;
  return options;
}

namespace {

/// Reading a scene takes longer than most tests.
std::shared_ptr<const simcore::Scene> sceneOf(const std::filesystem::path& file, int robots) {
  simcore::RobotsToAdd add;
  add.count = robots;
  auto scene = simcore::Scene::load(file, add);
  if (!scene) throw std::runtime_error(describe(scene.error()));
  return *scene;
}

std::shared_ptr<const simcore::Scene> floorWith(const std::string& contents) {
  static std::map<std::string, std::shared_ptr<const simcore::Scene>> known;
  auto& scene = known[contents];
  if (scene) return scene;
  const TestFolder folder;
  std::ofstream(folder / "world.sdf")
      << R"(<sdf version="1.9"><world name="bench"><gravity>0 0 -9.81</gravity>
<model name="floor"><static>true</static><link name="floor"><collision name="floor"><geometry><plane>
<normal>0 0 1</normal><size>200 200</size></plane></geometry></collision></link></model>)"
      << contents << R"(<include><uri>model://p3at</uri><name>p3at1</name></include></world></sdf>)";
  return scene = sceneOf(folder / "world.sdf", 0);
}

}  // namespace

ArcosBench::ArcosBench(const std::string& contents, SimulatedWorld::Options world) {
  create(floorWith(contents), world);
}

ArcosBench::ArcosBench(const std::filesystem::path& scene, int robots, SimulatedWorld::Options world) {
  create(sceneOf(scene, robots), world);
}

void ArcosBench::create(std::shared_ptr<const simcore::Scene> scene, const SimulatedWorld::Options& world) {
  ArcosSimulation::Options options;
  options.world = world;
  options.speed = 0;
  options.ports.firstPort = 0;
  auto made = ArcosSimulation::create(std::move(scene), options,
                                      [this](const std::string& text) { reported.push_back(text); });
  if (!made) throw std::runtime_error(describe(made.error()));
  simulation_ = std::move(*made);
}

WireClient& ArcosBench::connect(std::size_t robot) {
  const auto& ports = simulation_->ports().ports();
  const std::uint64_t clients = ports.statistics(robot).clients;
  connections_.push_back({robot, std::make_unique<WireClient>(simulation_->ports().url(robot)), 0});
  for (int i = 0; i < 2000 && ports.statistics(robot).clients == clients; ++i) settle();
  EXPECT_EQ(ports.statistics(robot).clients, clients + 1) << "the client was not accepted";
  connections_.back().sentBefore = ports.statistics(robot).sentPackets;
  return *connections_.back().client;
}

std::unique_ptr<WireClient> ArcosBench::knock(std::size_t robot) {
  return std::make_unique<WireClient>(simulation_->ports().url(robot));
}

void ArcosBench::settle() {
  simulation_->ports().serve(Clock::now() + std::chrono::milliseconds(1));
}

void ArcosBench::step() {
  const auto& ports = simulation_->ports().ports();
  // What was sent is taken before the step...
  for (const Connection& connection : connections_) {
    for (int i = 0; i < 2000 && !connection.client->closed(); ++i) {
      const auto statistics = ports.statistics(connection.robot);
      if (statistics.client.empty() || statistics.receivedBytes >= connection.client->sentBytes) break;
      settle();
    }
  }
  simulation_->step();
  // ... and what came of it is read after it.
  for (Connection& connection : connections_) {
    const auto expected = ports.statistics(connection.robot).sentPackets - connection.sentBefore;
    const auto read = [&] { return connection.client->readPackets(); };
    for (int i = 0; i < 2000 && read() < expected && !connection.client->closed(); ++i) {
      if (i > 0) settle();
      connection.client->receive(now());
    }
  }
}

void ArcosBench::run(double seconds) {
  for (const auto end = now() + robotlink::fromSeconds(seconds); now() < end;) step();
}

void ArcosBench::drive(double seconds) {
  for (const auto end = now() + robotlink::fromSeconds(seconds); now() < end;) {
    for (Connection& connection : connections_) {
      if (!connection.client->closed()) connection.client->send(CommandId::kPulse);
    }
    run(std::min(0.5, robotlink::seconds(end - now())));
  }
}

}  // namespace app
