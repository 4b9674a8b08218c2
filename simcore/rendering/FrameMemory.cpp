// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/FrameMemory.h"

#include <algorithm>
#include <cmath>

namespace simcore::rendering {
namespace {

constexpr int kStripPixels = 8192;

}  // namespace

FrameMemory::FrameMemory(int vertices, int meshTriangles, int allTriangles, std::size_t lamps)
    : records_(static_cast<std::size_t>(allTriangles) + 1),
      positions_(static_cast<std::size_t>(vertices) * 4),
      candidates_(static_cast<std::size_t>(meshTriangles) + 8),
      ranges_(static_cast<std::size_t>(vertices)),
      boxes_(candidates_.size()),
      unsure_(lamps) {
  buffer_.records = records_.data();
  buffer_.positions = positions_.data();
  buffer_.ranges = ranges_.data();
  buffer_.candidates = candidates_.data();
  buffer_.boxes = boxes_.data();
}

VisibilityBuffer& FrameMemory::begin(const CameraModel& camera, const float (&background)[3]) {
  if (camera.width != buffer_.width || camera.height != buffer_.height) resize(camera);
  std::fill(inverseDepths_.begin(), inverseDepths_.end(), 0.0F);
  std::fill(triangles_.begin(), triangles_.end(), 0);
  buffer_.focalX = static_cast<float>(camera.width / 2.0 / std::tan(camera.horizontalAngle / 2));
  buffer_.focalY = static_cast<float>(camera.height / 2.0 / std::tan(camera.verticalAngle / 2));
  for (std::size_t x = 0; x < columns_.size(); ++x) {
    columns_[x] = (static_cast<float>(camera.width) / 2 - 0.5F - static_cast<float>(x)) / buffer_.focalX;
  }
  for (std::size_t y = 0; y < rows_.size(); ++y) {
    rows_[y] = (static_cast<float>(camera.height) / 2 - 0.5F - static_cast<float>(y)) / buffer_.focalY;
  }
  buffer_.recordCount = 1;
  records_[0] = {};
  std::copy(std::begin(background), std::end(background), records_[0].color);
  return buffer_;
}

void FrameMemory::resize(const CameraModel& camera) {
  buffer_.width = camera.width;
  buffer_.height = camera.height;
  buffer_.stride = (camera.width + 7) / 8 * 8 + 8;
  const auto stride = static_cast<std::size_t>(buffer_.stride),
             height = static_cast<std::size_t>(camera.height);
  inverseDepths_.assign(stride * height, 0);
  triangles_.assign(stride * height, 0);
  columns_.assign(stride, 0);
  // Eight at a time are read.
  rows_.assign(height + 8, 0);
  buffer_.inverseDepth = inverseDepths_.data();
  buffer_.triangle = triangles_.data();
  buffer_.column = columns_.data();
  buffer_.row = rows_.data();
  rowsPerStrip_ = std::clamp(kStripPixels / buffer_.stride, 1, std::max(1, camera.height));
  const std::size_t pixels = static_cast<std::size_t>(rowsPerStrip_) * stride;
  light_.assign(pixels, 0);
  for (auto& channel : color_) channel.assign(pixels, 0);
  groups_.resize(pixels / 8 * unsure_.size());
  const std::size_t margin = stride + 8;
  seen_.assign((pixels + 2 * margin) * unsure_.size(), 0);
  unsureFloats_.assign(4 * pixels * unsure_.size(), 0);
  for (std::size_t i = 0; i < unsure_.size(); ++i) {
    UnsurePixels& list = unsure_[i];
    list.groups = groups_.data() + i * (pixels / 8);
    list.seen = seen_.data() + i * (pixels + 2 * margin) + margin;
    list.light = unsureFloats_.data() + 4 * i * pixels;
    for (std::size_t k = 0; k < 3; ++k) list.direction[k] = list.light + (k + 1) * pixels;
  }
}

Strip FrameMemory::strip() {
  Strip strip;
  strip.light = light_.data();
  for (std::size_t k = 0; k < 3; ++k) strip.color[k] = color_[k].data();
  return strip;
}

}  // namespace simcore::rendering
