// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <unordered_map>

namespace simcore {

/// A sparse set of cells of a plane: bits in tiles of 8 x 8. Coordinates may be negative. Not thread-safe,
/// not even for reading, because it caches the last tile.
class SparseCells {
 public:
  /// Whether a cell is in the set. Constant time on average; fastest near the cell of the last call.
  bool contains(int x, int y) const {
    const std::uint64_t* const tile = find(x, y);
    return tile != nullptr && (*tile & bitOf(x, y)) != 0;
  }
  /// Adds a cell; no effect if it is in the set already.
  void insert(int x, int y) {
    if (std::uint64_t* const tile = find(x, y))
      *tile |= bitOf(x, y);
    else
      // A new tile, with only this cell.
      tiles_[keyOf(x, y)] = bitOf(x, y);
  }
  /// Removes a cell; no effect if it is not in the set. Empty tiles stay allocated.
  void erase(int x, int y) {
    if (std::uint64_t* const tile = find(x, y)) *tile &= ~bitOf(x, y);
  }

 private:
  /// The bit of a cell in its tile.
  static std::uint64_t bitOf(int x, int y) { return std::uint64_t{1} << ((y & 7) * 8 + (x & 7)); }
  /// The key of a cell's tile: both coordinates divided by 8, rounded down, so that tiles do not straddle
  /// the origin.
  static std::uint64_t keyOf(int x, int y) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(x >> 3)) << 32U |
           static_cast<std::uint32_t>(y >> 3);
  }
  /// The tile of a cell, or null. Elements of an unordered_map keep their address when others are inserted.
  std::uint64_t* find(int x, int y) const {
    const std::uint64_t key = keyOf(x, y);
    if (last_ != nullptr && key == lastKey_) return last_;
    // A tile that does not exist is not cached: insert() may create it.
    const auto found = tiles_.find(key);
    if (found == tiles_.end()) return nullptr;
    lastKey_ = key;
    last_ = &found->second;
    return last_;
  }

  /// Keyed by keyOf(); mutable so that find() can return a pointer for writing.
  mutable std::unordered_map<std::uint64_t, std::uint64_t> tiles_;
  // The tile of the last look-up.
  mutable std::uint64_t lastKey_ = 0;
  /// A cache, because neighboring cells are looked up one after the other.
  mutable std::uint64_t* last_ = nullptr;
};

}  // namespace simcore
