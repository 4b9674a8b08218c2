// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

/// Small MCAP files of many kinds: with and without compression, CRCs, chunks, summary; cut; and those of the
/// conformance suite, where its folder is at hand.
std::vector<std::string> mcapSeeds();
