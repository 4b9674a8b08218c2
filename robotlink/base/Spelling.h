// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robotlink {

/// The candidate that somebody who wrote `word` most likely meant (by edit distance, at most a third of the
/// word); empty if none is near. The first of equally near ones.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// "; did you mean 'ball-model'?", or, if nothing is near, "; there are a, b, c", or nothing if there are no
/// candidates.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace robotlink
