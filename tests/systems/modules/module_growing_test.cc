// The modules that hold a GrowingMap, such as 'growing_when_required'.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/archives/archive.h"
#include "base/support/temporary_folder.h"
#include "somato/graph/further_learning.h"
#include "somato/graph/system_model.h"
#include "somato/graph/system_training.h"
#include "systems/support/systems.h"
#include "systems/walk/model_of_first.h"

namespace somato {
namespace {

using testing::build;
using testing::module;
using testing::recording;
using testing::trained;
using testing::try_build;

const std::vector<std::string> kGrowingKinds = testing::growing_kinds();

std::string growing(const std::string& kind, const std::string& settings = "") {
  return "[module.joints]\ntype = \"channel\"\nchannel = \"joints\"\n" +
         module("closed", "last", "input = \"joints\"\n") +
         module("map", kind, "input = \"closed\"\nmost_neurons = 12\n" + settings);
}

System trained_system(const std::string& kind, std::uint64_t seed = 3) {
  const Recording all = recording();
  return trained(build(growing(kind), all), all, 18, seed);
}

const Som& map_of(const System& system) {
  return *som_of(system, 2);
}

TEST(GrowingModule, GivesAnActivityOfConstantSize) {
  for (const std::string& kind : kGrowingKinds) {
    const System system = trained_system(kind);
    EXPECT_EQ(system.modules()[2].output.shape, (std::vector<std::size_t>{1, 12})) << kind;
    const Som& som = map_of(system);
    ASSERT_GT(som.neurons(), 2U);
    ASSERT_LE(som.neurons(), 12U);
    const Matrix<float> activity =
        testing::dense(testing::output_of(system, recording(), "map", 4));
    SomWorkspace workspace;
    std::vector<float> expected(som.neurons());
    som.activity(SignalView::dense(testing::frames_of(recording(), "joints", 4).row(0)), workspace,
                 expected);
    expected.resize(12, 0.0F);
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), activity.row(0).begin())) << kind;
  }
}

// Objects 300 apart, with noise of 8.
TEST(GrowingModule, SeparatesDistantObjects) {
  for (const std::string& kind : kGrowingKinds) {
    const System system = trained_system(kind);
    const Recording all = recording();
    std::vector<std::size_t> winners;
    for (std::size_t i = 0; i < 18; ++i) {
      winners.push_back(map_of(system).winner(testing::frames_of(all, "joints", i).row(0)));
    }
    for (std::size_t a = 0; a < 18; ++a) {
      for (std::size_t b = 0; b < 18; ++b) {
        if (a / 6 == b / 6) continue;
        EXPECT_NE(winners[a], winners[b]) << kind;
      }
    }
  }
}

TEST(GrowingModule, IsTheSameAfterItWasSaved) {
  const TemporaryFolder folder;
  for (const std::string& kind : kGrowingKinds) {
    const System system = trained_system(kind);
    const std::string path = folder.file(kind);
    ASSERT_TRUE(save_system(path, system, {}));
    const auto loaded = load_system(path);
    ASSERT_TRUE(loaded) << to_string(loaded.error());
    EXPECT_EQ(map_of(loaded->system).weights(), map_of(system).weights());
    EXPECT_EQ(map_of(loaded->system).grid(), map_of(system).grid());
    EXPECT_EQ(grid_of(loaded->system, 2), map_of(system).grid());
  }
}

TEST(GrowingModule, DependsOnTheSeed) {
  for (const std::string& kind : kGrowingKinds) {
    const System system = trained_system(kind, 3);
    EXPECT_EQ(map_of(trained_system(kind, 3)).weights(), map_of(system).weights()) << kind;
    EXPECT_FALSE(map_of(trained_system(kind, 4)).weights() == map_of(system).weights()) << kind;
  }
}

TEST(GrowingModule, HasARowOfItsMaximumSizeBeforeTraining) {
  const System system = build(growing("growing_cells"), recording());
  EXPECT_EQ(grid_of(system, 2), Grid(1, 12, Lattice::kRectangular, Topology::kPlane));
}

// A system that learns the names of three objects of six explorations.
Result<System> trained_by_names(const std::vector<std::size_t>& classes) {
  const Recording all = recording();
  System system = build(growing("growing_when_required", "by_names = true\n"), all);
  SystemTraining training{3};
  training.classes = classes;
  SOMATO_TRY_VOID(testing::try_train(system, all, 18, training));
  return system;
}

const std::vector<std::size_t> kThreeObjects{0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2};

TEST(GrowingModule, LearnsNamesAndNeedsThem) {
  const auto named = trained_by_names(kThreeObjects);
  ASSERT_TRUE(named) << to_string(named.error());
  EXPECT_GE(map_of(*named).neurons(), 3U);
  const auto refused = trained_by_names({});
  ASSERT_FALSE(refused);
  EXPECT_NE(to_string(refused.error()).find("by_names"), std::string::npos);
}

// Names, means and the unit are in the file: what follows is the same bits.
TEST(GrowingModule, LearnsFurtherByNamesAsIfItHadNotBeenSaved) {
  const TemporaryFolder folder;
  System kept = trained_by_names(kThreeObjects).value();
  ASSERT_TRUE(save_system(folder.file("a"), kept, {}));
  System loaded = load_system(folder.file("a")).value().system;
  Matrix<float> rows(4, map_of(kept).input_size());
  for (std::size_t i = 0; i < rows.values().size(); ++i) {
    rows.values()[i] = static_cast<float>(17 * i % 23);
  }
  FurtherLearning options;
  options.classes = {3, 0, 3, 1};
  for (System* system : {&kept, &loaded}) {
    ASSERT_TRUE(learn_further(*system, 2, Samples(rows), options));
  }
  EXPECT_EQ(map_of(loaded).weights(), map_of(kept).weights());
  EXPECT_EQ(map_of(loaded).grid(), map_of(kept).grid());
  ASSERT_TRUE(save_system(folder.file("b"), kept, {}));
  ASSERT_TRUE(save_system(folder.file("c"), loaded, {}));
  EXPECT_EQ(bytes_of(folder.file("c")), bytes_of(folder.file("b")));
}

// A file of an earlier version has no distances; its map learns on with the square root of the
// number of elements as the unit, like one that has it explicitly.
TEST(GrowingModule, AMapOfAnEarlierVersionKeepsItsUnit) {
  const TemporaryFolder folder;
  const Recording all = recording();
  const std::string unit = fmt::format(
      "distance_unit = {}\n",
      std::sqrt(static_cast<double>(map_of(trained_system("growing_when_required")).input_size())));
  System explicitly = trained(build(growing("growing_when_required", unit), all), all, 18, 3);
  ASSERT_TRUE(save_system(folder.file("a"), explicitly, {}));
  const Archive saved = load_archive(folder.file("a")).value();
  Archive earlier(saved.kind());
  for (const Archive::Entry& entry : saved.entries()) {
    Archive::Content content = entry.content;
    if (entry.name == "description") {
      auto& description = std::get<std::string>(content);
      const std::size_t line = description.find("distance_unit");
      description.erase(line, description.find('\n', line) + 1 - line);
    }
    earlier.add(entry.name, content);
  }
  ASSERT_TRUE(save_archive(folder.file("b"), earlier));
  auto loaded = load_system(folder.file("b"));
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  Matrix<float> rows(5, map_of(explicitly).input_size());
  for (std::size_t i = 0; i < rows.values().size(); ++i) {
    rows.values()[i] = static_cast<float>(31 * i % 47);
  }
  ASSERT_TRUE(learn_further(explicitly, 2, Samples(rows), {}));
  ASSERT_TRUE(learn_further(loaded->system, 2, Samples(rows), {}));
  EXPECT_EQ(map_of(loaded->system).weights(), map_of(explicitly).weights());
  ASSERT_TRUE(save_system(folder.file("c"), loaded->system, {}));
  EXPECT_EQ(load_archive(folder.file("c")).value().find("module.map.nearest_distances"), nullptr);
}

TEST(GrowingModule, RefusesSettingsThatItDoesNotHave) {
  const auto system = try_build(growing("growing_grid", "deletion_threshold = 0.1\n"), recording());
  ASSERT_FALSE(system);
  EXPECT_NE(to_string(system.error()).find("deletion_threshold"), std::string::npos);
}

}  // namespace
}  // namespace somato
