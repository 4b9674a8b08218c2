// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "tests/app/served/ServedHall.h"
#include "tests/robotlink/foxglove/RawClient.h"

namespace app::test {

/// A platform that is served at a port of its own, and a client of it.
class ServedTest : public testing::Test {
 protected:
  explicit ServedTest(PlatformOpening opening, ServeOptions options = {})
      : hall_(std::move(options), std::move(opening)),
        client_(std::make_unique<robotlink::websocket::test::RawClient>(hall_.port())) {}
  /// Notes what a message advertises, and returns it; its payload is valid until the next one.
  robotlink::websocket::ServerMessage hear() {
    using namespace robotlink::websocket;
    const Frame* frame = client_->receive();
    if (frame == nullptr) throw std::runtime_error("the connection was closed");
    ServerMessage message = decodeServerMessage(frame->kind, frame->bytes).value();
    if (const auto* offered = std::get_if<Advertise>(&message)) {
      for (const auto& channel : offered->channels) channels_[channel.topic] = channel.id;
    } else if (const auto* services = std::get_if<AdvertiseServices>(&message)) {
      for (const auto& service : services->services) services_[service.name] = service.id;
    }
    return message;
  }
  /// The next message of a type for which a condition holds.
  template <typename Message, typename Condition>
  Message expect(Condition condition) {
    // Others may come for ever.
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (std::chrono::steady_clock::now() < deadline) {
      const auto message = hear();
      const auto* found = std::get_if<Message>(&message);
      if (found != nullptr && condition(*found)) return *found;
    }
    throw std::runtime_error("among the messages of 30 s was none that was expected");
  }
  /// The next message of a type.
  template <typename Message>
  Message expect() {
    return expect<Message>([](const Message&) { return true; });
  }

  ServedHall hall_;
  std::unique_ptr<robotlink::websocket::test::RawClient> client_;
  std::map<std::string, std::uint64_t> channels_;
  std::map<std::string, std::uint32_t> services_;
};

}  // namespace app::test
