// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

/// What a source file has that is listed as a fuzzing target in CMakeLists.txt. It lies in a namespace of its
/// own, since the targets of a program are compiled together. clang builds it with libFuzzer (preset "fuzz"),
/// and every build with FuzzDriver.cpp, which mutates the seeds randomly for the test suite.
struct FuzzTarget {
  /// The name that CMakeLists.txt has for it.
  const char* name;
  /// Returns valid and nearly valid inputs to begin with; generated, and the same at every call.
  std::vector<std::string> (*seeds)();
  /// Processes one input. Violated invariants end in std::abort(). Returns 0.
  int (*run)(const std::uint8_t* data, std::size_t size);
  /// Mutates an input, depending on `seed` alone, if most random mutations of its inputs would be refused at
  /// once.
  std::string (*mutate)(std::string input, unsigned seed) = nullptr;
  /// Called at the end of main(): ends what must not outlive main(), such as threads that draw. While the
  /// program exits, the libraries that they use are gone already.
  void (*end)() = nullptr;
};

/// The targets of this program; complete when main() begins.
inline std::vector<FuzzTarget>& fuzzTargets() {
  static std::vector<FuzzTarget> targets;
  return targets;
}

/// Adds a target to those of the program.
struct FuzzRegistration {
  explicit FuzzRegistration(const FuzzTarget& target) { fuzzTargets().push_back(target); }
};

/// Ends the program where something does not hold.
inline void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "not so: %s\n", what);
  std::abort();
}
