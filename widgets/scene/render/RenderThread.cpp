// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/render/RenderThread.h"

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <utility>

namespace widgets {
namespace {

using namespace std::chrono_literals;

constexpr auto kShortestInterval = 33ms;
constexpr double kShareOfCore = 0.4, kShareInHurry = 0.9;

/// On a busy machine a picture yields to the simulation that it shows: this thread has this niceness, which
/// on Linux is a thread's own.
constexpr int kNiceness = 5;

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
    : finished_(finished),
      worker_([this](Request frame, const std::stop_token&) { draw(std::move(frame)); },
              {.news = std::move(finished),
               .begin = [this, make = std::move(makeRenderer)] { create(make); },
               // Its context belongs to the thread.
               .end = [this] { renderer_.reset(); },
               .due = [this](const Request& frame) { return due(frame); }}) {}

std::string RenderThread::error() const {
  const std::lock_guard lock(mutex_);
  return error_;
}

std::string RenderThread::device() const {
  const std::lock_guard lock(mutex_);
  return device_;
}

void RenderThread::create(const MakeRenderer& makeRenderer) {
  pthread_setname_np(pthread_self(), "scene-renderer");
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNiceness);
  auto renderer = makeRenderer();
  {
    const std::lock_guard lock(mutex_);
    if (renderer) {
      device_ = renderer->device();
    } else {
      error_ = renderer.error().text;
    }
  }
  if (!renderer) return finished_();
  renderer_.emplace(*std::move(renderer));
}

RenderThread::Drawing::Clock::time_point RenderThread::due(const Request& frame) const {
  return start_ + std::chrono::duration_cast<Drawing::Clock::duration>(interval(cost_, frame->hurry));
}

void RenderThread::draw(Request frame) {
  if (!renderer_) return;
  start_ = Drawing::Clock::now();
  const auto before = threadTime();
  Picture picture{renderer_->render(*frame), frame};
  cost_ = threadTime() - before;
  worker_.publish(std::move(picture));
}

}  // namespace widgets
