// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tinyxml2 {
class XMLElement;
}  // namespace tinyxml2

namespace simcore {

/// The prefix of our own elements in the tree; files may bind another one to the namespace.
inline constexpr std::string_view kOwnPrefix = "robotcontrol:";

/// Gives the elements of the namespace urn:robotcontrol:sdf our prefix, whatever prefix the file has bound to
/// it.
void useOwnPrefix(tinyxml2::XMLElement& root);

/// The problem with one of our own elements.
struct OwnProblem {
  const char* id;
  std::string text;
  /// Whether the element has a meaning where it is.
  bool isKnown = true;
  /// Whether it can be left out, since what it is in has a meaning without it.
  bool canBeLeftOut = false;
};

/// Checks one of our own elements, but not what is in it: its place, its attributes, its value, and whether
/// it is the only one.
std::vector<OwnProblem> problemsOfOwnElement(const tinyxml2::XMLElement& element);

/// All elements of our own namespace, each with an element that it may be in.
std::vector<std::pair<std::string, std::string>> ownSdfElements();

}  // namespace simcore
