// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "logplayer/images/ImageCoding.h"

namespace logplayer {

/// Writes a video in the smallest AVI file there is: frames of JPEG in one RIFF chunk, with an index.
class AviFile {
 public:
  AviFile(int width, int height, int framesPerSecond)
      : width_(width), height_(height), framesPerSecond_(framesPerSecond) {}

  void add(const robotlink::Image& image) {
    const auto jpeg = encodeJpeg(image.view(), 95);
    frames_.emplace_back(jpeg->begin(), jpeg->end());
    if (frames_.back().size() % 2 != 0) frames_.back() += '\0';
  }

  std::string bytes() const {
    const auto count = static_cast<std::uint32_t>(frames_.size());
    const auto rate = static_cast<std::uint32_t>(framesPerSecond_);
    const auto width = static_cast<std::uint32_t>(width_), height = static_cast<std::uint32_t>(height_);
    const std::string main =
        numbers({1000000 / rate, 0, 0, 0x10, count, 0, 1, 1U << 20U, width, height, 0, 0, 0, 0});
    const std::string stream = "vidsMJPG" + numbers({0, 0, 0, 1, rate, 0, count, 1U << 20U, 0xffffffff, 0, 0,
                                                     width | height << 16U});
    const std::string format =
        numbers({40, width, height, 1U | 24U << 16U}) + "MJPG" + numbers({width * height * 3, 0, 0, 0, 0});
    const std::string streams = list("strl", chunk("strh", stream) + chunk("strf", format));
    std::string movie, index;
    for (const std::string& frame : frames_) {
      index += "00dc" + numbers({0x10, static_cast<std::uint32_t>(movie.size() + 4),
                                 static_cast<std::uint32_t>(frame.size())});
      movie += chunk("00dc", frame);
    }
    return chunk("RIFF", "AVI " + list("hdrl", chunk("avih", main) + streams) + list("movi", movie) +
                             chunk("idx1", index));
  }

  void write(const std::filesystem::path& file) const { std::ofstream(file, std::ios::binary) << bytes(); }

 private:
  static std::string numbers(const std::vector<std::uint32_t>& values) {
    std::string bytes;
    for (const std::uint32_t value : values) {
      for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xffU);
    }
    return bytes;
  }
  static std::string chunk(const std::string& name, const std::string& contents) {
    return name + numbers({static_cast<std::uint32_t>(contents.size())}) + contents;
  }
  static std::string list(const std::string& name, const std::string& contents) {
    return chunk("LIST", name + contents);
  }

  int width_, height_, framesPerSecond_;
  std::vector<std::string> frames_;
};

}  // namespace logplayer
