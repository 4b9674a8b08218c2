// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/logplayer/mcap/Allocations.h"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> taken{0};
std::atomic<std::size_t> mostTaken{0};

/// Null: there is none.
void* take(std::size_t bytes) noexcept {
  void* const memory = std::malloc(bytes);
  if (memory == nullptr) return nullptr;
  const std::size_t now = taken += ::malloc_usable_size(memory);
  std::size_t most = mostTaken;
  while (now > most && !mostTaken.compare_exchange_weak(most, now)) {
  }
  return memory;
}

void* takeOrThrow(std::size_t bytes) {
  if (void* const memory = take(bytes)) return memory;
  throw std::bad_alloc();
}

void giveBack(void* memory) noexcept {
  if (memory != nullptr) taken -= ::malloc_usable_size(memory);
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t bytes) {
  return takeOrThrow(bytes);
}
void* operator new[](std::size_t bytes) {
  return takeOrThrow(bytes);
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return take(bytes);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
  return take(bytes);
}
void operator delete(void* memory) noexcept {
  giveBack(memory);
}
void operator delete[](void* memory) noexcept {
  giveBack(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  giveBack(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  giveBack(memory);
}

namespace logplayer::mcap::test {

LargestAllocation::LargestAllocation() : before_(taken) {
  mostTaken = before_;
}

std::size_t LargestAllocation::bytes() const {
  return mostTaken - std::min<std::size_t>(before_, mostTaken);
}

}  // namespace logplayer::mcap::test
