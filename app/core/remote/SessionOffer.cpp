// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/SessionOffer.h"

#include <algorithm>

#include "app/core/remote/ImageCodings.h"
#include "app/core/remote/ListenAccess.h"
#include "app/core/remote/OfferAddress.h"
#include "robotlink/dds/LocalAddresses.h"
#include "robotlink/foxglove/server/Listener.h"
#include "robotlink/foxglove/session/SessionServer.h"

namespace app {
namespace {

using robotlink::websocket::Listener;
using robotlink::websocket::SessionServer;

/// Clients are measured, and robots looked at, so often.
constexpr robotlink::Duration kMeasureEvery = std::chrono::seconds(1);
constexpr std::size_t kMaxReports = 20;

}  // namespace

SessionOffer::SessionOffer(robotlink::Session& session)
    : session_(session), reported_(std::make_shared<robotlink::BoundedQueue<std::string>>(100)) {}

SessionOffer::~SessionOffer() {
  end();
}

robotlink::Result<void> SessionOffer::begin(const std::string& address) {
  const auto where = parseOfferAddress(address);
  if (!where) return tl::unexpected(where.error());
  if (isOffered() && listener_->address() == *where) return {};
  const auto access = listenAccess(*where, {});
  if (!access) return tl::unexpected(access.error());
  auto server = std::make_unique<SessionServer>(
      session_, robotlink::websocket::ServerOptions{},
      [queue = reported_](const std::string& sentence) { queue->push(sentence); });
  server->setImageEncoders(imageEncoders());
  server->onSteerElsewhere(steerElsewhere_);
  auto listener = Listener::open(server->server(), access->listening);
  if (!listener) return tl::unexpected(listener.error());
  end();
  server_ = std::move(server);
  listener_ = std::move(*listener);
  localAddresses_ = robotlink::dds::localAddresses();
  urls_ = offerUrls(access->scheme(), listener_->address(), localAddresses_);
  notes_ = access->notes;
  admission_ = access->listening.admission;
  announcer_ = std::make_unique<RobotAnnouncer>(listener_->address(), *access, nodes_);
  announce();
  return {};
}

void SessionOffer::end() {
  announcer_.reset();
  listener_.reset();
  server_.reset();
  clients_.clear();
  sent_.clear();
  urls_.clear();
  notes_.clear();
  admission_ = {};
}

robotlink::Result<void> SessionOffer::steer(const std::string& robot, bool giveUp) {
  if (!isOffered())
    return robotlink::failure("steering.alone",
                              "no other client can steer " + robot + ", since this session is not offered",
                              {}, {robot});
  server_->steer(robot, giveUp);
  return {};
}

bool SessionOffer::isOfferedAt(const std::string& address, std::uint16_t port) const {
  return isOffered() && listener_->address().port == port && std::ranges::count(localAddresses_, address) > 0;
}

void SessionOffer::announce() {
  announced_ = clock_.now();
  announcer_->update(robotsToAnnounce(session_));
}

void SessionOffer::tick() {
  for (std::string& sentence : reported_->drain()) reports_.push_back(std::move(sentence));
  while (reports_.size() > kMaxReports) reports_.pop_front();
  if (!isOffered()) return;
  server_->tick();
  if (clock_.now() - announced_ >= kMeasureEvery) announce();
  const robotlink::Duration passed = clock_.now() - measured_;
  if (passed >= kMeasureEvery || server_->server()->clientCount() != clients_.size()) measure(passed);
}

void SessionOffer::measure(robotlink::Duration passed) {
  measured_ = clock_.now();
  std::map<std::uint64_t, std::uint64_t> sent;
  clients_.clear();
  for (const auto& state : server_->server()->clients()) {
    const auto before = sent_.find(state.info.id);
    sent[state.info.id] = state.sentBytes;
    const double bytes = before == sent_.end() ? 0 : static_cast<double>(state.sentBytes - before->second);
    const double seconds = robotlink::seconds(passed);
    clients_.push_back({state.info.address, state.info.name, seconds > 0 ? bytes / seconds : 0,
                        state.waitingBytes, state.info.isReadOnly});
  }
  sent_ = std::move(sent);
}

}  // namespace app
