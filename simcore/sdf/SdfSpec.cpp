// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfSpec.h"

#include <sdf/Console.hh>
#include <sdf/parser.hh>

#include "simcore/sdf/SdfSpecImplementation.h"

namespace simcore {

SdfSpec::SdfSpec() : implementation_(std::make_unique<Implementation>()) {
  // Everything that it prints is returned as an error, too.
  sdf::Console::Instance()->SetQuiet(true);
  implementation_->description = std::make_shared<sdf::SDF>();
  sdf::init(implementation_->description);
}

SdfSpec::~SdfSpec() = default;

}  // namespace simcore
