// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/dds/RobotDiscovery.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <mutex>
#include <sstream>

#include "robotlink/base/Printable.h"
#include "robotlink/dds/LocalAddresses.h"
#include "robotlink/dds/Wire.h"

namespace robotlink::dds {
namespace {

constexpr const char* kRobotsTopic = "robotcontrol/robots";
/// The domain of announcements; programs of layouts have 0 unless their user says otherwise.
constexpr std::uint32_t kAnnouncementDomain = 229;
constexpr std::uint32_t kMaxAnnouncers = 256;
constexpr std::size_t kMaxNames = 100;

/// The marker of a robot that is only a body, in place of its layout.
constexpr char kBodyLayout[] = "(body)";

std::string textIn(const char* text) {
  return text != nullptr ? text : "";
}

/// Returns a text from the network as a terminal and a dialog may show it.
std::string shownText(const std::string& text) {
  constexpr std::size_t kMaxText = 100;
  return printable(text.substr(0, kMaxText));
}

bool isAddress(const std::string& text) {
  return !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '.' || c == ':' || c == '-' || c == '%';
  });
}

/// A line "KIND<tab>LAYOUT" for each robot. Older programs do not send them.
std::string detailsOf(const std::vector<AnnouncedRobot>& robots) {
  std::string text;
  for (const AnnouncedRobot& robot : robots)
    text += robot.kind + '\t' + (robot.isBody ? kBodyLayout : robot.layout) + '\n';
  return text;
}

std::string namesOf(const std::vector<AnnouncedRobot>& robots, const char* separator) {
  std::string names;
  for (const AnnouncedRobot& robot : robots) names += (names.empty() ? "" : separator) + robot.name;
  return names;
}

std::vector<AnnouncedRobot> robotsOf(const std::string& names, const std::string& details) {
  std::vector<AnnouncedRobot> robots;
  std::istringstream nameLines(names), detailLines(details);
  for (std::string name, line; robots.size() < kMaxNames && std::getline(nameLines, name);) {
    AnnouncedRobot& robot = robots.emplace_back();
    robot.name = shownText(name);
    if (!std::getline(detailLines, line)) continue;
    const std::size_t tab = line.find('\t');
    const std::string layout = tab == std::string::npos ? std::string() : line.substr(tab + 1);
    robot.kind = shownText(line.substr(0, tab));
    robot.isBody = layout == kBodyLayout;
    if (!robot.isBody) robot.layout = shownText(layout);
  }
  return robots;
}

/// Returns the robots of a sample; nothing if the sample is invalid.
std::optional<AnnouncedRobots> robotsIn(const robotlink_wire_Package& sample) {
  AnnouncedRobots robots;
  const auto* details = reinterpret_cast<const char*>(sample.data._buffer);
  robots.robots = robotsOf(textIn(sample.name),
                           details == nullptr ? std::string() : std::string(details, sample.data._length));
  robots.address = textIn(sample.sender);
  robots.fingerprint = shownText(textIn(sample.type));
  robots.isEncrypted = sample.kind != 0;
  robots.port = static_cast<std::uint16_t>(sample.number);
  if (!isAddress(robots.address) || sample.number == 0 || sample.number > 65535 || robots.robots.empty())
    return std::nullopt;
  return robots;
}

}  // namespace

std::string AnnouncedRobots::url() const {
  const std::string host = address.find(':') == std::string::npos ? address : "[" + address + "]";
  return (isEncrypted ? "wss://" : "ws://") + host + ":" + std::to_string(port);
}

std::string AnnouncedRobots::names() const {
  return namesOf(robots, ", ");
}

// ---- Announcing

struct RobotAnnouncement::Implementation {
  void send() const;

  AnnouncedRobots announced;
  std::vector<std::shared_ptr<Node>> nodes;
  /// The writers, one for each node.
  std::vector<Entity> writers;
};

void RobotAnnouncement::Implementation::send() const {
  const std::string names = namesOf(announced.robots, "\n"), details = detailsOf(announced.robots);
  for (std::size_t i = 0; i < writers.size(); ++i) {
    const std::string address = nodes[i]->address().empty() ? "127.0.0.1" : nodes[i]->address();
    write(writers[i].get(), {.name = names,
                             .type = announced.fingerprint,
                             .sender = address,
                             .number = announced.port,
                             .kind = static_cast<std::uint8_t>(announced.isEncrypted ? 1 : 0),
                             .data = details.data(),
                             .size = details.size()});
  }
}

RobotAnnouncement::RobotAnnouncement(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
RobotAnnouncement::~RobotAnnouncement() = default;

Result<std::unique_ptr<RobotAnnouncement>> RobotAnnouncement::open(std::vector<std::shared_ptr<Node>> nodes,
                                                                   const AnnouncedRobots& robots) {
  auto made = std::make_unique<Implementation>();
  for (const auto& node : nodes) {
    auto writer = openWriter(node->participant(), kRobotsTopic, History::kLatched);
    if (!writer) return tl::unexpected(writer.error());
    made->writers.push_back(std::move(*writer));
  }
  made->announced = robots;
  made->nodes = std::move(nodes);
  made->send();
  return std::unique_ptr<RobotAnnouncement>(new RobotAnnouncement(std::move(made)));
}

void RobotAnnouncement::update(const std::vector<AnnouncedRobot>& robots) {
  implementation_->announced.robots = robots;
  implementation_->send();
}

// ---- Listening

struct RobotDiscovery::Implementation {
  struct Network {
    std::shared_ptr<Node> node;
    /// The robots heard, by the handles of their writers.
    std::map<std::uint64_t, AnnouncedRobots> robots;
    Sample sample;
    Entity reader;
  };
  void update(Network& network) const;

  mutable std::mutex mutex;  // protects the networks
  std::vector<std::unique_ptr<Network>> networks;
};

RobotDiscovery::RobotDiscovery(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
RobotDiscovery::~RobotDiscovery() = default;

Result<std::unique_ptr<RobotDiscovery>> RobotDiscovery::open(std::vector<std::shared_ptr<Node>> nodes) {
  auto made = std::make_unique<Implementation>();
  for (auto& node : nodes) {
    auto network = std::make_unique<Implementation::Network>();
    auto reader = openReader(node->participant(), kRobotsTopic, History::kLatched);
    if (!reader) return tl::unexpected(reader.error());
    network->reader = std::move(*reader);
    network->node = std::move(node);
    made->networks.push_back(std::move(network));
  }
  return std::unique_ptr<RobotDiscovery>(new RobotDiscovery(std::move(made)));
}

void RobotDiscovery::Implementation::update(Network& network) const {
  while (const auto from = take(network.reader.get(), network.sample)) {
    if (const auto robots = robotsIn(network.sample.package)) network.robots[*from] = *robots;
  }
  dds_instance_handle_t present[kMaxAnnouncers];
  const auto count = std::min<std::int32_t>(
      dds_get_matched_publications(network.reader.get(), present, kMaxAnnouncers), kMaxAnnouncers);
  if (count < 0) return;
  std::erase_if(network.robots, [&](const auto& robots) {
    return std::find(present, present + count, robots.first) == present + count;
  });
}

std::vector<AnnouncedRobots> RobotDiscovery::robots() const {
  const std::lock_guard lock(implementation_->mutex);
  std::vector<AnnouncedRobots> all;
  for (const auto& network : implementation_->networks) {
    implementation_->update(*network);
    for (const auto& [writer, robots] : network->robots) {
      const auto isSame = [&, &found = robots](const AnnouncedRobots& other) {
        return other.url() == found.url();
      };
      if (std::none_of(all.begin(), all.end(), isSame)) all.push_back(robots);
    }
  }
  std::sort(all.begin(), all.end(), [](const AnnouncedRobots& a, const AnnouncedRobots& b) {
    return std::pair(a.names(), a.url()) < std::pair(b.names(), b.url());
  });
  return all;
}

std::vector<std::shared_ptr<Node>> announcementNodes(const std::string& address) {
  std::vector<std::string> addresses;
  if (address.empty() || address == "0.0.0.0" || address == "::") {
    addresses = localAddresses();
  } else {
    addresses = {address};
  }
  std::vector<std::shared_ptr<Node>> nodes;
  for (const std::string& one : addresses) {
    if (one.starts_with("127.") || one == "::1" || one == "localhost") continue;
    auto node = Node::open({.domain = kAnnouncementDomain, .address = one, .peers = {}, .multicast = true});
    if (node) nodes.push_back(std::move(*node));
  }
  return nodes;
}

}  // namespace robotlink::dds
