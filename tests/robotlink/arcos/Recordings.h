// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/arcos/codec/Conversation.h"

namespace robotlink::arcos {

/// Where tests take conversations from: real clients with a simulator, recorded, which may be missing; or the
/// folder "conversations", whose files were written by hand, so to speak. These are the parameters of such
/// tests.
inline const std::vector<std::string> kConversationSources{"real", "made"};

/// The conversations of a source, by their names.
inline std::vector<std::filesystem::path> conversations(const std::string& source) {
  std::vector<std::filesystem::path> files;
  std::error_code missing;
  const std::filesystem::path folder = source == "real" ? ROBOTCONTROL_SOURCE_DIR "/../shared/data/arcos/wire"
                                                        : ROBOTCONTROL_SOURCE_DIR
                                           "/tests/robotlink/arcos/conversations";
  for (const auto& entry : std::filesystem::directory_iterator(folder, missing)) {
    const std::string name = entry.path().filename();
    if (name.ends_with(source == "real" ? ".wire.xz" : ".wire")) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// The text of a file, which may be compressed; empty if it cannot be read.
inline std::string textOf(const std::filesystem::path& file) {
  std::string text;
  const std::string program = file.extension() == ".xz" ? "xz -dc '" : "cat '";
  FILE* pipe = ::popen((program + file.string() + "'").c_str(), "r");
  if (!pipe) return text;
  std::array<char, 65536> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    text.append(buffer.data(), count);
  return ::pclose(pipe) == 0 ? text : std::string();
}

/// The conversation "drive" of the real or the made ones; nothing if there is none of this name.
inline std::optional<Conversation> conversation(const std::string& source, const std::string& name) {
  for (const auto& file : conversations(source)) {
    const std::string known = file.filename();
    if (known.substr(0, known.find('.')) != name) continue;
    const auto read = readConversation(textOf(file), file.string());
    if (read) return *read;
  }
  return std::nullopt;
}

}  // namespace robotlink::arcos
