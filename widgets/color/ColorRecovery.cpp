// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorRecovery.h"

#include <utility>

namespace widgets {

std::optional<robotlink::Result<colortool::ReadSamples>> ColorRecovery::left() {
  if (!place_.isLeft()) return std::nullopt;
  auto read = colortool::loadSamples(file());
  if (read && read->problems.empty()) return read;
  const std::string note = "what was there is kept in " + place_.setAside().string();
  if (!read) {
    robotlink::Error damaged = read.error();
    damaged.text += "; " + note;
    return tl::unexpected(damaged);
  }
  read->problems.push_back({"color.recovery-damaged", note, {}, {}});
  return read;
}

void ColorRecovery::keep(colortool::Samples samples) {
  place_.keep([samples = std::move(samples)](const std::filesystem::path& file) {
    return colortool::saveSamples(samples, file);
  });
}

}  // namespace widgets
