// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/ModelSearch.h"

#include <gmock/gmock.h>

#include "tests/TestFolder.h"

namespace simcore {
namespace {

namespace fs = std::filesystem;
using testing::EndsWith;
using testing::HasSubstr;

class ModelSearchTest : public testing::Test {
 protected:
  ModelSearchTest() {
    // The temporary folder may be a link.
    root_ = fs::canonical(folder_.path());
  }
  /// What is found from the scene, relative to the temporary folder; "" if nothing is.
  std::string found(const std::optional<fs::path>& path) const {
    return path ? fs::relative(*path, root_).string() : "";
  }
  fs::path write(const std::string& name, const std::string& text = "x") const {
    return folder_.write(name, text);
  }

  const TestFolder folder_{TestFolder::Where::kMemory};
  fs::path root_;
  const fs::path scene_ = write("scenes/world.sdf");
};

TEST_F(ModelSearchTest, theFoldersThatAreGivenComeFirst) {
  write("mine/box/model.sdf");
  write("scenes/models/box/model.sdf");
  write("scenes/box/model.sdf");
  EXPECT_EQ(found(ModelSearch(scene_, {folder_ / "mine"}).find("model://box", scene_)), "mine/box");
  EXPECT_EQ(found(ModelSearch(scene_).find("model://box", scene_)), "scenes/box");
  fs::remove_all(folder_ / "scenes/box");
  EXPECT_EQ(found(ModelSearch(scene_).find("model://box", scene_)), "scenes/models/box");
  EXPECT_EQ(found(ModelSearch(scene_).find("package://box/model.sdf", scene_)),
            "scenes/models/box/model.sdf");
  EXPECT_EQ(found(ModelSearch(scene_).find("model://ball2", scene_)), "");
}

TEST_F(ModelSearchTest, aModelFindsItsOwnFilesAndItsNeighbors) {
  const fs::path model = write("library/arm/model.sdf");
  write("library/arm/meshes/hand.stl");
  write("library/table/model.sdf");
  const ModelSearch search(scene_);
  EXPECT_EQ(found(search.find("model://arm/meshes/hand.stl", model)), "library/arm/meshes/hand.stl");
  EXPECT_EQ(found(search.find("model://table", model)), "library/table");
  EXPECT_EQ(found(search.find("meshes/hand.stl", model)), "library/arm/meshes/hand.stl");
  EXPECT_EQ(found(search.find("file://meshes/hand.stl", model)), "library/arm/meshes/hand.stl");
  EXPECT_EQ(found(search.find("file://" + (root_ / "library/table").string(), model)), "library/table");
}

TEST_F(ModelSearchTest, theNetworkAndOtherSchemesAreNotSearched) {
  write("scenes/box/model.sdf");
  const ModelSearch search(scene_);
  for (const char* uri : {"", "http://box", "https://fuel.example/box", "ftp://box", "model:///etc/passwd"})
    EXPECT_FALSE(search.find(uri, scene_)) << uri;
  EXPECT_TRUE(isNetworkUri("https://a"));
  EXPECT_TRUE(isNetworkUri("http://a"));
  EXPECT_FALSE(isNetworkUri("model://a"));
}

TEST_F(ModelSearchTest, theEnvironmentNamesFolders) {
  write("shared/box/model.sdf");
  ASSERT_EQ(::setenv("SDF_PATH", ("/nowhere::" + (root_ / "shared").string()).c_str(), 1), 0);
  const ModelSearch search(scene_);
  ::unsetenv("SDF_PATH");
  EXPECT_EQ(found(search.find("model://box", scene_)), "shared/box");
  EXPECT_THAT(search.describe(), HasSubstr("/nowhere, " + (root_ / "shared").string()));
  EXPECT_FALSE(ModelSearch(scene_).find("model://box", scene_));
}

TEST_F(ModelSearchTest, theNewestFileThatAModelNamesIsTaken) {
  const auto modelFile = [&] { return found(ModelSearch(scene_).findModel("model://box", scene_)); };
  EXPECT_EQ(modelFile(), "");
  write("scenes/box/model.sdf");
  EXPECT_EQ(modelFile(), "scenes/box/model.sdf");
  for (const char* name : {"old.sdf", "new.sdf"}) write(std::string("scenes/box/") + name);
  write(
      "scenes/box/model.config",
      R"(<model><sdf version="1.4">old.sdf</sdf><sdf version="1.6"> new.sdf </sdf><sdf>model.sdf</sdf></model>)");
  EXPECT_EQ(modelFile(), "scenes/box/new.sdf");
  // One that is missing, or a file that cannot be read, does not matter.
  write("scenes/box/model.config", R"(<model><sdf version="1.9">gone.sdf</sdf></model>)");
  EXPECT_EQ(modelFile(), "scenes/box/model.sdf");
  write("scenes/box/model.config", "<model");
  EXPECT_EQ(modelFile(), "scenes/box/model.sdf");
}

TEST_F(ModelSearchTest, aFileIsAModelItselfAndAFolderWithoutOneIsNone) {
  write("scenes/box.sdf");
  fs::create_directories(folder_ / "scenes/empty");
  const ModelSearch search(scene_);
  EXPECT_EQ(found(search.findModel("box.sdf", scene_)), "scenes/box.sdf");
  EXPECT_FALSE(search.findModel("model://empty", scene_));
  EXPECT_TRUE(search.find("model://empty", scene_));
}

TEST_F(ModelSearchTest, robotsAreFoundByTheirKind) {
  const auto robot = [&](const std::string& folder, const std::string& prefix, const std::string& kind) {
    write("scenes/models/" + folder + "/model.sdf",
          "<sdf version='1.9' xmlns:" + prefix + "='urn:robotcontrol:sdf'><model name='m'><" + prefix +
              ":robot> " + kind + " </" + prefix + ":robot></model></sdf>");
  };
  robot("b", "robotcontrol", "rover");
  robot("a", "robotcontrol", "rover2");
  robot("c", "rc", "lander");
  write("scenes/models/aa/model.sdf", "<sdf><!-- <robotcontrol:robot>rover</robotcontrol:robot> --></sdf>");
  const ModelSearch search(scene_);
  EXPECT_EQ(found(search.findRobot("rover")), "scenes/models/b/model.sdf");
  EXPECT_EQ(found(search.findRobot("rover2")), "scenes/models/a/model.sdf");
  EXPECT_EQ(found(search.findRobot("lander")), "scenes/models/c/model.sdf") << "whatever its prefix is";
  EXPECT_FALSE(search.findRobot("rove"));
  // Those that are shipped are found in the end.
  const auto shipped = search.findRobot("ers210");
  ASSERT_TRUE(shipped);
  EXPECT_THAT(shipped->string(), EndsWith("model.sdf"));
}

}  // namespace
}  // namespace simcore
