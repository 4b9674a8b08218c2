// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace simcore {

struct SdfDescription;

/// The definition of SDFormat 1.9 as libsdformat provides it: elements, attributes, types of values. Loading
/// it takes libsdformat longer than reading a model, so a scene loads it once for all its files. Immutable.
class SdfSpec {
 public:
  SdfSpec();
  ~SdfSpec();
  SdfSpec(const SdfSpec&) = delete;
  SdfSpec& operator=(const SdfSpec&) = delete;

  /// For the sources that include libsdformat.
  const SdfDescription& description() const { return *description_; }

 private:
  std::unique_ptr<SdfDescription> description_;
};

}  // namespace simcore
