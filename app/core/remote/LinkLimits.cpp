// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/LinkLimits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "robotlink/foxglove/session/remote/SessionClient.h"

namespace app {
namespace {

using Images = LinkLimits::Images;

constexpr std::array<std::pair<Images, const char*>, 4> kImageNames{
    {{Images::kAutomatic, "auto"}, {Images::kRaw, "raw"}, {Images::kJpeg, "jpeg"}, {Images::kPng, "png"}}};

std::string bytesKey(const std::string& url) {
  return url + "/bytes-per-second";
}
std::string imagesKey(const std::string& url) {
  return url + "/images";
}
std::string rateKey(const std::string& url) {
  return url + "/images-per-second";
}

std::string imagesText(Images images) {
  switch (images) {
    case Images::kJpeg:
      return ", images as JPEG";
    case Images::kPng:
      return ", images as PNG";
    case Images::kRaw:
      return ", images raw";
    default:
      return {};
  }
}

}  // namespace

const char* nameOf(Images images) {
  return std::ranges::find(kImageNames, images, [](const auto& one) { return one.first; })->second;
}

std::optional<Images> imagesNamed(const std::string& name) {
  const auto* found = std::ranges::find(kImageNames, name, [](const auto& one) { return one.second; });
  return found == kImageNames.end() ? std::nullopt : std::optional(found->first);
}

std::string inWords(const LinkLimits& limits) {
  std::string text;
  if (limits.bytesPerSecond >= 1e6) text = fmt::format(", at most {:.1f} MB/s", 1e-6 * limits.bytesPerSecond);
  if (limits.bytesPerSecond > 0 && text.empty())
    text = fmt::format(", at most {:.0f} kB/s", 1e-3 * limits.bytesPerSecond);
  text += imagesText(limits.images);
  if (limits.imagesPerSecond > 0) text += fmt::format(", {:.3g} images a second", limits.imagesPerSecond);
  return text;
}

void apply(const LinkLimits& limits, robotlink::websocket::SessionClient& client) {
  client.setImages(limits.images);
  client.setImageRate(limits.imagesPerSecond);
  client.setBudget(limits.bytesPerSecond);
}

LinkLimitsMemory::LinkLimitsMemory(std::filesystem::path file) : settings_(std::move(file)) {
  // A file that cannot be read is put aside, and nothing is limited.
  static_cast<void>(settings_.load());
}

LinkLimits LinkLimitsMemory::limits(const std::string& url) const {
  const std::lock_guard lock(mutex_);
  return {std::max(settings_.number(bytesKey(url), 0), 0.0),
          imagesNamed(settings_.text(imagesKey(url), "")).value_or(Images::kAutomatic),
          std::max(settings_.number(rateKey(url), 0), 0.0)};
}

void LinkLimitsMemory::choose(const std::string& url, const LinkLimits& limits) {
  if (this->limits(url) == limits) return;
  const std::lock_guard lock(mutex_);
  ++version_;
  if (limits == LinkLimits()) return settings_.remove(url);
  settings_.set(bytesKey(url), limits.bytesPerSecond);
  settings_.set(imagesKey(url), nameOf(limits.images));
  settings_.set(rateKey(url), limits.imagesPerSecond);
}

std::uint64_t LinkLimitsMemory::version() const {
  const std::lock_guard lock(mutex_);
  return version_;
}

robotlink::Result<void> LinkLimitsMemory::save() {
  const std::lock_guard lock(mutex_);
  if (std::exchange(saved_, version_) == version_) return {};
  return settings_.save();
}

}  // namespace app
