// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>

#include "logplayer/images/ImageCoding.h"
#include "logplayer/images/JpegErrors.h"

namespace logplayer {
namespace {

using robotlink::ImageView;
using robotlink::PixelFormat;

/// Number of rows that libjpeg accepts at a time for a 4:2:2 image.
constexpr int kBlock = DCTSIZE;

/// A Yuyv image as planes, in bands of kBlock rows; the last columns and rows are repeated to fill whole
/// blocks.
class Planes {
 public:
  explicit Planes(const ImageView& image)
      : image_(image),
        lumaWidth_(static_cast<std::size_t>((image.width + 2 * kBlock - 1) / (2 * kBlock) * 2 * kBlock)),
        samples_(lumaWidth_ * 2 * kBlock) {
    for (int i = 0; i < kBlock; ++i) {
      const auto row = static_cast<std::size_t>(i);
      luma_[i] = samples_.data() + row * lumaWidth_;
      cb_[i] = samples_.data() + (kBlock + row) * lumaWidth_;
      cr_[i] = cb_[i] + lumaWidth_ / 2;
    }
  }
  Planes(const Planes&) = delete;
  Planes& operator=(const Planes&) = delete;

  JSAMPIMAGE band(int top) {
    for (int i = 0; i < kBlock; ++i) split(image_.row(std::min(top + i, image_.height - 1)), i);
    return planes_;
  }

 private:
  void split(const std::uint8_t* pixels, int i) {
    const int last = image_.width / 2 - 1;
    for (int pair = 0; pair < static_cast<int>(lumaWidth_) / 2; ++pair) {
      const std::uint8_t* from = pixels + std::ptrdiff_t{4} * std::min(pair, last);
      std::uint8_t* luma = luma_[i] + std::ptrdiff_t{2} * pair;
      luma[0] = pair <= last ? from[0] : from[2];
      luma[1] = from[2];
      cb_[i][pair] = from[1];
      cr_[i][pair] = from[3];
    }
  }

  ImageView image_;
  std::size_t lumaWidth_;
  std::vector<std::uint8_t> samples_;
  JSAMPROW luma_[kBlock] = {}, cb_[kBlock] = {}, cr_[kBlock] = {};
  JSAMPARRAY planes_[3] = {luma_, cb_, cr_};
};

class Encoder {
 public:
  Encoder() { codec_.err = errors_.handler(); }
  ~Encoder() {
    jpeg_destroy_compress(&codec_);
    std::free(data_);
  }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  bool encodeRows(const ImageView& image, int quality) {
    if (setjmp(errors_.jump()) != 0) return false;
    const bool gray = image.format == PixelFormat::kMono8;
    begin(image, gray ? JCS_GRAYSCALE : JCS_RGB, quality);
    jpeg_start_compress(&codec_, TRUE);
    while (codec_.next_scanline < codec_.image_height) {
      auto* row = const_cast<JSAMPROW>(image.row(static_cast<int>(codec_.next_scanline)));
      jpeg_write_scanlines(&codec_, &row, 1);
    }
    jpeg_finish_compress(&codec_);
    return true;
  }

  bool encodePlanes(const ImageView& image, Planes& planes, int quality) {
    if (setjmp(errors_.jump()) != 0) return false;
    begin(image, JCS_YCbCr, quality);
    codec_.raw_data_in = TRUE;
    codec_.comp_info[0].h_samp_factor = 2;
    codec_.comp_info[0].v_samp_factor = 1;
    jpeg_start_compress(&codec_, TRUE);
    while (codec_.next_scanline < codec_.image_height)
      jpeg_write_raw_data(&codec_, planes.band(static_cast<int>(codec_.next_scanline)), kBlock);
    jpeg_finish_compress(&codec_);
    return true;
  }

  std::vector<std::uint8_t> result() const { return {data_, data_ + size_}; }
  std::string text() const { return errors_.text(); }

 private:
  void begin(const ImageView& image, J_COLOR_SPACE space, int quality) {
    jpeg_create_compress(&codec_);
    jpeg_mem_dest(&codec_, &data_, &size_);
    codec_.image_width = static_cast<JDIMENSION>(image.width);
    codec_.image_height = static_cast<JDIMENSION>(image.height);
    codec_.input_components = space == JCS_GRAYSCALE ? 1 : 3;
    codec_.in_color_space = space;
    jpeg_set_defaults(&codec_);
    jpeg_set_quality(&codec_, std::clamp(quality, 1, 100), TRUE);
  }

  JpegErrors errors_;
  jpeg_compress_struct codec_{};
  unsigned char* data_ = nullptr;  // allocated by malloc(); libjpeg replaces it as it grows
  unsigned long size_ = 0;
};

}  // namespace

robotlink::Result<std::vector<std::uint8_t>> encodeJpeg(const ImageView& image, int quality) {
  if (image.empty()) return robotlink::failure("image.empty", "an image without pixels cannot be coded");
  if (image.format == PixelFormat::kYuyv && image.width % 2 != 0)
    return robotlink::failure("image.width",
                              "a yuyv image of odd width cannot be coded; its width must be even");
  const bool native = image.format == PixelFormat::kYuyv || image.format == PixelFormat::kRgb8 ||
                      image.format == PixelFormat::kMono8;
  if (!native) return encodeJpeg(robotlink::toRgbImage(image).view(), quality);
  Encoder encoder;
  bool done = false;
  if (image.format == PixelFormat::kYuyv) {
    Planes planes(image);
    done = encoder.encodePlanes(image, planes, quality);
  } else {
    done = encoder.encodeRows(image, quality);
  }
  if (!done) return robotlink::failure("image.jpeg", "the image cannot be coded as JPEG: " + encoder.text());
  return encoder.result();
}

}  // namespace logplayer
