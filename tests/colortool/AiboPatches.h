// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Image.h"

/// A pixel that the camera of a real ERS-7 saw in the middle of a colored card.
struct AiboPixel {
  /// Day and robot.
  std::string session;
  /// The color of the card.
  std::string label;
  robotlink::YCbCr color;
};

/// Reads the labeled pixels of ../shared; empty if they are missing, or xz is. The columns u and v of the
/// file are Cr and Cb.
inline std::vector<AiboPixel> readAiboPatches() {
  const std::string file = ROBOTCONTROL_SOURCE_DIR "/../shared/data/colour/ers7/patches.csv.xz";
  std::vector<AiboPixel> pixels;
  if (!std::filesystem::exists(file)) return pixels;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> lines(
      ::popen(("xz -dc '" + file + "' 2>/dev/null").c_str(), "r"), &::pclose);
  if (!lines) return pixels;
  char day[32], robot[32], label[32], text[160];
  unsigned y = 0, cr = 0, cb = 0;
  while (std::fgets(text, sizeof text, lines.get()) != nullptr) {
    if (std::sscanf(text, "%31[^,],%31[^,],%31[^,],%u,%u,%u", day, robot, label, &y, &cr, &cb) != 6) continue;
    const auto byte = [](unsigned value) { return static_cast<std::uint8_t>(value); };
    pixels.push_back({std::string(day) + " " + robot, label, {byte(y), byte(cb), byte(cr)}});
  }
  return pixels;
}
