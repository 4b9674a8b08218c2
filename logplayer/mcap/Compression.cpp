// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/Compression.h"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>

namespace logplayer::mcap {

struct Compressor::Context {
  ZSTD_CCtx* zstd = nullptr;

  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { ZSTD_freeCCtx(zstd); }
};

Compressor::Compressor(Compression compression, int level)
    : compression_(compression), level_(level), context_(std::make_unique<Context>()) {
  if (compression_ == Compression::kZstd) {
    if (level_ == 0) level_ = 1;
    context_->zstd = ZSTD_createCCtx();
  }
}

Compressor::~Compressor() = default;

std::optional<Bytes> Compressor::result(std::size_t bytes, std::size_t of) const {
  if (bytes >= of) return std::nullopt;
  return Bytes(out_).first(bytes);
}

std::optional<Bytes> Compressor::compress(Bytes records) {
  if (compression_ == Compression::kLz4) {
    LZ4F_preferences_t preferences{};
    preferences.compressionLevel = level_;
    preferences.frameInfo.blockSizeID = LZ4F_max1MB;
    preferences.frameInfo.contentSize = records.size();
    const std::size_t bound = LZ4F_compressFrameBound(records.size(), &preferences);
    if (out_.size() < bound) out_.resize(bound);
    const std::size_t bytes =
        LZ4F_compressFrame(out_.data(), out_.size(), records.data(), records.size(), &preferences);
    if (LZ4F_isError(bytes) == 0) return result(bytes, records.size());
  } else if (compression_ == Compression::kZstd && context_->zstd != nullptr) {
    const std::size_t bound = ZSTD_compressBound(records.size());
    if (out_.size() < bound) out_.resize(bound);
    const std::size_t bytes =
        ZSTD_compressCCtx(context_->zstd, out_.data(), out_.size(), records.data(), records.size(), level_);
    if (ZSTD_isError(bytes) == 0) return result(bytes, records.size());
  }
  return std::nullopt;
}

struct Decompressor::Context {
  LZ4F_dctx* lz4 = nullptr;
  ZSTD_DCtx* zstd = nullptr;

  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() {
    LZ4F_freeDecompressionContext(lz4);
    ZSTD_freeDCtx(zstd);
  }

  bool decompressLz4(Bytes in, std::span<std::uint8_t> out) {
    if (lz4 == nullptr && LZ4F_isError(LZ4F_createDecompressionContext(&lz4, LZ4F_VERSION)) != 0)
      return false;
    LZ4F_resetDecompressionContext(lz4);
    LZ4F_decompressOptions_t options{};
    options.stableDst = 1;
    while (true) {
      std::size_t outBytes = out.size();
      std::size_t inBytes = in.size();
      const std::size_t wanted = LZ4F_decompress(lz4, out.data(), &outBytes, in.data(), &inBytes, &options);
      if (LZ4F_isError(wanted) != 0) return false;
      out = out.subspan(outBytes);
      in = in.subspan(inBytes);
      if (wanted == 0) return out.empty() && in.empty();
      if (outBytes == 0 && inBytes == 0) return false;  // the decompressor needs more input or more output
    }
  }

  bool decompressZstd(Bytes in, std::span<std::uint8_t> out) {
    if (zstd == nullptr && (zstd = ZSTD_createDCtx()) == nullptr) return false;
    return ZSTD_decompressDCtx(zstd, out.data(), out.size(), in.data(), in.size()) == out.size();
  }
};

Decompressor::Decompressor() : context_(std::make_unique<Context>()) {}
Decompressor::~Decompressor() = default;

bool Decompressor::canYield(Compression compression, Bytes records, std::uint64_t bytes) {
  constexpr std::uint64_t kMaxLz4Ratio = 255;          // a byte that lengthens a match
  constexpr std::uint64_t kMaxZstdRatio = 128U << 8U;  // a repeated byte, with its block's head of three
  switch (compression) {
    case Compression::kLz4:
      return bytes / kMaxLz4Ratio <= records.size();
    case Compression::kZstd: {
      const unsigned long long stated = ZSTD_getFrameContentSize(records.data(), records.size());
      if (stated == ZSTD_CONTENTSIZE_ERROR) return false;
      // The frame may be followed by others.
      return (stated == ZSTD_CONTENTSIZE_UNKNOWN || stated <= bytes) &&
             bytes / kMaxZstdRatio <= records.size();
    }
    case Compression::kNone:
      break;
  }
  return bytes == records.size();
}

bool Decompressor::decompress(Compression compression, Bytes records, std::span<std::uint8_t> out) {
  switch (compression) {
    case Compression::kLz4:
      return context_->decompressLz4(records, out);
    case Compression::kZstd:
      return context_->decompressZstd(records, out);
    case Compression::kNone:
      break;
  }
  if (records.size() != out.size()) return false;
  std::ranges::copy(records, out.begin());
  return true;
}

}  // namespace logplayer::mcap
