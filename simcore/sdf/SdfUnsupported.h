// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tinyxml2 {
class XMLElement;
}  // namespace tinyxml2

namespace simcore {

/// What becomes of an element that SDFormat defines and the simulator does not have.
struct Unsupported {
  /// The consequence, for users; null if the element is supported, or means nothing here.
  const char* why = nullptr;
  /// Whether it is removed together with everything in it, unread.
  bool removed = false;
};

/// Looks an element up in the table of what is not supported. Elements whose value says that they change
/// nothing ("self_collide" false) are not reported.
Unsupported unsupported(const tinyxml2::XMLElement& element);

}  // namespace simcore
