// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "colortool/ColorCorrection.h"
#include "robotlink/base/Image.h"

namespace colortool {

/// Corrects the colours of whole images to what ColorCorrection::apply() makes of each pixel, to within 1 in
/// a channel. Pixels that share their chroma get what is right in the middle between them. What has to be
/// done at each place is found with the first image of a size and format (some milliseconds) and kept (as
/// many bytes as two such images). One thread at a time.
class ImageCorrector {
 public:
  explicit ImageCorrector(const ColorCorrection& correction) : correction_(correction) {}
  const ColorCorrection& correction() const { return correction_; }

  /// The corrected image has the same size and format; `to` keeps its memory from call to call. Of kRgb8 and
  /// kBgr8, colours that are out of their range are clipped, and others come back to within 3 when they are
  /// made YCbCr again. Of kMono8 the values are Y. About 0.2 ms for 640 x 480 YUYV.
  void correct(const robotlink::ImageView& from, robotlink::Image& to);

 private:
  struct Layout {
    int width = 0, height = 0;
    robotlink::PixelFormat format = robotlink::PixelFormat::kMono8;
    bool operator==(const Layout&) const = default;
  };
  /// What is done to each byte of a row in fixed point; rows are as long as vector code likes them.
  struct Row {
    std::vector<std::int16_t> gains, offsets;
    void add(const ChannelLine& line);
  };
  void prepare(const Layout& layout);
  Row lumaRow(int y) const;
  Row chromaRow(int y) const;
  Row pixelRow(int y) const;
  Row rowOf(int y) const;
  void correctRgb(const robotlink::ImageView& from, robotlink::Image& to);

  ColorCorrection correction_;
  std::optional<Layout> layout_;  ///< of what follows
  std::vector<Row> rows_;         ///< of the upper half; the lower one is its mirror image
  std::vector<Row> chromaRows_;   ///< of kNv12
  std::vector<std::uint8_t> scratch_;
};

}  // namespace colortool
