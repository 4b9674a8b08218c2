// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace simcore {

class SdfSpec;

/// Checks the tree of an SDFormat file for what libsdformat either accepts or reports without a line:
/// elements and attributes that SDFormat 1.9 does not know, our own elements (robotcontrol:...) in wrong
/// places, values of a wrong type, numbers that are not finite; and what checkSdfNames() finds. Older
/// versions, which libsdformat converts, are checked for names and our own elements only. Each error carries
/// file and line. Elements of other namespaces are left alone.
void checkSdfTree(const tinyxml2::XMLDocument& document, const std::string& file, const SdfSpec& spec,
                  robotlink::Errors& errors);

/// Checks the models of a file, or of its world: names that stand twice, joints whose links do not exist,
/// masses, sizes and inertias that no body has.
void checkSdfNames(const tinyxml2::XMLElement& root, const std::string& file, robotlink::Errors& errors);

}  // namespace simcore
