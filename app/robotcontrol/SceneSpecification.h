// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "widgets/sceneedit/SceneLanguage.h"

namespace simcore {
class SdfGlossary;
}

namespace app {

/// Gives the scene editor the simulator's specification of scene files. The specification is read on first
/// use, which takes some 50 ms.
class SceneSpecification final : public widgets::SceneLanguage {
 public:
  /// `folders` returns those in which models are searched first; called in any thread.
  explicit SceneSpecification(std::function<std::vector<std::filesystem::path>()> folders);
  ~SceneSpecification() override;
  std::vector<widgets::SceneElement> children(const Path& path) const override;
  std::optional<widgets::SceneElement> element(const Path& path) const override;
  std::vector<widgets::SceneProblem> check(const std::string& text,
                                           const std::filesystem::path& file) const override;
  std::vector<widgets::SceneModelChoice> models(const std::filesystem::path& file) const override;
  std::optional<std::filesystem::path> modelFile(const std::string& uri,
                                                 const std::filesystem::path& file) const override;
  robotlink::Result<std::string> withElement(const std::string& text, const std::filesystem::path& file,
                                             const std::vector<std::string>& element,
                                             const std::string& value) const override;
  robotlink::Result<std::string> newObject(const std::string& kind, const std::string& name, double x,
                                           double y, const std::filesystem::path& file) const override;
  robotlink::Result<std::string> newRoom(const widgets::RoomChoice& room,
                                         const std::filesystem::path& file) const override;

 private:
  const simcore::SdfGlossary& glossary() const;

  const std::function<std::vector<std::filesystem::path>()> folders_;
  mutable std::once_flag once_;
  /// Made once.
  mutable std::unique_ptr<simcore::SdfGlossary> glossary_;
};

}  // namespace app
