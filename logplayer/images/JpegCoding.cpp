// SPDX-License-Identifier: GPL-3.0-or-later
// The JPEG functions of ImageCoding.h, by libturbojpeg.
#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string_view>

#include "logplayer/images/ImageCoding.h"

namespace logplayer {
namespace {

using robotlink::Image;
using robotlink::ImageView;
using robotlink::PixelFormat;
using robotlink::Result;
using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kMaxJpegPixels = 64U << 20U;
/// A progressive image of a few kilobytes can ask for thousands of passes over all its pixels.
constexpr std::size_t kMaxScans = 100;

/// A compressor or a decompressor of the library.
class Codec {
 public:
  explicit Codec(tjhandle handle) : handle_(handle) {}
  ~Codec() {
    if (handle_ != nullptr) tjDestroy(handle_);
  }
  Codec(const Codec&) = delete;
  Codec& operator=(const Codec&) = delete;

  tjhandle get() const { return handle_; }
  /// Whether the last call did its work, possibly with a warning. `status`: what the call returned.
  bool succeeded(int status) const { return status == 0 || tjGetErrorCode(handle_) == TJERR_WARNING; }
  /// Why the last call failed, or its first warning.
  std::string text() const {
    const std::string_view text = tjGetErrorStr2(handle_);
    constexpr std::string_view kEndOfName = "(): ";  // the library's own errors begin with a function's name
    const auto end = text.find(kEndOfName);
    return std::string(end == text.npos ? text : text.substr(end + kEndOfName.size()));
  }

 private:
  tjhandle handle_;
};

tl::unexpected<robotlink::Error> refused(const std::string& why) {
  return robotlink::failure("image.jpeg", "this is not a readable JPEG image: " + why);
}

std::string_view charactersOf(std::span<const std::uint8_t> data) {
  return {reinterpret_cast<const char*>(data.data()), data.size()};
}

std::size_t scansIn(std::string_view data) {
  std::size_t scans = 0;
  for (auto at = data.find("\xFF\xDA"); at != data.npos; at = data.find("\xFF\xDA", at + 2)) ++scans;
  return scans;
}

bool isFromAdobe(std::string_view data) {
  for (auto at = data.find("\xFF\xEE"); at != data.npos; at = data.find("\xFF\xEE", at + 2)) {
    if (data.substr(at + 4, 5) == "Adobe") return true;
  }
  return false;
}

/// Decodes one JPEG.
class Decoder {
 public:
  explicit Decoder(std::span<const std::uint8_t> data) : data_(data), codec_(tjInitDecompress()) {}

  /// Must be called first.
  Result<void> readHeader(std::size_t maximumPixels) {
    if (data_.empty()) return refused("it is empty");
    if (codec_.get() == nullptr) return refused("there is not enough memory");
    const int status =
        tjDecompressHeader3(codec_.get(), data_.data(), size(), &width_, &height_, &subsampling_, &colors_);
    // Color that is sampled in an unusual way is an error here, but can be decoded.
    if (colors_ < 0) return refused(status == 0 ? "it holds no image" : codec_.text());
    const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    if (pixels == 0 || pixels > maximumPixels) {
      const std::string claimed = std::to_string(width_) + " x " + std::to_string(height_);
      return robotlink::failure("image.size",
                                "the JPEG image states " + claimed +
                                    " pixels, which is not decoded; at most " +
                                    std::to_string(maximumPixels) + " are",
                                {}, {claimed});
    }
    if (scansIn(charactersOf(data_)) > kMaxScans) return refused("too many scans");
    return {};
  }
  int width() const { return width_; }
  int height() const { return height_; }
  /// A TJCS.
  int colors() const { return colors_; }
  /// A TJSAMP; negative: another one.
  int subsampling() const { return subsampling_; }

  /// Decodes to rows without gaps; `to` has room for them. Returns the first warning; empty if the data is
  /// intact.
  Result<std::string> decode(TJPF format, std::uint8_t* to) {
    // Neighbors share Cb and Cr, as in a Yuyv image.
    return ended(tjDecompress2(codec_.get(), data_.data(), size(), to, width_, 0, height_, format,
                               TJFLAG_FASTUPSAMPLE));
  }
  /// The same, to planes of Y, Cb and Cr.
  Result<std::string> decodePlanes(std::array<Bytes, 3>& planes) {
    std::array<unsigned char*, 3> rows{};
    for (int i = 0; i < 3; ++i) {
      auto& plane = planes[static_cast<std::size_t>(i)];
      plane.assign(static_cast<std::size_t>(tjPlaneWidth(i, width_, subsampling_)) *
                       static_cast<std::size_t>(tjPlaneHeight(i, height_, subsampling_)),
                   128);
      rows[static_cast<std::size_t>(i)] = plane.data();
    }
    return ended(tjDecompressToYUVPlanes(codec_.get(), data_.data(), size(), rows.data(), width_, nullptr,
                                         height_, 0));
  }

 private:
  unsigned long size() const { return static_cast<unsigned long>(data_.size()); }
  Result<std::string> ended(int status) const {
    if (!codec_.succeeded(status)) return refused(codec_.text());
    return status == 0 ? std::string() : codec_.text();
  }

  std::span<const std::uint8_t> data_;
  Codec codec_;
  int width_ = 0, height_ = 0, subsampling_ = -1, colors_ = -1;
};

/// Writes a row of Y Cb Y Cr per two pixels. `shift`: 2 to its power columns share a value of Cb and Cr.
void packRow(const std::uint8_t* luma, const std::uint8_t* cb, const std::uint8_t* cr, int shift, int width,
             std::uint8_t* to) {
  for (int x = 0; x < width; x += 2, to += 4) {
    const int left = x >> shift, right = (x + 1) >> shift;
    to[0] = luma[x];
    to[1] = static_cast<std::uint8_t>((cb[left] + cb[right] + 1) / 2);
    to[2] = luma[x + 1];
    to[3] = static_cast<std::uint8_t>((cr[left] + cr[right] + 1) / 2);
  }
}

Result<Image> decodeYuyv(Decoder& decoder) {
  std::array<Bytes, 3> planes;
  if (auto done = decoder.decodePlanes(planes); !done) return tl::unexpected(std::move(done.error()));
  Image image(decoder.width(), decoder.height(), PixelFormat::kYuyv);
  const auto subsampling = static_cast<std::size_t>(decoder.subsampling());
  const int shift = std::countr_zero(static_cast<unsigned>(tjMCUWidth[subsampling] / 8));
  const int rows = tjMCUHeight[subsampling] / 8;
  const std::ptrdiff_t lumaWidth = tjPlaneWidth(0, image.width, decoder.subsampling());
  const std::ptrdiff_t chromaWidth = tjPlaneWidth(1, image.width, decoder.subsampling());
  for (int y = 0; y < image.height; ++y) {
    const std::ptrdiff_t chroma = y / rows * chromaWidth;
    packRow(planes[0].data() + y * lumaWidth, planes[1].data() + chroma, planes[2].data() + chroma, shift,
            image.width, image.row(y));
  }
  return image;
}

Result<Bytes> decodeFour(Decoder& decoder, std::string& damage) {
  Bytes inks(static_cast<std::size_t>(decoder.width()) * static_cast<std::size_t>(decoder.height()) * 4);
  auto done = decoder.decode(TJPF_CMYK, inks.data());
  if (!done) return tl::unexpected(std::move(done.error()));
  damage = std::move(*done);
  return inks;
}

/// CMYK images of Adobe's programs are inverted.
Result<Image> decodeFourInks(Decoder& decoder, bool fromAdobe) {
  std::string damage;
  const auto inks = decodeFour(decoder, damage);
  if (!inks) return tl::unexpected(inks.error());
  Image image(decoder.width(), decoder.height(), PixelFormat::kRgb8);
  const std::uint8_t inverse = fromAdobe ? 0 : 255;
  const Bytes& ink = *inks;
  for (std::size_t from = 0, to = 0; from + 3 < ink.size(); from += 4, to += 3)
    for (std::size_t i = 0; i < 3; ++i)
      image.data[to + i] =
          static_cast<std::uint8_t>((ink[from + i] ^ inverse) * (ink[from + 3] ^ inverse) / 255);
  return image;
}

/// The output of the library.
struct Written {
  unsigned char* data = nullptr;
  unsigned long size = 0;

  Written() = default;
  ~Written() { tjFree(data); }
  Written(const Written&) = delete;
  Written& operator=(const Written&) = delete;
};

int compressYuyv(const Codec& codec, const ImageView& image, int quality, Written& written) {
  const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  Bytes luma(pixels), cb(pixels / 2), cr(pixels / 2);
  std::size_t to = 0;
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* from = image.row(y);
    for (int x = 0; x < image.width; x += 2, from += 4, ++to) {
      luma[2 * to] = from[0];
      cb[to] = from[1];
      luma[2 * to + 1] = from[2];
      cr[to] = from[3];
    }
  }
  const unsigned char* planes[] = {luma.data(), cb.data(), cr.data()};
  return tjCompressFromYUVPlanes(codec.get(), planes, image.width, nullptr, image.height, TJSAMP_422,
                                 &written.data, &written.size, quality, TJFLAG_ACCURATEDCT);
}

int compressRows(const Codec& codec, const ImageView& image, int quality, Written& written) {
  const bool gray = image.format == PixelFormat::kMono8;
  return tjCompress2(codec.get(), image.row(0), image.width, image.step, image.height,
                     gray ? TJPF_GRAY : TJPF_RGB, &written.data, &written.size,
                     gray ? TJSAMP_GRAY : TJSAMP_420, quality, TJFLAG_ACCURATEDCT);
}

}  // namespace

Result<Image> decodeJpeg(std::span<const std::uint8_t> data) {
  Decoder decoder(data);
  if (auto header = decoder.readHeader(kMaxJpegPixels); !header)
    return tl::unexpected(std::move(header.error()));
  const int colors = decoder.colors();
  if (colors == TJCS_CMYK || colors == TJCS_YCCK)
    return decodeFourInks(decoder, isFromAdobe(charactersOf(data)));
  if (colors == TJCS_YCbCr && decoder.width() % 2 == 0 && decoder.subsampling() >= 0)
    return decodeYuyv(decoder);
  const bool gray = colors == TJCS_GRAY;
  Image image(decoder.width(), decoder.height(), gray ? PixelFormat::kMono8 : PixelFormat::kRgb8);
  const auto done = decoder.decode(gray ? TJPF_GRAY : TJPF_RGB, image.data.data());
  if (!done) return tl::unexpected(done.error());
  return image;
}

Result<JpegQuads> decodeJpegQuads(std::span<const std::uint8_t> data, std::size_t maximumPixels) {
  Decoder decoder(data);
  if (auto header = decoder.readHeader(maximumPixels); !header)
    return tl::unexpected(std::move(header.error()));
  // Color that was converted when it was encoded would have to be converted back.
  if (decoder.colors() != TJCS_CMYK)
    return robotlink::failure("image.jpeg", "this JPEG image does not have four components per pixel");
  JpegQuads image{decoder.width(), decoder.height(), {}, {}};
  auto quads = decodeFour(decoder, image.damage);
  if (!quads) return tl::unexpected(std::move(quads.error()));
  image.data = std::move(*quads);
  return image;
}

Result<Bytes> encodeJpeg(const ImageView& image, int quality) {
  if (image.empty()) return robotlink::failure("image.empty", "an image without pixels cannot be coded");
  const bool yuyv = image.format == PixelFormat::kYuyv;
  if (yuyv && image.width % 2 != 0)
    return robotlink::failure("image.width",
                              "a yuyv image of odd width cannot be coded; its width must be even");
  if (!yuyv && image.format != PixelFormat::kRgb8 && image.format != PixelFormat::kMono8)
    return encodeJpeg(robotlink::toRgbImage(image).view(), quality);
  const Codec codec(tjInitCompress());
  Written written;
  const auto compress = yuyv ? &compressYuyv : &compressRows;
  if (codec.get() == nullptr || compress(codec, image, std::clamp(quality, 1, 100), written) != 0)
    return robotlink::failure("image.jpeg", "the image cannot be coded as JPEG: " + codec.text());
  return Bytes(written.data, written.data + written.size);
}

}  // namespace logplayer
