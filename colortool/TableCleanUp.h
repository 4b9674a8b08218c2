// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace colortool {

/// What is done to a table after it was learned.
struct CleanUpOptions {
  /// Connected cells of a class (of 26 neighbours) among which there is no sample of it become none.
  bool removeUnsupported = true;
  /// Cells of none that one class encloses become of it, unless background was sampled among them.
  bool fillHoles = true;
  bool operator==(const CleanUpOptions&) const = default;
};

}  // namespace colortool
