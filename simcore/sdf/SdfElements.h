// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to the sources that include libsdformat, whose headers take seconds to compile.
#pragma once

#include <filesystem>
#include <sdf/Element.hh>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace tinyxml2 {
class XMLElement;
}  // namespace tinyxml2

namespace simcore {

class SceneFiles;
class SdfSpec;

/// Builds libsdformat's tree of elements from checked XML. libsdformat's own parser copies the description of
/// everything that an element may contain for each element, which takes 35 ms per model; here descriptions
/// are shared. <include>s of models are replaced by the models that they name, as libsdformat does.
///
/// Errors: a model that includes itself, and models that would grow beyond kMaxElements, each of which takes
/// 1.7 KB while it is read.
class SdfElements {
 public:
  static constexpr std::size_t kMaxElements = 400'000;
  static constexpr std::size_t kMaxDepth = 24;

  SdfElements(const SceneFiles& files, const SdfSpec& spec, robotlink::Errors& errors)
      : files_(files), spec_(spec), errors_(errors) {}

  /// An <sdf> with one model of a file.
  sdf::ElementPtr modelRoot(const tinyxml2::XMLElement& model, const std::string& file);
  /// An <sdf> with a world; without models and includes unless `whole`.
  sdf::ElementPtr worldRoot(const tinyxml2::XMLElement& world, const std::string& file, bool whole);

 private:
  sdf::ElementPtr build(const tinyxml2::XMLElement& source, const sdf::ElementPtr& description,
                        const std::string& file);
  void addChildren(const tinyxml2::XMLElement& source, const sdf::ElementPtr& description,
                   sdf::Element& parent, const sdf::ElementPtr& shared, const std::string& file);
  sdf::ElementPtr buildIncluded(const tinyxml2::XMLElement& include, const std::string& file);
  sdf::ElementPtr root(const sdf::ElementPtr& content) const;

  const SceneFiles& files_;
  const SdfSpec& spec_;
  robotlink::Errors& errors_;
  std::size_t count_ = 0;
  /// Whether models and includes of the world are left to the caller.
  bool skipModels_ = false;
  std::vector<std::filesystem::path> open_;
};

}  // namespace simcore
