// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "colortool/samples/Samples.h"
#include "robotlink/base/Error.h"

namespace colortool {

/// The readable contents of a file of samples. A damaged line loses only what it contains.
struct ReadSamples {
  Samples samples;
  /// The problems of the file and what was skipped because of them, with file and line.
  robotlink::Errors problems;
};

// Samples are stored as text (JSON lines, see SAMPLES.md), so that they can be compared, merged and repaired
// by hand.

/// Fails if the text is no file of samples, or one of a newer version; anything else is in
/// ReadSamples::problems. `file` is the name that errors carry.
robotlink::Result<ReadSamples> parseSamples(std::string_view text, const std::string& file);
robotlink::Result<ReadSamples> loadSamples(const std::filesystem::path& file);

std::string samplesText(const Samples& samples);
/// Replaces the file atomically: it is written completely or not at all.
robotlink::Result<void> saveSamples(const Samples& samples, const std::filesystem::path& file);

}  // namespace colortool
