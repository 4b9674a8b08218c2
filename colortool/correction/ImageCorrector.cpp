// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/correction/ImageCorrector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace colortool {
namespace {

using robotlink::PixelFormat;

// Gains have 11 fractional bits and offsets 5: both fit into 16 bits within the limits of ColorCorrection.
constexpr int kGainBits = 11, kOffsetBits = 5;
constexpr int kHalf = 1 << (kGainBits - 1);
/// Number of bytes that are corrected at a time: the compiler vectorizes loops of constant length.
constexpr std::size_t kStride = 16;

std::int16_t fixed(double value, int bits) {
  return static_cast<std::int16_t>(std::lround(value * (1 << bits)));
}

/// `from` and `to` may be equal.
void correctStride(const std::uint8_t* from, const std::int16_t* gains, const std::int16_t* offsets,
                   std::uint8_t* to) {
  std::array<std::uint8_t, kStride> corrected;
  for (std::size_t i = 0; i < kStride; ++i) {
    const int value =
        (from[i] * gains[i] + offsets[i] * (1 << (kGainBits - kOffsetBits)) + kHalf) >> kGainBits;
    corrected[i] = static_cast<std::uint8_t>(std::clamp(value, 0, 255));
  }
  std::memcpy(to, corrected.data(), kStride);
}

void correctBytes(const std::uint8_t* from, const std::vector<std::int16_t>& gains,
                  const std::vector<std::int16_t>& offsets, std::uint8_t* to) {
  const std::size_t count = gains.size(), whole = count - count % kStride;
  for (std::size_t i = 0; i < whole; i += kStride) correctStride(from + i, &gains[i], &offsets[i], to + i);
  if (whole == count) return;
  std::array<std::uint8_t, kStride> bytes{};
  std::array<std::int16_t, kStride> lastGains{}, lastOffsets{};
  std::copy(from + whole, from + count, bytes.begin());
  std::copy(gains.begin() + static_cast<std::ptrdiff_t>(whole), gains.end(), lastGains.begin());
  std::copy(offsets.begin() + static_cast<std::ptrdiff_t>(whole), offsets.end(), lastOffsets.begin());
  correctStride(bytes.data(), lastGains.data(), lastOffsets.data(), bytes.data());
  std::copy_n(bytes.begin(), count - whole, to + whole);
}

std::uint8_t toByte(int value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0, 255));
}

/// robotlink::toRgb() without floating point; differs by at most 1.
robotlink::Rgb quickRgb(const std::uint8_t* color) {
  constexpr int kMiddle = 1 << 15;
  const int y = (color[0] << 16) + kMiddle, cb = color[1] - 128, cr = color[2] - 128;
  return {toByte((y + 91881 * cr) >> 16), toByte((y - 22553 * cb - 46802 * cr) >> 16),
          toByte((y + 116130 * cb) >> 16)};
}

}  // namespace

void ImageCorrector::Row::add(const ChannelLine& line) {
  gains.push_back(fixed(line.gain, kGainBits));
  offsets.push_back(fixed(line.offset, kOffsetBits));
}

ImageCorrector::Row ImageCorrector::lumaRow(int y) const {
  Row row;
  for (int x = 0; x < layout_->width; ++x)
    row.add(correction_.lumaAt(squaredImageRadius(x, y, layout_->width, layout_->height)));
  return row;
}

ImageCorrector::Row ImageCorrector::chromaRow(int y) const {
  Row row;
  for (int x = 0; x + 1 < layout_->width; x += 2) {
    const double radius = squaredImageRadius(x + 0.5, y + 0.5, layout_->width, layout_->height);
    row.add(correction_.blueAt(radius));
    row.add(correction_.redAt(radius));
  }
  return row;
}

ImageCorrector::Row ImageCorrector::pixelRow(int y) const {
  const bool pairs = bytesPerPixel(layout_->format) == 2;
  Row row;
  for (int x = 0; x < layout_->width; ++x) {
    const ChannelLine luma = correction_.lumaAt(squaredImageRadius(x, y, layout_->width, layout_->height));
    const double chromaX = pairs ? (x & ~1) + 0.5 : x;
    const double radius = squaredImageRadius(chromaX, y, layout_->width, layout_->height);
    const ChannelLine blue = correction_.blueAt(radius), red = correction_.redAt(radius);
    if (!pairs) {  // kRgb8 and kBgr8 are converted to Y Cb Cr before
      row.add(luma);
      row.add(blue);
      row.add(red);
      continue;
    }
    const ChannelLine& chroma = x % 2 == 0 ? blue : red;
    row.add(layout_->format == PixelFormat::kYuyv ? luma : chroma);
    row.add(layout_->format == PixelFormat::kYuyv ? chroma : luma);
  }
  return row;
}

ImageCorrector::Row ImageCorrector::rowOf(int y) const {
  return bytesPerPixel(layout_->format) == 1 ? lumaRow(y) : pixelRow(y);
}

void ImageCorrector::prepare(const Layout& layout) {
  if (layout_ == layout) return;
  layout_ = layout;
  rows_.clear();
  chromaRows_.clear();
  for (int y = 0; y < (layout.height + 1) / 2; ++y) rows_.push_back(rowOf(y));
  if (layout.format != PixelFormat::kNv12) return;
  for (int y = 0; y + 1 < layout.height; y += 2) chromaRows_.push_back(chromaRow(y));
}

void ImageCorrector::correct(const robotlink::ImageView& from, robotlink::Image& to) {
  to.width = from.width;
  to.height = from.height;
  to.format = from.format;
  to.data.resize(static_cast<std::size_t>(to.step()) *
                 static_cast<std::size_t>(rowsOf(from.format, from.height)));
  if (from.empty()) return;
  if (correction_.none()) {
    const auto bytes = static_cast<std::size_t>(to.step());
    for (int y = 0; y < rowsOf(from.format, from.height); ++y) std::memcpy(to.row(y), from.row(y), bytes);
    return;
  }
  prepare({from.width, from.height, from.format});
  if (bytesPerPixel(from.format) == 3) return correctRgb(from, to);
  for (int y = 0; y < from.height; ++y) {
    const Row& row = rows_[static_cast<std::size_t>(std::min(y, from.height - 1 - y))];
    correctBytes(from.row(y), row.gains, row.offsets, to.row(y));
  }
  for (std::size_t i = 0; i < chromaRows_.size(); ++i) {
    const int y = from.height + static_cast<int>(i);
    correctBytes(from.row(y), chromaRows_[i].gains, chromaRows_[i].offsets, to.row(y));
  }
}

void ImageCorrector::correctRgb(const robotlink::ImageView& from, robotlink::Image& to) {
  const std::ptrdiff_t red = from.format == PixelFormat::kRgb8 ? 0 : 2, blue = 2 - red;
  scratch_.resize(static_cast<std::size_t>(to.step()));
  for (int y = 0; y < from.height; ++y) {
    const std::uint8_t* in = from.row(y);
    for (std::uint8_t *color = scratch_.data(), *end = color + scratch_.size(); color < end;
         color += 3, in += 3) {
      const robotlink::YCbCr pixel = robotlink::toYCbCr({in[red], in[1], in[blue]});
      color[0] = pixel.y;
      color[1] = pixel.cb;
      color[2] = pixel.cr;
    }
    const Row& row = rows_[static_cast<std::size_t>(std::min(y, from.height - 1 - y))];
    correctBytes(scratch_.data(), row.gains, row.offsets, scratch_.data());
    std::uint8_t* out = to.row(y);
    for (std::size_t i = 0; i < scratch_.size(); i += 3, out += 3) {
      const robotlink::Rgb pixel = quickRgb(&scratch_[i]);
      out[red] = pixel.r;
      out[1] = pixel.g;
      out[blue] = pixel.b;
    }
  }
}

}  // namespace colortool
