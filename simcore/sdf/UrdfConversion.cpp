// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/UrdfConversion.h"

#include <exception>
#include <sdf/sdf.hh>

namespace simcore {

robotlink::Result<std::string> sdfOfUrdf(const std::string& text, const std::string& file) {
  const auto failed = [&](const std::string& reason) {
    return robotlink::failure("scene.urdf", "this URDF cannot be converted to SDFormat: " + reason,
                              {file, 1, 0});
  };
  try {
    const auto document = std::make_shared<sdf::SDF>();
    sdf::init(document);
    sdf::Errors errors;
    if (!sdf::readString(text, document, errors) || !document->Root()) {
      return failed(errors.empty() ? "libsdformat gives no reason" : errors.front().Message());
    }
    return document->Root()->ToString("");
  } catch (const std::exception& exception) {
    return failed(exception.what());
  }
}

}  // namespace simcore
