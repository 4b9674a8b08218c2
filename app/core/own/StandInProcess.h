// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/process/Process.h"

namespace app {

/// Stands in for a process that runs elsewhere, for readers of its name, its senders and its frames. Its
/// frames do what the owner wants.
class StandInProcess final : public robotlink::Process {
 public:
  using Process::Process;

  void addSender(const std::string& package) {
    ends_.push_back(std::make_unique<robotlink::AnySender>(*this, package, robotlink::Blocking::kNo));
  }
  void setFrame(std::function<void()> frame) { frame_ = std::move(frame); }

 protected:
  void execute() override {
    if (frame_) frame_();
  }

 private:
  std::vector<std::unique_ptr<robotlink::AnySender>> ends_;
  std::function<void()> frame_;
};

}  // namespace app
