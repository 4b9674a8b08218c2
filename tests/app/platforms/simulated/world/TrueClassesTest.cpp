// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/TrueClasses.h"

#include <gtest/gtest.h>

#include "app/platforms/simulated/SimulatedRun.h"
#include "colortool/image/ClassPresets.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Conversions.h"
#include "simcore/world/RenderScene.h"

using namespace app;
using robotcontrol::KeyMode;

namespace {

constexpr char kPath[] = "oracle/classes";

robotcontrol::Request packageRequest(const std::string& package, KeyMode::Kind kind) {
  robotcontrol::Request request;
  request.set_robot("red1");
  request.mutable_set_key()->set_name("package/" + package);
  request.mutable_set_key()->mutable_mode()->set_kind(kind);
  return request;
}

/// A run and the images that its robot published.
struct Watched {
  std::map<std::string, std::vector<foxglove::RawImage>> images;  // by path
  std::unique_ptr<SimulatedRun> run;

  explicit Watched(RunOptions options = defaultSimulation()) {
    SimulatedRun::Listeners listeners;
    listeners.queue = [this](const std::string&, const auto& queue) {
      for (const auto& message : queue->messages) {
        if (const auto* image = message.template as<foxglove::RawImage>())
          images[message.path].push_back(*image);
      }
    };
    auto made = SimulatedRun::create(std::move(options), std::move(listeners));
    EXPECT_TRUE(made) << (made ? "" : robotlink::describe(made.error()));
    run = std::move(*made);
  }
  void ask(const std::string& package, KeyMode::Kind kind = KeyMode::ALWAYS) const {
    EXPECT_TRUE(run->request(packageRequest(package, kind)));
  }
  void play(double seconds) const {
    const robotlink::Instant end = run->world().clock().now() + robotlink::fromSeconds(seconds);
    while (run->world().clock().now() < end) run->step();
  }
};

std::uint8_t number(const char* name) {
  return colortool::findClassPreset("2002")->classes().index(name);
}

}  // namespace

TEST(TrueClasses, surfacesAreOfTheClassThatTheirColorIsNamedAfter) {
  simcore::RenderScene scene;
  scene.instances.emplace_back().colorName = "orange";
  scene.instances.back().color = {250, 215, 0};
  scene.instances.emplace_back().colorName = "carpet";
  const TrueClasses classes(scene);
  EXPECT_EQ(std::vector(classes.ofInstances().begin(), classes.ofInstances().end()),
            (std::vector<std::uint8_t>{number("orange"), TrueClasses::kBackground}));
}

TEST(TrueClasses, surfacesInAColorWithoutANameAreOfTheClassThatIsShownInIt) {
  simcore::RenderScene scene;
  for (const robotlink::Rgb color : {robotlink::Rgb{255, 105, 0}, {95, 88, 84}, {0, 130, 50}}) {
    scene.instances.emplace_back().color = color;
  }
  const TrueClasses classes(scene);
  EXPECT_EQ(std::vector(classes.ofInstances().begin(), classes.ofInstances().end()),
            (std::vector<std::uint8_t>{number("orange"), TrueClasses::kBackground, number("green")}));
}

TEST(TrueClasses, pairsOfTwoClassesAreIgnored) {
  robotlink::Image image(6, 2, robotlink::PixelFormat::kMono8);
  image.data = {1, 1, 1, 5, 5, 5, 0, 0, 5, 0, 0, 1};
  TrueClasses::ignoreMixedPairs(image);
  EXPECT_EQ(image.data, (std::vector<std::uint8_t>{1, 1, 255, 255, 5, 5, 0, 0, 255, 255, 255, 255}));
}

TEST(TrueClasses, areSentWithTheirImagesWhileAskedFor) {
  Watched watched;
  watched.ask("camera/image");
  watched.play(0.4);
  EXPECT_TRUE(watched.images[kPath].empty());
  watched.ask(kPath);
  watched.play(1);
  const auto& images = watched.images["camera/image"];
  const auto classes = watched.images[kPath];
  ASSERT_GE(classes.size(), 23U);
  for (const auto& image : classes) {
    EXPECT_EQ(image.encoding(), "mono8");
    EXPECT_EQ(image.data().size(), 176U * 144U);
    const auto same = std::ranges::find_if(images, [&](const auto& other) {
      return other.timestamp().nanos() == image.timestamp().nanos() &&
             other.timestamp().seconds() == image.timestamp().seconds();
    });
    ASSERT_NE(same, images.end()) << "an image of the same time";
    EXPECT_EQ(same->frame_id(), image.frame_id());
  }
  const std::string& first = classes.front().data();
  for (const char* name : {"orange", "green", "white", "skyblue"})
    EXPECT_GT(std::ranges::count(first, static_cast<char>(number(name))), 50) << name;
  watched.ask(kPath, KeyMode::OFF);
  watched.play(0.2);
  watched.images.clear();
  watched.play(0.4);
  EXPECT_TRUE(watched.images[kPath].empty());
}

TEST(TrueClasses, changeNothingInTheWorld) {
  Watched without, with;
  with.ask(kPath);
  without.play(1);
  with.play(1);
  EXPECT_EQ(without.run->world().digest(), with.run->world().digest());
}

TEST(TrueClasses, areAllTheSameInAnotherLight) {
  // Colors are not what the program sees: without it the robot would go elsewhere.
  RunOptions options = defaultSimulation();
  options.world.blackout = true;
  Watched usual(options);
  options.world.lighting = {0.4, 0.5};
  options.world.vignetting = simcore::LensVignetting{0.5, 0.2};
  Watched dim(options);
  for (Watched* watched : {&usual, &dim}) {
    watched->ask(kPath);
    watched->play(0.5);
  }
  ASSERT_FALSE(usual.images[kPath].empty());
  EXPECT_EQ(usual.images[kPath].back().data(), dim.images[kPath].back().data());
}

TEST(SimulatedLight, changesImagesFromTheNextOneOnAndSurvivesAReset) {
  Watched watched;
  watched.ask("camera/image");
  watched.play(0.3);
  const auto brightness = [&] {
    const std::string& bytes = watched.images["camera/image"].back().data();
    double sum = 0;
    for (std::size_t i = 0; i < bytes.size(); i += 2) sum += static_cast<std::uint8_t>(bytes[i]);
    return 2 * sum / static_cast<double>(bytes.size());
  };
  const double before = brightness();
  ASSERT_TRUE(watched.run->world().setLighting({0.5, 0}));
  watched.play(0.1);
  EXPECT_NEAR(brightness() / before, 0.5, 0.05);
  ASSERT_TRUE(watched.run->reset(1).empty());
  watched.play(0.3);
  EXPECT_NEAR(brightness() / before, 0.5, 0.05);
}

TEST(SimulatedLight, hasLimits) {
  Watched watched;
  for (const simcore::LightAdjustment& wrong :
       {simcore::LightAdjustment{-1, 0}, {11, 0}, {std::nan(""), 0}, {1, -1.5}, {1, std::nan("")}}) {
    const auto refused = watched.run->world().setLighting(wrong);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().id, "simulation.light");
  }
  EXPECT_EQ(watched.run->world().options().lighting, simcore::LightAdjustment());
}

TEST(SimulatedCamera, settingsChangeImagesAndSurviveAReset) {
  Watched watched;
  watched.ask("camera/image");
  watched.ask("camera/settings");
  watched.play(0.3);
  const auto set = [&](const char* setting, double value) {
    robotcontrol::Request request;
    request.set_robot("red1");
    request.mutable_set_camera()->set_setting(setting);
    request.mutable_set_camera()->set_value(value);
    return watched.run->request(request);
  };
  // Means of a channel, at a byte of the pixels' pairs.
  const auto mean = [&](std::size_t byte, std::size_t step) {
    const std::string& bytes = watched.images["camera/image"].back().data();
    double sum = 0;
    for (std::size_t i = byte; i < bytes.size(); i += step) sum += static_cast<std::uint8_t>(bytes[i]);
    return static_cast<double>(step) * sum / static_cast<double>(bytes.size());
  };
  const double luma = mean(0, 2), blue = mean(1, 4);
  ASSERT_TRUE(set("exposure", 0.5));
  watched.play(0.1);
  EXPECT_NEAR(mean(0, 2) / luma, 0.5, 0.05);
  ASSERT_TRUE(watched.run->reset(1).empty());
  watched.play(0.3);
  EXPECT_NEAR(mean(0, 2) / luma, 0.5, 0.05);
  ASSERT_TRUE(set("exposure", 1));
  ASSERT_TRUE(watched.run->world().setLighting({1, 0.5}));
  watched.play(0.1);
  EXPECT_LT(mean(1, 4), blue - 5) << "the light lacks blue";
  ASSERT_TRUE(set("white_balance", 0.5));
  watched.play(0.1);
  EXPECT_NEAR(mean(1, 4), blue, 1);
  for (const auto& [setting, value] : {std::pair("exposure", 5.0), {"gain", 0.0}, {"zoom", 1.0}})
    EXPECT_FALSE(set(setting, value)) << setting;
}
