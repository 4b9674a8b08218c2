// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// What a fuzzing target consists of: one source file that defines both of these, listed in CMakeLists.txt.
// Built by clang with libFuzzer (preset "fuzz"), and in every build by FuzzDriver.cpp, which mutates the
// seeds at random for the test suite.

/// Feeds one input to what is fuzzed. What must never be ends in std::abort(). Yields 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

/// Good and nearly good inputs to begin with; the same at every call. Made anew, so that no files lie about.
std::vector<std::string> fuzzSeeds();
