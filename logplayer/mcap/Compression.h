// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "logplayer/mcap/Records.h"

namespace logplayer::mcap {

/// Compresses the records of chunks as LZ4 frames or Zstandard frames; keeps its memory between chunks.
class Compressor {
 public:
  /// Level 0: lz4's fast mode, zstd's 1.
  Compressor(Compression compression, int level);
  ~Compressor();
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  /// Valid until the next call. Nothing where it would not get smaller, or nothing is to be compressed.
  std::optional<Bytes> compress(Bytes records);

 private:
  std::optional<Bytes> result(std::size_t bytes, std::size_t of) const;

  struct Context;
  Compression compression_;
  int level_;
  std::unique_ptr<Context> context_;
  std::vector<std::uint8_t> out_;
};

/// Takes back what a Compressor does.
class Decompressor {
 public:
  Decompressor();
  ~Decompressor();
  Decompressor(const Decompressor&) = delete;
  Decompressor& operator=(const Decompressor&) = delete;

  /// False: these records cannot become so many bytes, whatever they hold. Asked before memory is taken for a
  /// size that a file claims: at most 255 bytes of lz4 and a block of 128 KiB in 4 of zstd come from one
  /// byte, and zstd frames may tell their size.
  static bool canYield(Compression compression, Bytes records, std::uint64_t bytes);

  /// False: damaged, or it does not yield exactly as many bytes as `out` holds. Never writes more.
  bool decompress(Compression compression, Bytes records, std::span<std::uint8_t> out);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace logplayer::mcap
