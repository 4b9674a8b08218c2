// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/session/HistoryArchive.h"

namespace widgets::test {

/// Says that it has all that was added, and can read nothing.
class MadeUpArchive final : public robotlink::HistoryArchive {
 public:
  void add(std::vector<robotlink::StreamMessage> messages, robotlink::Stretch held) override {
    if (!all_) all_ = {messages.front().time, held.to};
    all_->to = held.to;
  }
  void forgetAfter(robotlink::Instant) override { clear(); }
  void clear() override { all_.reset(); }
  void request(robotlink::Instant) override {}
  std::optional<Part> take() override { return std::nullopt; }
  void setLimit(std::uint64_t) override {}
  std::uint64_t limit() const override { return 0; }
  std::optional<robotlink::Stretch> stretch() const override { return all_; }
  std::vector<robotlink::Stretch> holes() const override { return {}; }
  bool hasRoom() const override { return true; }
  bool isLosing() const override { return false; }
  std::uint64_t bytes() const override { return 0; }
  std::map<std::string, std::uint64_t> shares() const override { return {}; }
  std::optional<robotlink::Error> takeProblem() override { return std::nullopt; }

 private:
  std::optional<robotlink::Stretch> all_;
};

}  // namespace widgets::test
