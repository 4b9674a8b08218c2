// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/session/HistoryArchive.h"

namespace widgets::test {

/// Says that it has all that was added, of which it can read nothing, or all.
class MadeUpArchive final : public robotlink::HistoryArchive {
 public:
  explicit MadeUpArchive(bool canRead = false) : canRead_(canRead) {}

  void add(std::vector<robotlink::StreamMessage> messages, robotlink::Stretch held) override {
    if (!all_) all_ = {messages.front().time, held.to};
    all_->to = held.to;
    if (!canRead_) return;
    std::map<std::string, robotlink::Stretch> times;
    for (const auto& message : messages) {
      const auto at = times.try_emplace(message.path, robotlink::Stretch{message.time, message.time}).first;
      at->second.to = message.time;
    }
    pieces_.push_back({{std::max(held.from, all_->from), held.to},
                       std::make_shared<const std::map<std::string, robotlink::Stretch>>(std::move(times)),
                       {},
                       std::make_shared<const std::vector<robotlink::StreamMessage>>(std::move(messages))});
  }
  void forgetAfter(robotlink::Instant) override { clear(); }
  void clear() override {
    all_.reset();
    pieces_.clear();
  }
  void request(robotlink::Instant) override {}
  std::optional<Part> take() override { return std::nullopt; }
  std::vector<Piece> pieces() const override { return pieces_; }
  void setLimit(std::uint64_t) override {}
  std::uint64_t limit() const override { return 0; }
  std::optional<robotlink::Stretch> stretch() const override { return all_; }
  std::vector<robotlink::Stretch> holes() const override { return lost; }
  bool hasRoom() const override { return true; }
  bool isLosing() const override { return false; }
  std::uint64_t bytes() const override { return 0; }
  std::map<std::string, std::uint64_t> shares() const override { return {}; }
  std::optional<robotlink::Error> takeProblem() override { return std::nullopt; }

  /// What it says was lost.
  std::vector<robotlink::Stretch> lost;

 private:
  const bool canRead_;
  std::optional<robotlink::Stretch> all_;
  std::vector<Piece> pieces_;
};

}  // namespace widgets::test
