// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace simcore {

struct SdfDescription;

/// What SDFormat 1.9 consists of, as libsdformat describes it: elements, attributes, types of values. Reading
/// it takes libsdformat longer than reading a model, so a scene reads it once for all its files. Immutable.
class SdfSpec {
 public:
  SdfSpec();
  ~SdfSpec();
  SdfSpec(const SdfSpec&) = delete;
  SdfSpec& operator=(const SdfSpec&) = delete;

  /// For the sources that see libsdformat.
  const SdfDescription& description() const { return *description_; }

 private:
  std::unique_ptr<SdfDescription> description_;
};

}  // namespace simcore
