// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/TeamRadio.h"

#include <algorithm>

#include "app/platforms/simulated/game/GameTime.h"
#include "robotcontrol/Game.pb.h"
#include "robotlink/base/Random.h"
#include "robotlink/packages/Conversions.h"

namespace app {

using robotlink::Instant;

namespace {

/// Separates these random numbers from others of the seed.
constexpr std::uint64_t kRadioStream = 0x7465616d2d726164ULL;
/// The maximum number of messages in transit to a station; the oldest is dropped.
constexpr std::size_t kMaxOnTheWay = 10'000;

std::uint64_t hashOf(const std::string& text) {
  std::uint64_t hash = 0;
  for (const char letter : text) hash = robotlink::mixBits(hash ^ static_cast<unsigned char>(letter));
  return hash;
}

}  // namespace

void TeamRadio::setSettings(const robotcontrol::TeamRadioSettings& settings) {
  if (settings.has_range()) settings_.range = settings.range();
  if (settings.has_delay()) settings_.delay = settings.delay();
  if (settings.has_loss()) settings_.loss = settings.loss();
}

void TeamRadio::restart(std::uint64_t seed) {
  seed_ = seed;
  for (auto& [robot, receiver] : receivers_) receiver = {};
  numbers_.clear();
  sent_ = lost_ = 0;
}

void TeamRadio::setStations(std::vector<Station> stations) {
  stations_ = std::move(stations);
  std::erase_if(receivers_, [this](const auto& entry) {
    return std::ranges::find(stations_, entry.first, &Station::robot) == stations_.end();
  });
}

bool TeamRadio::arrives(const Station& from, const Station& to, std::uint64_t number) const {
  if (settings_.range > 0 && (from.place - to.place).norm() > settings_.range) return false;
  if (settings_.loss <= 0) return true;
  const std::uint64_t way = hashOf(from.robot) ^ robotlink::mixBits(hashOf(to.robot));
  const std::uint64_t bits = robotlink::hashBits(seed_ ^ kRadioStream, way, number);
  return static_cast<double>(bits >> 11U) * 0x1.0p-53 >= settings_.loss;
}

void TeamRadio::send(const std::string& robot, const Message& message, Instant now) {
  const auto from = std::ranges::find(stations_, robot, &Station::robot);
  if (from == stations_.end() || from->team.empty() || !message) return;
  const std::uint64_t number = ++numbers_[robot];
  auto signedMessage = std::make_shared<robotcontrol::TeamMessage>(*message);
  signedMessage->set_sender(robot);
  signedMessage->set_team(from->team);
  for (const Station& to : stations_) {
    if (to.team != from->team || to.robot == robot) continue;
    ++sent_;
    if (!arrives(*from, to, number)) {
      ++lost_;
      continue;
    }
    auto& onTheWay = receivers_[to.robot].onTheWay;
    if (onTheWay.size() >= kMaxOnTheWay) onTheWay.erase(onTheWay.begin());
    onTheWay.push_back({now + robotlink::fromSeconds(settings_.delay), number, signedMessage});
  }
}

TeamRadio::Messages TeamRadio::receive(const std::string& robot, Instant now) {
  const auto found = receivers_.find(robot);
  if (found == receivers_.end()) return nullptr;
  Receiver& receiver = found->second;
  bool isNew = false;
  std::erase_if(receiver.onTheWay, [&](const OnTheWay& one) {
    if (one.due > now) return false;
    Heard& heard = receiver.heard[one.message->sender()];
    // A message that was overtaken because the delay was changed is outdated.
    if (one.number > heard.number) {
      heard = {one.number, one.message};
      isNew = true;
    }
    return true;
  });
  if (!isNew) return nullptr;
  auto messages = std::make_shared<robotcontrol::TeamMessages>();
  robotlink::assign(*messages->mutable_timestamp(), now);
  for (const auto& [sender, heard] : receiver.heard) *messages->add_messages() = *heard.message;
  return messages;
}

namespace {

constexpr std::size_t kMaxStations = 1000;

void transferMessage(simcore::StateStream& stream, TeamRadio::Message& message) {
  std::string bytes = message ? message->SerializeAsString() : std::string();
  stream.text(bytes);
  if (!stream.isReading()) return;
  auto read = std::make_shared<robotcontrol::TeamMessage>();
  if (!read->ParseFromString(bytes)) return stream.fail();
  message = std::move(read);
}

/// A map by names; `element` writes or reads a value.
template <typename Value, typename Element>
void transferMap(simcore::StateStream& stream, std::map<std::string, Value>& map, const Element& element) {
  std::vector<std::string> names;
  for (const auto& [name, value] : map) names.push_back(name);
  stream.size(names, kMaxStations);
  if (stream.isReading()) map.clear();
  for (std::string& name : names) {
    stream.text(name);
    element(map[name]);
  }
}

}  // namespace

void TeamRadio::transfer(simcore::StateStream& stream, Instant now) {
  stream.raw(sent_);
  stream.raw(lost_);
  transferMap(stream, numbers_, [&](std::uint64_t& number) { stream.raw(number); });
  transferMap(stream, receivers_, [&](Receiver& receiver) {
    stream.size(receiver.onTheWay, kMaxOnTheWay);
    for (OnTheWay& one : receiver.onTheWay) {
      robotlink::Duration rest = std::max(robotlink::Duration(), one.due - now);
      transferTime(stream, rest);
      one.due = now + rest;
      stream.raw(one.number);
      transferMessage(stream, one.message);
    }
    transferMap(stream, receiver.heard, [&](Heard& heard) {
      stream.raw(heard.number);
      transferMessage(stream, heard.message);
    });
  });
}

}  // namespace app
