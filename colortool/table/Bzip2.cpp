// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/Bzip2.h"

#include <bzlib.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

namespace colortool {
namespace {

constexpr std::size_t kStep = 256U << 10U;

struct EndOfStream {
  void operator()(bz_stream* stream) const { BZ2_bzDecompressEnd(stream); }
};

}  // namespace

bool isBzip2(std::string_view bytes) {
  return bytes.substr(0, 3) == "BZh";
}

robotlink::Result<std::string> decompressBzip2(std::string_view bytes, std::size_t mostBytes,
                                               const std::string& file) {
  bz_stream stream{};
  const auto wrong = [&](const std::string& what) {
    const std::size_t at = bytes.size() - std::min<std::size_t>(stream.avail_in, bytes.size());
    return robotlink::failure(
        "bzip2.data", fmt::format("this bzip2 file is damaged: at byte {} {}", at, what), {file, 0, 0});
  };
  if (bytes.size() > std::numeric_limits<unsigned>::max()) return wrong("it is too large");
  if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK)
    return robotlink::failure("bzip2.memory", "there is not enough memory to decompress this", {file, 0, 0});
  const std::unique_ptr<bz_stream, EndOfStream> end(&stream);
  // The library declares its input as char*, but does not write to it.
  stream.next_in = const_cast<char*>(bytes.data());
  stream.avail_in = static_cast<unsigned>(bytes.size());
  std::string contents;
  while (true) {
    // Request one byte more than allowed, to detect contents that are too large.
    const std::size_t before = contents.size(), room = std::min(kStep, mostBytes + 1 - before);
    contents.resize(before + room);
    stream.next_out = contents.data() + before;
    stream.avail_out = static_cast<unsigned>(room);
    const int state = BZ2_bzDecompress(&stream);
    contents.resize(contents.size() - stream.avail_out);
    if (contents.size() > mostBytes)
      return robotlink::failure(
          "bzip2.size",
          fmt::format("this becomes larger than {} bytes when it is decompressed, which "
                      "is more than any color table has",
                      mostBytes),
          {file, 0, 0});
    if (state == BZ_STREAM_END) break;
    if (state != BZ_OK) return wrong("its contents do not fit together");
    if (stream.avail_in == 0 && stream.avail_out != 0) return wrong("it ends too early");
  }
  if (stream.avail_in != 0) return wrong("there is extra data after its end");
  return contents;
}

}  // namespace colortool
