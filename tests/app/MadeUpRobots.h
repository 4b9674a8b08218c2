// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/core/remote/RobotSearch.h"

namespace app::test {

/// Robots that a test says are announced on the network. It must outlive the searches that listen to it.
class MadeUpRobots {
 public:
  using Robots = std::vector<robotlink::dds::AnnouncedRobots>;

  void set(Robots robots) {
    const std::lock_guard lock(mutex_);
    robots_ = std::move(robots);
  }
  void setProblem(const std::string& problem) {
    const std::lock_guard lock(mutex_);
    problem_ = problem;
  }
  /// How many searches listen.
  int listeners() const {
    const std::lock_guard lock(mutex_);
    return listeners_;
  }
  RobotSearch::Open source() {
    return [this] { return std::make_unique<Source>(*this); };
  }

 private:
  class Source final : public RobotSearch::Source {
   public:
    explicit Source(MadeUpRobots& from) : from_(from) { count(1); }
    ~Source() override { count(-1); }
    Robots robots() override {
      const std::lock_guard lock(from_.mutex_);
      return from_.robots_;
    }
    std::string problem() const override {
      const std::lock_guard lock(from_.mutex_);
      return from_.problem_;
    }

   private:
    void count(int by) {
      const std::lock_guard lock(from_.mutex_);
      from_.listeners_ += by;
    }

    MadeUpRobots& from_;
  };

  /// Protects all members.
  mutable std::mutex mutex_;
  Robots robots_;
  std::string problem_;
  int listeners_ = 0;
};

}  // namespace app::test
