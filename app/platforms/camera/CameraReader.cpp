// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/camera/CameraReader.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

namespace app {
namespace {

constexpr int kWaitMs = 100;
constexpr std::chrono::seconds kRefreshEvery{1};
constexpr std::chrono::seconds kRetryEvery{1};
/// A camera that gives no image for this long is reopened.
constexpr int kMaxSilentWaits = 50;

}  // namespace

CameraReader::CameraReader(CameraAddress address, const robotlink::Clock& clock, VideoCalls& calls)
    : address_(std::move(address)),
      clock_(clock),
      calls_(calls),
      state_("opening " + address_.device),
      thread_({.due = [this] { return due(); }, .step = [this] { step(); }}) {}

std::optional<CameraReader::Shot> CameraReader::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(newest_, std::nullopt);
}

std::string CameraReader::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

std::string CameraReader::problem() const {
  const std::lock_guard lock(mutex_);
  return isProblem_ ? state_ : std::string();
}

CameraReader::Counts CameraReader::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

std::vector<CameraDevice::Control> CameraReader::controls() const {
  const std::lock_guard lock(mutex_);
  return controls_;
}

void CameraReader::set(const std::string& control, std::int32_t value) {
  const std::lock_guard lock(mutex_);
  chosen_[control] = waiting_[control] = value;
}

std::vector<std::string> CameraReader::takeRefusals() {
  const std::lock_guard lock(mutex_);
  return std::exchange(refusals_, {});
}

void CameraReader::followControls(CameraDevice& device) {
  std::map<std::string, std::int32_t> wanted;
  {
    const std::lock_guard lock(mutex_);
    wanted = std::exchange(waiting_, {});
  }
  std::map<std::string, std::string> refusals;
  for (const auto& [control, value] : wanted) {
    if (const auto done = device.set(control, value); !done) refusals[control] = done.error().text;
  }
  const robotlink::Instant now = clock_.now();
  if (wanted.empty() && now - refreshedAt_ < kRefreshEvery) return;
  refreshedAt_ = now;
  device.refresh();
  const std::lock_guard lock(mutex_);
  controls_ = device.controls();
  for (const auto& [control, why] : refusals) {
    chosen_.erase(control);
    refusals_.push_back(why);
  }
}

void CameraReader::openNow() {
  {
    const std::lock_guard lock(mutex_);
    now_ = true;
  }
  thread_.wake();
}

void CameraReader::setState(std::string state) {
  const std::lock_guard lock(mutex_);
  state_ = std::move(state);
  isProblem_ = false;
}

void CameraReader::setProblem(const std::string& why) {
  const std::lock_guard lock(mutex_);
  state_ = why + "; trying again";
  isProblem_ = true;
}

robotlink::PacedThread::Clock::time_point CameraReader::due() {
  const std::lock_guard lock(mutex_);
  // Before the first attempt there is no pause to end.
  constexpr robotlink::PacedThread::Clock::time_point kAtOnce;
  if (retryAt_ != kAtOnce && std::exchange(now_, false)) retryAt_ = kAtOnce;
  return retryAt_;
}

void CameraReader::step() {
  if (auto device = CameraDevice::open(address_, calls_)) {
    use(**device);
  } else {
    setProblem(device.error().text);
  }
  retryAt_ = robotlink::PacedThread::Clock::now() + kRetryEvery;
}

void CameraReader::use(CameraDevice& device) {
  const CameraDevice::Mode& mode = device.mode();
  std::string text =
      fmt::format("{} takes images of {}x{} ({})", device.title(), mode.width, mode.height, mode.format);
  if (mode.rate > 0) text += fmt::format(", {:.3g} a second", mode.rate);
  setState(std::move(text));
  {
    const std::lock_guard lock(mutex_);
    ++counts_.connections;
    waiting_ = chosen_;
    controls_ = device.controls();
  }
  isOpen_ = true;
  const robotlink::Error why = read(device);
  isOpen_ = false;
  if (thread_.isEnding()) return;
  {
    const std::lock_guard lock(mutex_);
    ++counts_.losses;
  }
  setProblem(why.text);
}

robotlink::Error CameraReader::read(CameraDevice& device) {
  int silent = 0;
  while (!thread_.isEnding()) {
    followControls(device);
    auto image = device.next(kWaitMs);
    const robotlink::Instant now = clock_.now();
    if (!image && image.error().id != "camera.damaged") return image.error();
    silent = image && !*image ? silent + 1 : 0;
    if (silent > kMaxSilentWaits)
      return {"camera.silent", address_.device + ": the camera sends no images", {}, {}};
    const std::lock_guard lock(mutex_);
    if (!image) {
      ++counts_.damaged;
    } else if (*image) {
      ++counts_.images;
      if (newest_) ++counts_.replaced;
      newest_ = Shot{std::move(**image), now};
    }
  }
  return {};
}

}  // namespace app
