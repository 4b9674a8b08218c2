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

/// Checks the XML tree of an SDFormat file for what libsdformat accepts silently or reports without a line:
/// elements and attributes that SDFormat 1.9 does not define, our own elements (robotcontrol:...) in wrong
/// places, values of a wrong type, numbers that are not finite; and everything that checkSdfNames() finds.
/// Files of older versions, which libsdformat converts, are checked only for names and our own elements. Each
/// error has file and line. Elements of other namespaces are ignored.
void checkSdfTree(const tinyxml2::XMLDocument& document, const std::string& file, const SdfSpec& spec,
                  robotlink::Errors& errors);

/// Checks the models of a file, or of its world: repeated names, joints of unknown links, and impossible
/// masses, sizes and inertias.
void checkSdfNames(const tinyxml2::XMLElement& root, const std::string& file, robotlink::Errors& errors);

}  // namespace simcore
