// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotcontrol {
class FieldLinePercepts;
class OracleWorld;
}  // namespace robotcontrol

namespace robotlink {

struct FieldDescription;
struct PackageErrors;

/// Adds how far percepts of lines are from the lines and walls of the field as the true camera sees them.
/// Errors are distances to the nearest edge between green and white; a point or a segment too far from each
/// is invented. Each 0.1 m of an edge that is in the image and near counts as a thing that is there.
void compareLines(const robotcontrol::FieldLinePercepts& percepts, const robotcontrol::OracleWorld& truth,
                  const FieldDescription& field, PackageErrors& errors);

}  // namespace robotlink
