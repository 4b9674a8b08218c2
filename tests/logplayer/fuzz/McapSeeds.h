// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

/// Small MCAP files of many kinds: with and without compression, CRCs, chunks, summary; truncated; and those
/// of the conformance suite, if its folder exists.
std::vector<std::string> mcapSeeds();
