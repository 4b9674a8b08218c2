// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// A fuzzing target consists of one source file that defines both of these functions and is listed in
// CMakeLists.txt. It is built by clang with libFuzzer (preset "fuzz"), and in every build with
// FuzzDriver.cpp, which mutates the seeds randomly for the test suite.

/// Processes one input. Violated invariants end in std::abort(). Returns 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

/// Valid and nearly valid inputs to begin with; generated, and the same at every call.
std::vector<std::string> fuzzSeeds();

/// Mutates an input, depending on `seed` alone. A target may set it if most random mutations of its inputs
/// would be refused at once; it then defines LLVMFuzzerCustomMutator() for libFuzzer, too.
inline std::string (*fuzzMutation)(std::string input, unsigned seed) = nullptr;

/// Called at the end of main() if a target sets it: ends what must not outlive main(), such as threads that
/// draw. While the program exits, the libraries that they use are gone already.
inline void (*fuzzEnd)() = nullptr;
