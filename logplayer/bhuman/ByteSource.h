// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "robotlink/base/Error.h"

namespace logplayer::bhuman {

/// Bytes with random access: a file, or in tests memory.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Number of bytes.
  virtual std::uint64_t size() const = 0;
  /// Reads bytes from `offset` on into `to`. Returns the number of bytes read, which is less than requested
  /// only at the end or after an I/O error.
  virtual std::size_t read(std::uint64_t offset, std::span<std::uint8_t> to) = 0;
};

/// Fails if the file cannot be opened.
robotlink::Result<std::unique_ptr<ByteSource>> openFile(const std::filesystem::path& file);

}  // namespace logplayer::bhuman
