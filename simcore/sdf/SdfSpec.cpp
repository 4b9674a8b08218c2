// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfSpec.h"

#include <sdf/Console.hh>
#include <sdf/parser.hh>

#include "simcore/sdf/SdfDescription.h"

namespace simcore {

SdfSpec::SdfSpec() : description_(std::make_unique<SdfDescription>()) {
  // Everything that it prints is returned as an error, too.
  sdf::Console::Instance()->SetQuiet(true);
  description_->text = std::make_shared<sdf::SDF>();
  sdf::init(description_->text);
}

SdfSpec::~SdfSpec() = default;

const SdfSpec& SdfSpec::shared() {
  static const SdfSpec kSpec;
  return kSpec;
}

}  // namespace simcore
