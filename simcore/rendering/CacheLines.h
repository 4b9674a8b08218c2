// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace simcore::rendering {

/// An array of numbers that begins at a line of the processor's cache, so that no group of eight floats that
/// begins at a multiple of eight extends over two lines.
template <typename T>
class CacheLines {
 public:
  explicit CacheLines(std::size_t size = 0, T value = {}) { assign(size, value); }

  /// Sets the number of elements, and all of them to a value.
  void assign(std::size_t size, T value) {
    lines_.resize((size + kPerLine - 1) / kPerLine);
    for (Line& line : lines_) std::fill_n(line.elements, kPerLine, value);
    size_ = size;
  }
  T* data() { return lines_.empty() ? nullptr : lines_.front().elements; }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  T& operator[](std::size_t i) { return data()[i]; }
  std::size_t size() const { return size_; }

 private:
  static constexpr std::size_t kLine = 64, kPerLine = kLine / sizeof(T);
  struct alignas(kLine) Line {
    T elements[kPerLine];
  };

  std::vector<Line> lines_;
  std::size_t size_ = 0;
};

}  // namespace simcore::rendering
