// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/SimFigures.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "app/core/truth/ErrorFigures.h"
#include "app/platforms/simulated/ArcosSimulation.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "app/robotctl/run/GameFigures.h"

namespace app {
namespace {

using nlohmann::json;

double meanMilliseconds(robotlink::Duration total, std::uint64_t count) {
  return count == 0 ? 0 : robotlink::seconds(total) * 1000 / static_cast<double>(count);
}

double factor(double simulated, double real) {
  return real > 0 ? simulated / real : 0;
}

/// Contacts of robots on wheels with anything but the floor, as counted by the simulator.
json contactFigures(const SimulatedWorld& world, const std::string& robot) {
  const simcore::Simulation& simulation = world.simulation();
  return {{"name", robot},
          {"contacts", simulation.obstacleContacts(robot)},
          {"contact_seconds", robotlink::seconds(simulation.obstacleContactTime(robot))}};
}

json robotFigures(const ArcosSimulation& simulation, std::size_t index) {
  const auto line = simulation.ports().ports().statistics(index);
  json figures = contactFigures(simulation.world(), simulation.world().pioneers()[index]->robot());
  figures["url"] = simulation.ports().url(index);
  figures["clients"] = line.clients;
  figures["refused_clients"] = line.refused;
  figures["packets_received"] = line.received.packets;
  figures["checksum_errors"] = line.received.checksumErrors;
  figures["skipped_bytes"] = line.received.skippedBytes;
  figures["packets_sent"] = line.sentPackets;
  figures["packets_dropped"] = line.droppedPackets;
  figures["messages_not_shown"] = simulation.ports().suppressedTexts(index);
  return figures;
}

/// A number with separators: "12,345".
std::string grouped(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::string grouped(const json& figures, const char* name) {
  return grouped(figures.value(name, std::uint64_t{0}));
}

/// A number with three significant digits.
std::string rounded(double value) {
  const int decimals = value < 0.9995 ? 3 : value < 9.995 ? 2 : value < 99.95 ? 1 : 0;
  return fmt::format("{:.{}f}", value, decimals);
}

std::string timesText(std::uint64_t count) {
  return count == 1 ? "once" : grouped(count) + " times";
}

std::string secondsText(double seconds) {
  if (seconds > 0 && seconds < 0.9995) return rounded(1000 * seconds) + " ms";
  if (seconds < 600) return rounded(seconds) + " s";
  const auto whole = static_cast<std::uint64_t>(seconds);
  return fmt::format("{}:{:02}:{:02} h", whole / 3600, whole / 60 % 60, whole % 60);
}

/// Lines of a subject ("scene") and its values, aligned in columns.
class Lines {
 public:
  void add(const char* subject, const std::string& text) {
    text_ += fmt::format("{:<12}{}\n", subject, text);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string fileName(const json& figures, const char* name) {
  return std::filesystem::path(figures.value(name, std::string())).filename().string();
}

/// ", in the layout soccer", or, where they differ, ", in the layouts parallel (red1, red2) and soccer
/// (blue1)".
std::string layoutsText(const json& layouts) {
  std::map<std::string, std::string> robotsIn;
  for (const auto& [robot, file] : layouts.items()) {
    std::string& robots = robotsIn[std::filesystem::path(file.get<std::string>()).stem().string()];
    robots += (robots.empty() ? "" : ", ") + robot;
  }
  // Bodies have none here.
  robotsIn.erase("");
  if (robotsIn.empty()) return {};
  if (robotsIn.size() == 1) return ", in the layout " + robotsIn.begin()->first;
  std::string text;
  for (const auto& [layout, robots] : robotsIn) {
    const bool isLast = layout == robotsIn.rbegin()->first;
    text += fmt::format("{}{} ({})", text.empty() ? "" : isLast ? " and " : ", ", layout, robots);
  }
  return ", in the layouts " + text;
}

void addTimes(const json& figures, Lines& lines) {
  lines.add("time",
            fmt::format("{} simulated in {}: {} times real time", secondsText(figures["simulated_seconds"]),
                        secondsText(figures["real_seconds"]), rounded(figures["real_time_factor"])));
  if (figures.value("real_time_lost_seconds", 0.0) > 0) {
    lines.add("",
              fmt::format("{} behind real time, because steps took too long; a step was late by {} at most",
                          secondsText(figures["real_time_lost_seconds"]),
                          secondsText(figures["latest_step_seconds"])));
  }
  lines.add("physics",
            fmt::format("{} steps, {} ms each", grouped(figures, "steps"), rounded(figures["ms_per_step"])));
  if (figures.contains("ms_per_step_of_controllers"))
    lines.add("robots", rounded(figures["ms_per_step_of_controllers"]) +
                            " ms a step for their controllers and sensors");
  if (figures.value("images", 0) > 0)
    lines.add("images",
              fmt::format("{}, {} ms each", grouped(figures, "images"), rounded(figures["ms_per_image"])));
}

std::string contactText(const json& robot) {
  const std::uint64_t contacts = robot["contacts"];
  if (contacts == 0) return "touched nothing";
  return fmt::format("touched something {}, for {} in all", timesText(contacts),
                     secondsText(robot["contact_seconds"]));
}

/// Describes the damage in the received bytes: " (3 with wrong checksums)"; empty if there was none.
std::string damageText(const json& robot) {
  const std::uint64_t damaged = robot["checksum_errors"], skipped = robot["skipped_bytes"];
  std::string text;
  if (damaged > 0) text += fmt::format("{} with wrong checksums", grouped(damaged));
  if (skipped > 0) text += fmt::format("{}{} bytes of no packet", text.empty() ? "" : ", ", grouped(skipped));
  return text.empty() ? text : " (" + text + ")";
}

std::string clientText(const json& robot) {
  const std::uint64_t clients = robot["clients"];
  std::string text = fmt::format("{}: {} client{}", robot["url"].get<std::string>(), grouped(clients),
                                 clients == 1 ? "" : "s");
  if (robot["refused_clients"] > 0) text += fmt::format(" ({} refused)", grouped(robot, "refused_clients"));
  text += fmt::format(", {} packets received{}, {} sent", grouped(robot, "packets_received"),
                      damageText(robot), grouped(robot, "packets_sent"));
  if (robot["packets_dropped"] > 0) text += fmt::format(", {} dropped", grouped(robot, "packets_dropped"));
  if (const auto hidden = robot.value("messages_not_shown", std::uint64_t{0}); hidden > 0)
    text += fmt::format(", {} messages of clients not shown", grouped(hidden));
  return text + "; " + contactText(robot);
}

void addGame(const json& figures, Lines& lines) {
  const std::uint64_t contacts = figures.value("ball_contacts", std::uint64_t{0});
  if (contacts > 0) lines.add("ball", "touched " + timesText(contacts));
  if (!figures.contains("goals")) return;
  std::string goals;
  for (const auto& [team, count] : figures["goals"].items())
    goals = fmt::format("{} {}", team, count.get<int>()) + (goals.empty() ? "" : ", " + goals);
  lines.add("goals", goals);
}

}  // namespace

json figuresOf(SimulatedRun& run, double realSeconds) {
  const SimulatedWorld& world = run.world();
  const auto& costs = world.costs();
  const double simulated = robotlink::seconds(world.clock().now());
  json figures;
  figures["scene"] = run.options().scene.string();
  figures["layout"] = run.layout().string();
  figures["layouts"] = json::object();
  for (const std::string& robot : run.robots()) figures["layouts"][robot] = run.layoutOf(robot).string();
  figures["seed"] = world.options().seed;
  figures["threads"] = world.options().threads;
  figures["robots"] = run.robots().size();
  figures["simulated_seconds"] = simulated;
  figures["real_seconds"] = realSeconds;
  figures["real_time_factor"] = factor(simulated, realSeconds);
  figures["steps"] = costs.steps;
  figures["images"] = costs.images;
  figures["ms_per_step"] = meanMilliseconds(costs.physics, costs.steps);
  figures["ms_per_image"] = meanMilliseconds(costs.rendering, costs.images);
  figures["ms_per_step_of_programs"] = meanMilliseconds(run.programTime(), costs.steps);
  for (const auto& pioneer : world.pioneers())
    figures["robots_on_wheels"].push_back(contactFigures(world, pioneer->robot()));
  figures["ball_contacts"] = world.simulation().ballContacts();
  addGameFigures(run, figures);
  figures["digest"] = fmt::format("{:016x}", world.digest());
  return figures;
}

json figuresOf(const ArcosSimulation& simulation, double realSeconds) {
  const SimulatedWorld& world = simulation.world();
  const auto& costs = world.costs();
  const double simulated = robotlink::seconds(world.clock().now());
  json figures;
  figures["scene"] = simulation.options().scene.string();
  figures["seed"] = world.options().seed;
  figures["threads"] = world.options().threads;
  figures["kinematic"] = world.options().kinematic;
  figures["simulated_seconds"] = simulated;
  figures["real_seconds"] = realSeconds;
  figures["real_time_factor"] = factor(simulated, realSeconds);
  figures["steps"] = costs.steps;
  figures["ms_per_step"] = meanMilliseconds(costs.physics, costs.steps);
  figures["ms_per_step_of_controllers"] = meanMilliseconds(costs.pioneers, costs.steps);
  figures["latest_step_seconds"] = robotlink::seconds(simulation.punctuality().latest);
  figures["real_time_lost_seconds"] = robotlink::seconds(simulation.punctuality().lost);
  std::uint64_t contacts = 0;
  for (std::size_t i = 0; i < world.pioneers().size(); ++i) {
    figures["robots"].push_back(robotFigures(simulation, i));
    contacts += figures["robots"].back()["contacts"].get<std::uint64_t>();
  }
  figures["contacts"] = contacts;
  return figures;
}

std::string figuresText(const json& figures) {
  Lines lines;
  lines.add("scene",
            fmt::format("{}, seed {}", fileName(figures, "scene"), figures.value("seed", std::uint64_t{0})));
  if (figures.contains("layouts")) {
    const auto robots = figures["robots"].get<std::size_t>();
    lines.add("robots", fmt::format("{}{}", robots, layoutsText(figures["layouts"])));
  }
  if (figures.value("kinematic", false)) lines.add("movement", "by odometry, without forces");
  addTimes(figures, lines);
  addGame(figures, lines);
  for (const auto& robot : figures.value("robots_on_wheels", json::array()))
    lines.add(robot["name"].get<std::string>().c_str(), contactText(robot));
  if (figures.contains("robots") && figures["robots"].is_array()) {
    for (const auto& robot : figures["robots"])
      lines.add(robot["name"].get<std::string>().c_str(), clientText(robot));
  }
  if (figures.contains("digest")) lines.add("digest", figures["digest"]);
  return lines.text() + errorsText(figures.value("errors", json::object()));
}

}  // namespace app
