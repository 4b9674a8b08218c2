// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "robotlink/base/Error.h"

namespace logplayer::bhuman {

/// Bytes that are read at any place: a file, or memory that must outlive it.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  virtual std::uint64_t size() const = 0;
  /// How many of the bytes from `offset` on could be read into `to`: all of them, but for the end and for
  /// errors of the disk.
  virtual std::size_t read(std::uint64_t offset, std::span<std::uint8_t> to) = 0;
};

robotlink::Result<std::unique_ptr<ByteSource>> openFile(const std::filesystem::path& file);
std::unique_ptr<ByteSource> bytesInMemory(std::span<const std::uint8_t> bytes);

}  // namespace logplayer::bhuman
