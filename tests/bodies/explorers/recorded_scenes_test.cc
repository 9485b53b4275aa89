#include "bodies/explorers/recorded_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bodies/objects/exploration_source.h"
#include "bodies/support/things.h"
#include "somato/bodies/object_table.h"
#include "somato/simulation/simulated_explorer.h"

namespace somato {
namespace {

// As a simulated hand would have recorded it; it did not move.
Exploration of_hand(const Object& object, std::size_t joints = 6) {
  Exploration exploration;
  exploration.labels = labels_of(object, 2);
  exploration.source = simulated_source("lucs2", "engine", 1, SimulatedThings::kBuiltIn);
  for (const auto& [name, elements] : {std::pair<const char*, std::size_t>{"height", 1},
                                       {"wrist", 1},
                                       {"joints", joints},
                                       {"touch", 45}}) {
    Channel channel;
    channel.name = name;
    channel.frames = Matrix<float>(3, elements);
    exploration.channels.push_back(std::move(channel));
  }
  return exploration;
}

// The geom that is shown before the hand; a geom of no size if there is none.
SceneGeom shown_object(const std::unique_ptr<ScenePlayer>& player) {
  if (player == nullptr) return {};
  const auto& geoms = player->scene().geoms;
  const auto found = std::find_if(geoms.begin(), geoms.end(), [](const SceneGeom& geom) {
    return geom.role == GeomRole::kObject;
  });
  return found == geoms.end() ? SceneGeom{} : *found;
}

bool shows_nothing(const std::unique_ptr<ScenePlayer>& player) {
  return player != nullptr && shown_object(player).size[0] == 0.0;
}

Object boule() {
  const auto objects = lucs2_objects(declared_materials()).value();
  return *std::find_if(objects.begin(), objects.end(),
                       [](const Object& object) { return object.name == "boule"; });
}

Object own_thing() {
  Object object = thing(Shape::kCylinder, 50, 50, 90);
  object.name = "my cup";
  return object;
}

TEST(RecordedScenes, ShowAKnownObject) {
  const SceneGeom shown = shown_object(recorded_scenes()(of_hand(boule())));
  EXPECT_EQ(shown.shape, GeomShape::kSphere);
  EXPECT_NEAR(shown.size[0], boule().size[0] / 2000.0, 1e-9);
}

TEST(RecordedScenes, ShowObjectsOfOnesOwn) {
  const Exploration recorded = of_hand(own_thing());
  EXPECT_TRUE(shows_nothing(recorded_scenes()(recorded)));
  const SceneGeom shown = shown_object(recorded_scenes({own_thing()})(recorded));
  EXPECT_NEAR(shown.size[1], 0.045, 1e-9);
}

TEST(RecordedScenes, TakeNoObjectForAnotherOfItsName) {
  Object other = own_thing();
  other.name = "boule";
  EXPECT_TRUE(shows_nothing(recorded_scenes()(of_hand(other))));
  const auto scenes = recorded_scenes({other});
  EXPECT_EQ(shown_object(scenes(of_hand(other))).shape, GeomShape::kCylinder);
  EXPECT_EQ(shown_object(scenes(of_hand(boule()))).shape, GeomShape::kSphere);
  Exploration named = of_hand(boule());
  named.labels.resize(1);
  EXPECT_EQ(shown_object(recorded_scenes()(named)).shape, GeomShape::kSphere);
}

TEST(RecordedScenes, ShowOnlyTheHandIfTheObjectDoesNotFit) {
  Object wall = thing(Shape::kBlock, 2000, 2000, 2000);
  wall.name = "wall";
  EXPECT_TRUE(shows_nothing(recorded_scenes({wall})(of_hand(wall, 11))));
}

// More than are kept: what was forgotten is built again, and is the same.
TEST(RecordedScenes, RememberHandsAndForgetThem) {
  std::vector<Object> many;
  for (int i = 0; i < 10; ++i) {
    many.push_back(thing(Shape::kBlock, 30.0 + i, 30, 60));
    many.back().name = "block " + std::to_string(i);
  }
  const auto scenes = recorded_scenes(many);
  for (int round = 0; round < 2; ++round) {
    for (const Object& object : many) {
      const auto player = scenes(of_hand(object));
      EXPECT_NEAR(shown_object(player).size[0], object.size[0] / 2000.0, 1e-9);
      EXPECT_EQ(player->poses(of_hand(object), 2).size(), player->scene().bodies.size());
    }
  }
}

TEST(RecordedScenes, ShowProbes) {
  const auto things = default_things(ExploringBody::kHardness).value();
  const auto explorer = simulated_explorer(ExploringBody::kHardness, things, {}, 1).value();
  const auto player = recorded_scenes()(explorer->explore(0, 0).value());
  ASSERT_TRUE(player);
  EXPECT_EQ(player->scene().bodies, (std::vector<std::string>{"stick"}));
}

// The names of objects say nothing about the objects of a device or of another simulation.
TEST(RecordedScenes, ShowBuiltInObjectsOnlyIfASimulatedHandExploredThem) {
  Exploration recorded = of_hand(boule());
  recorded.source = device_source("my hand");
  EXPECT_TRUE(shows_nothing(recorded_scenes()(recorded)));
  EXPECT_EQ(shown_object(recorded_scenes({boule()})(recorded)).shape, GeomShape::kSphere);
  recorded.source = simulated_source("lucs2", "engine", 1, SimulatedThings::kGiven);
  EXPECT_TRUE(shows_nothing(recorded_scenes()(recorded)));
}

// Another hand may have as many joints.
TEST(RecordedScenes, ShowNoHandForRecordingsOfOthers) {
  Exploration recorded = of_hand(boule());
  recorded.source = "trials/boule_1.csv";
  EXPECT_FALSE(recorded_scenes({boule()})(recorded));
}

TEST(RecordedScenes, KnowNothingOfOthers) {
  EXPECT_FALSE(recorded_scenes()({}));
  Exploration other = of_hand(boule(), 5);
  EXPECT_FALSE(recorded_scenes()(other));
}

}  // namespace
}  // namespace somato
