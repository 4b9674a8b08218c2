// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"
#include "simcore/world/LeftOut.h"

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace simcore {

class SdfSpec;

/// Checks the XML tree of an SDFormat file, upgraded to 1.9 if it is older, for what libsdformat accepts
/// silently or reports without a line: our own elements (robotcontrol:...) in wrong places, values of a wrong
/// type, numbers that are not finite; and everything that checkSdfNames() finds. Each error has file, line
/// and the path of the object.
///
/// Elements and attributes that SDFormat 1.9 does not define, or that the simulator does not have, are
/// removed from the tree and added to `leftOut`. Elements of other namespaces are ignored.
void checkSdfTree(tinyxml2::XMLDocument& document, const std::string& file, const SdfSpec& spec,
                  robotlink::Errors& errors, LeftOuts& leftOut);

/// Checks the models of a file, or of its world: repeated names, joints without ends, and impossible masses,
/// sizes, inertias, axes and frames. Wrong parts are removed or replaced by defaults, so that one error
/// does not cause others, and all are found at once.
void checkSdfNames(tinyxml2::XMLElement& root, const std::string& file, robotlink::Errors& errors,
                   LeftOuts& leftOut);

}  // namespace simcore
