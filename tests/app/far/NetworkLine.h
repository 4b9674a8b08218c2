// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "tests/app/far/FarLine.h"
#include "tests/app/far/NetworkCable.h"

namespace app::test {

/// Each machine is a network of its own, connected by cables. The thread that makes it is at the desk while
/// it exists.
class NetworkLine final : public FarLine {
 public:
  /// Fails, with the reason, where the system does not permit it.
  static robotlink::Result<std::unique_ptr<NetworkLine>> make() {
    auto line = std::unique_ptr<NetworkLine>(new NetworkLine);
    for (auto* network : {&line->desk_, &line->computer_, &line->wheels_}) {
      auto made = NetworkNamespace::make();
      if (!made) return tl::unexpected(made.error());
      *network = std::move(*made);
    }
    auto far =
        NetworkCable::make({*line->desk_, "10.77.1.1", "toRobot"}, {*line->computer_, kComputer, "toDesk"});
    if (!far) return tl::unexpected(far.error());
    line->far_ = std::move(*far);
    auto near = NetworkCable::make({*line->computer_, "10.77.2.1", "toWheels"},
                                   {*line->wheels_, kWheels, "toProgram"});
    if (!near) return tl::unexpected(near.error());
    line->near_ = std::move(*near);
    line->stay_.emplace(*line->desk_);
    return line;
  }

  Machine computer() const override { return {kComputer, computer_->descriptor()}; }
  Machine wheels() const override { return {kWheels, wheels_->descriptor()}; }
  std::vector<std::string> listenOptions() const override {
    return {"--listen", std::string(kComputer) + ":0"};
  }
  std::string reached(const std::string& url) override { return url; }
  void unplug(bool unplugged) override { far_->unplug(unplugged); }
  /// While it exists, this thread and all that it starts are at the robot's computer.
  NetworkNamespace::Stay atComputer() const { return NetworkNamespace::Stay(*computer_); }

 private:
  static constexpr char kComputer[] = "10.77.1.2", kWheels[] = "10.77.2.2";

  NetworkLine() = default;

  std::unique_ptr<NetworkNamespace> desk_, computer_, wheels_;
  std::unique_ptr<NetworkCable> far_, near_;
  std::optional<NetworkNamespace::Stay> stay_;
};

}  // namespace app::test
