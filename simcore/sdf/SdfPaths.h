// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tinyxml2 {
class XMLElement;
}  // namespace tinyxml2

namespace simcore {

/// The names of an element and of those that contain it, with slashes: "world/robot/arm/skin". Elements
/// without a name are omitted; empty if none has a name.
std::string objectPath(const tinyxml2::XMLElement& element);

/// The line of an element in its file, also of one that was converted (setSourceLine()).
int sourceLine(const tinyxml2::XMLElement& element);
/// Says in which line of its file an element is that was made from something there.
void setSourceLine(tinyxml2::XMLElement& element, int line);

/// The text directly in an element, without white space around it; empty for null.
std::string trimmedText(const tinyxml2::XMLElement* element);
/// The text of a child element; empty if there is none.
std::string childText(const tinyxml2::XMLElement& element, const char* name);
/// The attribute `name`; empty if there is none.
std::string nameOf(const tinyxml2::XMLElement& element);
/// Whether the text means true.
bool isTrue(const std::string& text);
/// Whether it means true or false.
bool isBool(const std::string& text);
/// The text directly in an element, in words.
std::vector<std::string> wordsOf(const tinyxml2::XMLElement& element);
bool isFiniteNumber(const std::string& word);
/// Whether a <pose> has a quaternion, x y z w, instead of three angles.
bool hasQuaternion(const tinyxml2::XMLElement& pose);
/// Returns a <pose>, also one in degrees or with a quaternion: x y z roll pitch yaw, m and rad. Nothing if
/// the number of its numbers is wrong.
std::optional<std::array<double, 6>> poseIn(const tinyxml2::XMLElement& pose);
/// A <robotcontrol:layout> of a file: names stay, paths (with a slash or .yaml) are those from the file's
/// folder.
std::string layoutIn(const std::string& text, const std::filesystem::path& file);

}  // namespace simcore
