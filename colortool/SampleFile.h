// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "colortool/Samples.h"
#include "robotlink/base/Error.h"

namespace colortool {

/// What could be read of a file of samples. A damaged line costs what it says, and no more.
struct ReadSamples {
  Samples samples;
  robotlink::Errors problems;  ///< with file and line; what is wrong and what of it is left out
};

// Samples are kept as text (JSON lines, see SAMPLES.md), so that they can be compared, merged and mended.

/// Fails if it is no file of samples at all, or one of a newer version. `file` is the name that errors carry.
robotlink::Result<ReadSamples> parseSamples(std::string_view text, const std::string& file);
robotlink::Result<ReadSamples> loadSamples(const std::filesystem::path& file);

std::string samplesText(const Samples& samples);
/// Whole or not at all.
robotlink::Result<void> saveSamples(const Samples& samples, const std::filesystem::path& file);

}  // namespace colortool
