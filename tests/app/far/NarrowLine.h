// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "tests/app/far/NetworkLine.h"
#include "tests/robotlink/foxglove/Relay.h"

namespace app::test {

/// Machines with networks of their own; between the desk and the robot's computer, 1 Mbit/s and 200 ms of
/// round trip.
class NarrowLine final : public FarLine {
 public:
  explicit NarrowLine(std::unique_ptr<NetworkLine> networks) : networks_(std::move(networks)) {}

  Machine computer() const override { return networks_->computer(); }
  Machine wheels() const override { return networks_->wheels(); }
  std::vector<std::string> listenOptions() const override { return networks_->listenOptions(); }
  std::string reached(const std::string& url) override {
    const std::size_t colon = url.rfind(':');
    const int port = std::stoi(url.substr(colon + 1));
    relay_ = std::make_unique<Relay>(static_cast<std::uint16_t>(port),
                                     Relay::Line{std::chrono::milliseconds(100), 125'000},
                                     networks_->computer().address);
    direct_ = url;
    return "wss://127.0.0.1:" + std::to_string(relay_->port());
  }
  void unplug(bool unplugged) override {
    relay_->set(unplugged ? Relay::State::kSilent : Relay::State::kOpen);
  }

  /// Where a program on the robot's computer reaches it.
  const std::string& direct() const { return direct_; }
  /// See NetworkLine.
  NetworkNamespace::Stay atComputer() const { return networks_->atComputer(); }
  /// What both ways together have carried, in bytes.
  std::size_t carried() const { return relay_->carriedBytes(); }

 private:
  using Relay = robotlink::websocket::test::Relay;

  const std::unique_ptr<NetworkLine> networks_;
  std::unique_ptr<Relay> relay_;
  std::string direct_;
};

}  // namespace app::test
