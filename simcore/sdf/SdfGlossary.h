// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace simcore {

class SdfSpec;

/// An attribute as SDFormat defines it.
struct SdfAttribute {
  /// The type of its value ("string", "bool", "double", ...), and its default as text.
  std::string name, type, initial;
  std::string help;
  bool required = false;
};

/// An element as SDFormat defines it, or one of our own (robotcontrol:...).
struct SdfElementHelp {
  std::string name;
  /// Type and default of its value ("double", "pose", "vector3", ...); empty if it has none, but children.
  std::string type, initial;
  std::string help;
  bool required = false;
  /// Whether there may be several of it in its parent.
  bool repeated = false;
  std::vector<SdfAttribute> attributes;
};

/// Returns our own element in an element of this name; nothing if it may not be there.
std::optional<SdfElementHelp> ownSdfElement(const std::string& name, const std::string& parent);

/// Describes which elements are allowed where in a scene file: libsdformat's definition of SDFormat 1.9 and
/// our own elements. For editors; immutable, so any thread may ask.
class SdfGlossary {
 public:
  /// The names of elements from the root on: {"sdf", "world", "model"}. Empty: outside of all.
  using Path = std::vector<std::string>;

  SdfGlossary();
  ~SdfGlossary();
  SdfGlossary(const SdfGlossary&) = delete;
  SdfGlossary& operator=(const SdfGlossary&) = delete;

  /// The elements that may be in the last one of the path, SDFormat's in its order before our own; empty if
  /// there are none or the path makes no sense.
  std::vector<SdfElementHelp> children(const Path& path) const;
  /// The last element of the path; nothing if it may not be there.
  std::optional<SdfElementHelp> element(const Path& path) const;

 private:
  const SdfSpec& spec_;
};

}  // namespace simcore
