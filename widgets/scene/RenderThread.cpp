// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/RenderThread.h"

#include <algorithm>
#include <utility>

namespace widgets {
namespace {

using namespace std::chrono_literals;

constexpr auto kShortestInterval = 33ms;
constexpr double kShareOfCore = 0.4, kShareInHurry = 0.9;

/// How long after the start of one picture the next may begin.
std::chrono::duration<double> interval(std::chrono::duration<double> cost, bool hurry) {
  return std::max<std::chrono::duration<double>>(kShortestInterval,
                                                 cost / (hurry ? kShareInHurry : kShareOfCore));
}

}  // namespace

RenderThread::RenderThread(MakeRenderer makeRenderer, std::function<void()> finished)
    : makeRenderer_(std::move(makeRenderer)), finished_(std::move(finished)), thread_([this] { run(); }) {}

RenderThread::~RenderThread() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void RenderThread::request(std::shared_ptr<const SceneFrame> frame) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = std::move(frame);
  }
  changed_.notify_all();
}

std::optional<RenderThread::Picture> RenderThread::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(picture_, std::nullopt);
}

std::string RenderThread::error() const {
  const std::lock_guard lock(mutex_);
  return error_;
}

std::string RenderThread::device() const {
  const std::lock_guard lock(mutex_);
  return device_;
}

std::shared_ptr<const SceneFrame> RenderThread::next(Clock::time_point start, Clock::duration cost) {
  std::unique_lock lock(mutex_);
  while (!ending_) {
    if (!wanted_) {
      changed_.wait(lock);
      continue;
    }
    const auto due = start + std::chrono::duration_cast<Clock::duration>(interval(cost, wanted_->hurry));
    if (Clock::now() >= due) return std::exchange(wanted_, nullptr);
    changed_.wait_until(lock, due);
  }
  return nullptr;
}

void RenderThread::run() {
  auto renderer = makeRenderer_();
  {
    const std::lock_guard lock(mutex_);
    if (renderer) {
      device_ = renderer->device();
    } else {
      error_ = renderer.error().text;
    }
  }
  if (!renderer) return finished_();
  // Mesa's software draws with several threads: count a picture's time for each of up to two.
  const auto cores = renderer->software() ? std::clamp(std::thread::hardware_concurrency(), 1U, 2U) : 1U;
  Clock::time_point start;
  Clock::duration cost{};
  while (auto frame = next(start, cost)) {
    start = Clock::now();
    Picture picture{renderer->render(*frame), frame};
    cost = (Clock::now() - start) * cores;
    {
      const std::lock_guard lock(mutex_);
      picture_ = std::move(picture);
    }
    finished_();
  }
}

}  // namespace widgets
