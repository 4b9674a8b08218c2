// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tinyxml2 {
class XMLDocument;
}  // namespace tinyxml2

namespace simcore {

/// The second number of an SDFormat version "1.N"; -1 if it is none.
int sdfMinorVersion(const std::string& version);
/// The versions that are read.
constexpr int kOldestSdf = 2, kNewestSdf = 12;

/// Rewrites a document of SDFormat 1.`minor` (kOldestSdf to 8) as one of 1.9. The changes between the
/// versions are described by the files *.convert of libsdformat; of these, the rules for elements that the
/// simulator reads are followed. libsdformat's own converter is not used because it takes 40 ms per model.
void upgradeSdf(tinyxml2::XMLDocument& document, int minor);

}  // namespace simcore
