// SPDX-License-Identifier: GPL-3.0-or-later
// What libFuzzer calls, in programs that have one target.
#include <algorithm>

#include "tests/fuzz/FuzzTarget.h"

/// Mutates an input as libFuzzer does by itself; returns its new size.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzzTargets().front().run(data, size);
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
  const FuzzTarget& target = fuzzTargets().front();
  if (target.mutate == nullptr) return LLVMFuzzerMutate(data, size, maxSize);
  const std::string text = target.mutate({reinterpret_cast<const char*>(data), size}, seed);
  size = std::min(text.size(), maxSize);
  std::copy_n(text.begin(), size, data);
  return size;
}
