// The modules 'growing_when_required', 'growing_cells' and 'growing_grid'.

#include <gtest/gtest.h>

#include <algorithm>

#include "base/support/temporary_folder.h"
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

const std::vector<std::string> kGrowingKinds{"growing_when_required", "growing_cells",
                                             "growing_grid"};

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

TEST(GrowingModule, RefusesSettingsThatItDoesNotHave) {
  const auto system = try_build(growing("growing_grid", "deletion_threshold = 0.1\n"), recording());
  ASSERT_FALSE(system);
  EXPECT_NE(to_string(system.error()).find("deletion_threshold"), std::string::npos);
}

}  // namespace
}  // namespace somato
