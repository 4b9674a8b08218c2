// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace simcore {

struct SdfDescription;

/// The definition of SDFormat 1.9 as libsdformat provides it: elements, attributes, types of values. Loading
/// it takes libsdformat longer than reading a scene, so a process loads it once. Immutable; for all threads.
class SdfSpec {
 public:
  /// Loads it at the first call; lives until the process ends.
  static const SdfSpec& shared();
  ~SdfSpec();
  SdfSpec(const SdfSpec&) = delete;
  SdfSpec& operator=(const SdfSpec&) = delete;

  /// For the sources that include libsdformat.
  const SdfDescription& description() const { return *description_; }

 private:
  SdfSpec();

  std::unique_ptr<SdfDescription> description_;
};

}  // namespace simcore
