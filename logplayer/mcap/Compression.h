// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "logplayer/mcap/Records.h"

namespace logplayer::mcap {

/// Compresses the records of chunks as LZ4 or Zstandard frames; reuses its memory from chunk to chunk. One
/// thread.
class Compressor {
 public:
  /// Level 0 is the fast mode of lz4 and level 1 of zstd.
  Compressor(Compression compression, int level);
  ~Compressor();
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  /// Returns the compressed records, valid until the next call. Empty if the compression is kNone or the
  /// result would not be smaller.
  std::optional<Bytes> compress(Bytes records);

 private:
  /// The output, if it is smaller than its input of `of` bytes.
  std::optional<Bytes> result(std::size_t bytes, std::size_t of) const;

  /// The state of the libraries.
  struct Context;
  Compression compression_;
  int level_;
  std::unique_ptr<Context> context_;
  std::vector<std::uint8_t> out_;
};

/// The inverse of Compressor. One thread.
class Decompressor {
 public:
  Decompressor();
  ~Decompressor();
  Decompressor(const Decompressor&) = delete;
  Decompressor& operator=(const Decompressor&) = delete;

  /// Whether compressed records can possibly yield this number of bytes. To be checked before allocating
  /// memory for a size that a file claims: one byte yields at most 255 bytes with lz4, four bytes at most a
  /// block of 128 KiB with zstd, and zstd frames may contain their size.
  static bool canYield(Compression compression, Bytes records, std::uint64_t bytes);

  /// Fills `out`. Returns false if the data is damaged or does not yield exactly out.size() bytes; never
  /// writes past the end.
  bool decompress(Compression compression, Bytes records, std::span<std::uint8_t> out);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace logplayer::mcap
