// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/space/ColorSpaceThread.h"

#include <pthread.h>

#include <algorithm>
#include <utility>

#include "widgets/color/space/ColorSpaceRenderer.h"

namespace widgets {
namespace {

using namespace std::chrono_literals;

constexpr auto kShortestPictureInterval = 30ms;

}  // namespace

ColorSpaceThread::ColorSpaceThread(std::function<void()> finished)
    : finished_(std::move(finished)), thread_([this] { run(); }) {}

ColorSpaceThread::~ColorSpaceThread() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void ColorSpaceThread::request(std::shared_ptr<const ColorSpaceRequest> request) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = std::move(request);
  }
  changed_.notify_all();
}

std::optional<ColorSpacePicture> ColorSpaceThread::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(picture_, std::nullopt);
}

std::shared_ptr<const ColorSpaceRequest> ColorSpaceThread::next(Clock::time_point due) {
  std::unique_lock lock(mutex_);
  while (!ending_) {
    if (!wanted_) {
      changed_.wait(lock);
      continue;
    }
    if (Clock::now() >= due) return std::exchange(wanted_, nullptr);
    changed_.wait_until(lock, due);
  }
  return nullptr;
}

void ColorSpaceThread::run() {
  pthread_setname_np(pthread_self(), "color-space");
  ColorSpaceRenderer renderer;
  Clock::time_point due;
  while (auto request = next(due)) {
    const auto start = Clock::now();
    ColorSpacePicture picture = renderer.render(std::move(request));
    due = start + std::max<Clock::duration>(kShortestPictureInterval, 2 * (Clock::now() - start));
    {
      const std::lock_guard lock(mutex_);
      picture_ = std::move(picture);
    }
    finished_();
  }
}

}  // namespace widgets
