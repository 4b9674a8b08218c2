// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "tests/app/far/FarLine.h"
#include "tests/robotlink/foxglove/Relay.h"

namespace app::test {

/// All on this machine, with a relay between; for systems that do not let tests make networks.
class RelayLine final : public FarLine {
 public:
  Machine computer() const override { return {}; }
  Machine wheels() const override { return {}; }
  std::vector<std::string> listenOptions() const override { return {"--listen", "127.0.0.1:0", "--secure"}; }
  std::string reached(const std::string& url) override {
    const std::size_t colon = url.rfind(':');
    const int port = std::stoi(url.substr(colon + 1));
    relay_ = std::make_unique<Relay>(static_cast<std::uint16_t>(port), Relay::Line{});
    return url.substr(0, colon + 1) + std::to_string(relay_->port());
  }
  void unplug(bool unplugged) override {
    relay_->set(unplugged ? Relay::State::kSilent : Relay::State::kOpen);
  }

 private:
  using Relay = robotlink::websocket::test::Relay;

  std::unique_ptr<Relay> relay_;
};

}  // namespace app::test
