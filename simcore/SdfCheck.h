// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"

namespace tinyxml2 {
class XMLDocument;
}

namespace simcore {

/// Checks what libsdformat either accepts or reports without a line: elements and attributes that
/// SDFormat 1.9 does not know, our own elements in wrong places, numbers that are none or not finite, names
/// that stand twice, joints whose links do not exist. Each error carries file and line.
void checkSdfTree(const tinyxml2::XMLDocument& document, const std::string& file, robotlink::Errors& errors);

}  // namespace simcore
