// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/space/ColorSpaceThread.h"

#include <pthread.h>

#include <algorithm>
#include <utility>

namespace widgets {
namespace {

using namespace std::chrono_literals;

constexpr auto kShortestPictureInterval = 30ms;

}  // namespace

ColorSpaceThread::ColorSpaceThread(std::function<void()> finished)
    : worker_([this](Request request, const std::stop_token&) { draw(std::move(request)); },
              {.news = std::move(finished),
               .begin = [] { pthread_setname_np(pthread_self(), "color-space"); },
               .due = [this](const Request&) { return due_; }}) {}

void ColorSpaceThread::draw(Request request) {
  const auto start = Drawing::Clock::now();
  ColorSpacePicture picture = renderer_.render(std::move(request));
  due_ = start +
         std::max<Drawing::Clock::duration>(kShortestPictureInterval, 2 * (Drawing::Clock::now() - start));
  worker_.publish(std::move(picture));
}

}  // namespace widgets
