// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "logplayer/mcap/Codec.h"
#include "robotlink/base/Error.h"

namespace logplayer::mcap {

/// A file that is read at any place. Not mapped into memory: whoever cuts a file while it is read must not
/// end the program.
class Source {
 public:
  /// Which file it is, and as of when.
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
  /// As it was when it was opened.
  std::uint64_t bytes() const { return identity_.bytes; }
  const Identity& identity() const { return identity_; }
  /// How many bytes somebody cut off its end since then.
  std::uint64_t cutOff() const;
  /// False: it ends before, or the system cannot read it.
  bool read(std::uint64_t offset, std::span<std::uint8_t> to) const;
  /// Up to `count` bytes, less where the file ends.
  Buffer read(std::uint64_t offset, std::uint64_t count) const;

 private:
  Source(std::filesystem::path file, int descriptor, const Identity& identity);

  std::filesystem::path file_;
  int descriptor_;
  Identity identity_;
};

/// Looks at a file through a buffer that moves along, for going over many small records.
class SourceWindow {
 public:
  explicit SourceWindow(const Source& source, std::size_t bytes = 64U << 10U)
      : source_(source), size_(bytes) {}

  /// `count` bytes at `offset`, valid until the next call; fewer where the file ends.
  Bytes look(std::uint64_t offset, std::size_t count);

 private:
  const Source& source_;
  std::size_t size_;
  std::uint64_t start_ = 0;
  Buffer buffer_;
};

}  // namespace logplayer::mcap
