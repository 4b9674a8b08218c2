// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/arcos/codec/Conversation.h"

namespace robotlink::arcos {

/// Recorded conversations of real clients with a simulator; empty if the project's data are missing.
inline std::vector<std::filesystem::path> recordings() {
  std::vector<std::filesystem::path> files;
  std::error_code missing;
  const std::filesystem::path folder = ROBOTCONTROL_SOURCE_DIR "/../shared/data/arcos/wire";
  for (const auto& entry : std::filesystem::directory_iterator(folder, missing)) {
    if (entry.path().string().ends_with(".wire.xz")) files.push_back(entry.path());
  }
  return files;
}

/// The text of a compressed file; empty if it cannot be read.
inline std::string uncompressed(const std::filesystem::path& file) {
  std::string text;
  FILE* pipe = ::popen(("xz -dc '" + file.string() + "'").c_str(), "r");
  if (!pipe) return text;
  std::array<char, 65536> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    text.append(buffer.data(), count);
  return ::pclose(pipe) == 0 ? text : std::string();
}

}  // namespace robotlink::arcos
