// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robotlink {

/// Returns the candidate that `word` is most likely a misspelling of: the first one with the smallest edit
/// distance, at most a third of the word's length (at least 1). Empty if none is that near.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// The end of an error message about an unknown name: "; did you mean 'ball-model'?" or, if nothing is near,
/// the list of candidates "; there are a, b, c". Empty if there are no candidates.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace robotlink
