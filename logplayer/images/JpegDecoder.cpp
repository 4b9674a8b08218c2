// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "logplayer/images/ImageCoding.h"
#include "logplayer/images/JpegErrors.h"

namespace logplayer {
namespace {

using robotlink::Image;
using robotlink::PixelFormat;
using robotlink::Result;

constexpr std::size_t kMaxJpegPixels = 64U << 20U;
/// A progressive image of a few kilobytes can ask for thousands of passes over all its pixels.
constexpr int kMaxScans = 100;

class Decoder {
 public:
  explicit Decoder(std::span<const std::uint8_t> data) : data_(data) {
    codec_.err = errors_.handler();
    progress_.progress_monitor = &limitScans;
  }
  ~Decoder() { jpeg_destroy_decompress(&codec_); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  bool readHeader() {
    if (setjmp(errors_.jump()) != 0) return false;
    jpeg_create_decompress(&codec_);
    codec_.progress = &progress_;
    jpeg_mem_src(&codec_, data_.data(), data_.size());
    return jpeg_read_header(&codec_, TRUE) == JPEG_HEADER_OK;
  }

  /// Decodes in a color space to an image with `step` bytes per row.
  bool readRows(J_COLOR_SPACE space, std::uint8_t* to, std::size_t step) {
    if (setjmp(errors_.jump()) != 0) return false;
    codec_.out_color_space = space;
    codec_.do_fancy_upsampling = FALSE;  // neighbors share Cb and Cr, as in a Yuyv image
    jpeg_start_decompress(&codec_);
    while (codec_.output_scanline < codec_.output_height) {
      JSAMPROW row = to + codec_.output_scanline * step;
      jpeg_read_scanlines(&codec_, &row, 1);
    }
    jpeg_finish_decompress(&codec_);
    return true;
  }

  std::size_t pixels() const { return std::size_t{codec_.image_width} * codec_.image_height; }
  int width() const { return static_cast<int>(codec_.image_width); }
  int height() const { return static_cast<int>(codec_.image_height); }
  int components() const { return codec_.num_components; }
  J_COLOR_SPACE space() const { return codec_.jpeg_color_space; }
  bool fromAdobe() const { return codec_.saw_Adobe_marker == TRUE; }
  std::string text() const { return errors_.text(); }

 private:
  static void limitScans(j_common_ptr codec) {
    const auto* decoder = reinterpret_cast<j_decompress_ptr>(codec);
    if (decoder->input_scan_number > kMaxScans) JpegErrors::stop(codec, "too many scans");
  }

  std::span<const std::uint8_t> data_;
  JpegErrors errors_;
  jpeg_progress_mgr progress_{};
  jpeg_decompress_struct codec_{};
};

tl::unexpected<robotlink::Error> refused(const Decoder& decoder) {
  const std::string text = decoder.text();
  return robotlink::failure("image.jpeg",
                            "this is not a readable JPEG image: " + (text.empty() ? "no header" : text));
}

/// An error if the image is too large to be decoded.
std::optional<robotlink::Error> tooLarge(const Decoder& decoder, std::size_t maximumPixels) {
  if (decoder.pixels() > 0 && decoder.pixels() <= maximumPixels) return std::nullopt;
  const std::string size = std::to_string(decoder.width()) + " x " + std::to_string(decoder.height());
  return robotlink::Error{"image.size",
                          "the JPEG image claims " + size + " pixels, which is not decoded; at most " +
                              std::to_string(maximumPixels) + " are",
                          {size},
                          {}};
}

/// Converts Y Cb Cr per pixel to Y Cb Y Cr per two pixels.
void packYuyv(const std::vector<std::uint8_t>& row, std::uint8_t* to) {
  for (std::size_t i = 0; i + 5 < row.size(); i += 6, to += 4) {
    to[0] = row[i];
    to[1] = static_cast<std::uint8_t>((row[i + 1] + row[i + 4] + 1) / 2);
    to[2] = row[i + 3];
    to[3] = static_cast<std::uint8_t>((row[i + 2] + row[i + 5] + 1) / 2);
  }
}

Result<Image> decodeYuyv(Decoder& decoder) {
  const std::size_t step = static_cast<std::size_t>(decoder.width()) * 3;
  std::vector<std::uint8_t> full(step * static_cast<std::size_t>(decoder.height()));
  if (!decoder.readRows(JCS_YCbCr, full.data(), step)) return refused(decoder);
  Image image(decoder.width(), decoder.height(), PixelFormat::kYuyv);
  std::vector<std::uint8_t> row(step);
  for (int y = 0; y < image.height; ++y) {
    const auto begin = full.begin() + static_cast<std::ptrdiff_t>(step) * y;
    row.assign(begin, begin + static_cast<std::ptrdiff_t>(step));
    packYuyv(row, image.row(y));
  }
  return image;
}

/// CMYK images of Adobe's programs are inverted.
Result<Image> decodeFourInks(Decoder& decoder) {
  const std::size_t step = static_cast<std::size_t>(decoder.width()) * 4;
  std::vector<std::uint8_t> inks(step * static_cast<std::size_t>(decoder.height()));
  if (!decoder.readRows(JCS_CMYK, inks.data(), step)) return refused(decoder);
  Image image(decoder.width(), decoder.height(), PixelFormat::kRgb8);
  const std::uint8_t inverse = decoder.fromAdobe() ? 0 : 255;
  for (std::size_t from = 0, to = 0; from + 3 < inks.size(); from += 4, to += 3)
    for (std::size_t i = 0; i < 3; ++i)
      image.data[to + i] =
          static_cast<std::uint8_t>((inks[from + i] ^ inverse) * (inks[from + 3] ^ inverse) / 255);
  return image;
}

}  // namespace

Result<Image> decodeJpeg(std::span<const std::uint8_t> data) {
  Decoder decoder(data);
  if (!decoder.readHeader()) return refused(decoder);
  if (auto error = tooLarge(decoder, kMaxJpegPixels)) return tl::unexpected(*std::move(error));
  if (decoder.components() == 4) return decodeFourInks(decoder);
  if (decoder.space() == JCS_YCbCr && decoder.width() % 2 == 0) return decodeYuyv(decoder);
  const bool gray = decoder.space() == JCS_GRAYSCALE;
  Image image(decoder.width(), decoder.height(), gray ? PixelFormat::kMono8 : PixelFormat::kRgb8);
  const auto step = static_cast<std::size_t>(image.step());
  if (!decoder.readRows(gray ? JCS_GRAYSCALE : JCS_RGB, image.data.data(), step)) return refused(decoder);
  return image;
}

Result<JpegComponents> decodeJpegComponents(std::span<const std::uint8_t> data, std::size_t maximumPixels) {
  Decoder decoder(data);
  if (!decoder.readHeader()) return refused(decoder);
  if (auto error = tooLarge(decoder, maximumPixels)) return tl::unexpected(*std::move(error));
  if (decoder.components() > 4)
    return robotlink::failure("image.jpeg", "this JPEG image has more than four components a pixel");
  JpegComponents image{decoder.width(), decoder.height(), decoder.components(), {}, {}};
  const std::size_t step = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.count);
  image.data.resize(step * static_cast<std::size_t>(image.height));
  if (!decoder.readRows(decoder.space(), image.data.data(), step)) return refused(decoder);
  image.damage = decoder.text();
  return image;
}

}  // namespace logplayer
