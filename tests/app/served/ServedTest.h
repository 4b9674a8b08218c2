// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <map>
#include <memory>
#include <sstream>
#include <string>

#include "app/core/ServedPlatform.h"
#include "logplayer/record/Recorder.h"
#include "tests/robotlink/foxglove/RawClient.h"

namespace app::test {

/// A stream that tells the address at which clients connect as soon as it is printed; texts may come before.
class AddressLine : public std::stringbuf {
 public:
  std::string wait() { return line_.get_future().get(); }

 protected:
  int sync() override {
    const std::string all = str();
    const std::size_t place = all.find("ws://");
    const std::size_t end = place == std::string::npos ? place : all.find('\n', place);
    if (!isTold_ && end != std::string::npos) {
      isTold_ = true;
      line_.set_value(all.substr(place, end - place));
    }
    return 0;
  }

 private:
  std::promise<std::string> line_;
  bool isTold_ = false;
};

/// A platform that is served at a port of its own, and a client of it.
class ServedTest : public testing::Test {
 protected:
  explicit ServedTest(PlatformOpening opening)
      : served_(std::async(std::launch::async, [this, opening = std::move(opening)] {
          return serve(
              opening, {.address = {"127.0.0.1", 0}}, recorder_, [this] { return interrupted_.load(); },
              out_);
        })) {
    const std::string line = printed_.wait();
    client_ = std::make_unique<robotlink::websocket::test::RawClient>(
        static_cast<std::uint16_t>(std::stoi(line.substr(line.rfind(':') + 1))));
  }
  ~ServedTest() override {
    interrupted_ = true;
    EXPECT_TRUE(served_.get().empty());
  }
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
  /// The next message of a type.
  template <typename Message>
  Message expect() {
    while (true) {
      const auto message = hear();
      if (const auto* found = std::get_if<Message>(&message)) return *found;
    }
  }
  /// The next message of a type for which a condition holds.
  template <typename Message, typename Condition>
  Message expect(Condition condition) {
    while (true) {
      const Message message = expect<Message>();
      if (condition(message)) return message;
    }
  }

  AddressLine printed_;
  std::ostream out_{&printed_};
  logplayer::Recorder recorder_{{}};
  std::atomic<bool> interrupted_{false};
  std::future<robotlink::Errors> served_;
  std::unique_ptr<robotlink::websocket::test::RawClient> client_;
  std::map<std::string, std::uint64_t> channels_;
  std::map<std::string, std::uint32_t> services_;
};

}  // namespace app::test
