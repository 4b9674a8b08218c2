// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/RenderThread.h"

#include <pthread.h>

#include <algorithm>
#include <ctime>
#include <utility>

namespace widgets {
namespace {

using namespace std::chrono_literals;

constexpr auto kShortestInterval = 33ms;
constexpr double kShareOfCore = 0.4, kShareInHurry = 0.9;

/// Minimum time from the start of one picture to the start of the next.
std::chrono::duration<double> interval(std::chrono::duration<double> cost, bool hurry) {
  return std::max<std::chrono::duration<double>>(kShortestInterval,
                                                 cost / (hurry ? kShareInHurry : kShareOfCore));
}

/// Processor time of this thread. The software renderer draws in this very thread (see EglContext.cpp).
std::chrono::duration<double> threadTime() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::duration<double>(static_cast<double>(time.tv_sec) +
                                       1e-9 * static_cast<double>(time.tv_nsec));
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

std::shared_ptr<const SceneFrame> RenderThread::next(Clock::time_point start,
                                                     std::chrono::duration<double> cost) {
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
  pthread_setname_np(pthread_self(), "scene-renderer");
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
  Clock::time_point start;
  std::chrono::duration<double> cost{};
  while (auto frame = next(start, cost)) {
    start = Clock::now();
    const auto before = threadTime();
    Picture picture{renderer->render(*frame), frame};
    cost = threadTime() - before;
    {
      const std::lock_guard lock(mutex_);
      picture_ = std::move(picture);
    }
    finished_();
  }
}

}  // namespace widgets
