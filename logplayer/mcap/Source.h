// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "logplayer/mcap/Codec.h"
#include "robotlink/base/Error.h"

namespace logplayer::mcap {

/// A file with random access. It is not mapped into memory, since truncating a mapped file while it is read
/// would crash the program. Const functions use pread() and may be called from several threads.
class Source {
 public:
  /// Identifies a file and its version.
  struct Identity {
    std::uint64_t device = 0, file = 0, bytes = 0;
    std::int64_t changed = 0;  ///< ns
    auto operator<=>(const Identity&) const = default;
  };

  static robotlink::Result<Source> open(const std::filesystem::path& file);
  Source(Source&& other) noexcept;
  Source& operator=(Source&&) = delete;
  ~Source();

  const std::filesystem::path& file() const { return file_; }
  /// The size when it was opened.
  std::uint64_t bytes() const { return identity_.bytes; }
  const Identity& identity() const { return identity_; }
  /// How many bytes were cut off its end since then.
  std::uint64_t cutOff() const;
  /// Fills `to`; returns false if the file ends before or the system cannot read it.
  bool read(std::uint64_t offset, std::span<std::uint8_t> to) const;
  /// Reads up to `count` bytes, fewer at the end of the file.
  Buffer read(std::uint64_t offset, std::uint64_t count) const;

 private:
  Source(std::filesystem::path file, int descriptor, const Identity& identity);

  std::filesystem::path file_;
  int descriptor_;
  Identity identity_;
};

/// Reads a file through a moving buffer, to visit many small records quickly. The source must outlive this
/// object.
class SourceWindow {
 public:
  explicit SourceWindow(const Source& source, std::size_t bytes = 64U << 10U)
      : source_(source), size_(bytes) {}

  /// Returns `count` bytes at `offset`, fewer at the end of the file. Valid until the next call.
  Bytes look(std::uint64_t offset, std::size_t count);

 private:
  const Source& source_;
  std::size_t size_;
  /// Offset of the buffer in the file.
  std::uint64_t start_ = 0;
  Buffer buffer_;
};

}  // namespace logplayer::mcap
