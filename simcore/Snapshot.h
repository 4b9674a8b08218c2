// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace simcore {

class Scene;

/// The state of a simulation at an instant, in memory or in a file; see SNAPSHOTS.md. A plain value, which
/// any number of simulations of the same scene can be put into.
struct Snapshot {
  /// The version of the files that are written; files of others are refused.
  static constexpr std::uint32_t kVersion = 8;
  /// No file is larger.
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 30U;

  /// The file of the scene, for users.
  std::string scene;
  /// Identifies the scene, whatever its file is called.
  std::uint64_t fingerprint = 0;
  /// Steps of the simulation.
  std::uint64_t step = 0;
  std::vector<std::uint8_t> state;
  /// The data that the owner of the simulation keeps with the snapshot, by name.
  std::map<std::string, std::vector<std::uint8_t>> parts = {};
  /// The scene; null if it comes from a file. With it, whatever an edited scene still has can be restored.
  std::shared_ptr<const Scene> of = {};
  /// Whether it comes from a file, so that its contents are checked.
  bool isForeign = false;

  /// The memory that it takes, about.
  std::size_t bytes() const;
  /// The contents of a file. The reverse fails, with `name` as the file's in its text, if they are not those
  /// of a snapshot, are damaged, or have another version.
  std::vector<std::uint8_t> encode() const;
  static robotlink::Result<Snapshot> decode(std::span<const std::uint8_t> bytes, const std::string& name);
  /// Writes a file as a whole or not at all.
  robotlink::Result<void> write(const std::filesystem::path& file) const;
  static robotlink::Result<Snapshot> read(const std::filesystem::path& file);
};

}  // namespace simcore
