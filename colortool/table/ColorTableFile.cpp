// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/ColorTableFile.h"

#include <bit>

#include "robotlink/base/AtomicFile.h"

namespace colortool {

using robotlink::Result;

namespace {

constexpr std::size_t kLengthBytes = 4;
/// Every cell its own run.
constexpr std::size_t kMaxFileBytes = ColorTableFile::kCellCount * (kLengthBytes + 1) + kLengthBytes;

std::uint32_t lengthAt(std::string_view bytes, std::size_t offset) {
  std::uint32_t length = 0;
  for (std::size_t i = kLengthBytes; i-- > 0;)
    length = (length << 8U) | static_cast<std::uint8_t>(bytes[offset + i]);
  return length;
}

void appendLength(std::string& to, std::size_t length) {
  for (std::size_t i = 0; i < kLengthBytes; ++i) to.push_back(static_cast<char>((length >> (8 * i)) & 0xFFU));
}

tl::unexpected<robotlink::Error> wrong(const std::string& file, std::size_t offset, const std::string& what) {
  return robotlink::failure("color-table.c64",
                            "this is not a .c64 color table: at byte " + std::to_string(offset) + " " + what,
                            {file, 0, 0});
}

}  // namespace

Result<ColorTableFile> ColorTableFile::parse(std::string_view bytes, const std::string& file) {
  ColorTableFile table;
  std::size_t filled = 0;
  std::size_t at = 0;
  while (true) {
    if (bytes.size() - at < kLengthBytes) return wrong(file, at, "it ends within its runs");
    const std::uint32_t length = lengthAt(bytes, at);
    if (length == 0) break;
    if (length > kCellCount - filled) return wrong(file, at, "there are more cells than a table has");
    at += kLengthBytes;
    if (at == bytes.size()) return wrong(file, at, "it ends within its runs");
    std::fill_n(table.cells.begin() + static_cast<std::ptrdiff_t>(filled), length,
                static_cast<std::uint8_t>(bytes[at]));
    filled += length;
    ++at;
  }
  if (filled != kCellCount)
    return wrong(
        file, at,
        "its runs end after " + std::to_string(filled) + " of " + std::to_string(kCellCount) + " cells");
  if (at + kLengthBytes != bytes.size())
    return wrong(file, at + kLengthBytes, "there is extra data after its last run");
  return table;
}

Result<ColorTableFile> ColorTableFile::load(const std::filesystem::path& file) {
  const auto bytes = robotlink::readFile(file, kMaxFileBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  return parse(*bytes, file.string());
}

std::string ColorTableFile::bytes() const {
  std::string result;
  for (std::size_t begin = 0; begin < cells.size();) {
    std::size_t end = begin + 1;
    while (end < cells.size() && cells[end] == cells[begin]) ++end;
    appendLength(result, end - begin);
    result.push_back(static_cast<char>(cells[begin]));
    begin = end;
  }
  appendLength(result, 0);
  return result;
}

Result<void> ColorTableFile::save(const std::filesystem::path& file) const {
  return robotlink::writeFileAtomically(file, bytes());
}

std::vector<std::uint16_t> ColorTableFile::masks() const {
  std::vector<std::uint16_t> masks(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::uint8_t cell = cells[i];
    if ((cell & kSeveral) != 0)
      masks[i] = cell & 0x7FU;
    else if (cell >= 1 && cell <= 16)
      masks[i] = static_cast<std::uint16_t>(1U << (cell - 1U));
  }
  return masks;
}

ColorTableFile::Packed ColorTableFile::pack(std::span<const std::uint8_t> winners,
                                            std::span<const std::uint16_t> masks) {
  constexpr unsigned kRoom = (1U << unsigned{kMaxOfSeveral}) - 1;
  Packed packed;
  if (winners.size() != kCellCount || masks.size() != kCellCount) return packed;
  for (std::size_t i = 0; i < kCellCount; ++i) {
    const bool several = std::popcount(masks[i]) > 1;
    std::uint8_t& cell = packed.file.cells[i];
    if (several && masks[i] <= kRoom) {
      cell = static_cast<std::uint8_t>(kSeveral | masks[i]);
    } else if (winners[i] <= kMaxClasses) {
      cell = winners[i];
      if (several) ++packed.reducedCells;
    } else {
      ++packed.emptiedCells;
    }
  }
  return packed;
}

std::vector<std::uint8_t> ColorTableFile::singleClasses() const {
  std::vector<std::uint8_t> single = cells;
  for (std::uint8_t& cell : single) {
    if ((cell & kSeveral) == 0) continue;
    const unsigned mask = cell & 0x7FU;
    cell = mask == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(std::countr_zero(mask) + 1);
  }
  return single;
}

}  // namespace colortool
