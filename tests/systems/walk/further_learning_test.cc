#include "somato/graph/further_learning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "base/archives/archive.h"
#include "base/support/damaged_files.h"
#include "base/support/temporary_folder.h"
#include "maps/support/saved_maps.h"
#include "recordings/support/made_recording.h"
#include "somato/core/check.h"
#include "somato/graph/system_model.h"
#include "systems/support/systems.h"
#include "systems/walk/model_of_first.h"

namespace somato {
namespace {

using testing::build;
using testing::module;
using testing::trained;
using testing::with_part;
using testing::without_part;
using StoredNumbers = std::vector<std::size_t>;

using testing::bytes_of_saved;
using testing::kKinds;
using testing::model_of_first;
using testing::range;
using testing::recording;
using testing::saved_and_loaded;
using testing::system_text;

// The law: saving between two objects changes nothing, in any part of the model.
TEST(FurtherLearning, IsTheSameAfterTheModelWasSaved) {
  const Recording all = recording();
  for (const std::string& kind : kKinds) {
    SystemModel kept = model_of_first(kind);
    SystemModel loaded = saved_and_loaded(kept);
    for (const std::size_t object : {1U, 2U}) {
      const StoredNumbers explorations = range(6 * object, 6 * object + 6);
      ASSERT_TRUE(learn_further(kept, all, explorations, {object + 5})) << kind;
      ASSERT_TRUE(learn_further(loaded, all, explorations, {object + 5})) << kind;
      EXPECT_EQ(bytes_of_saved(loaded), bytes_of_saved(kept)) << kind;
      loaded = saved_and_loaded(loaded);
    }
    EXPECT_NE(bytes_of_saved(kept), bytes_of_saved(model_of_first(kind))) << kind;
  }
}

// Objects are 300 apart, with noise of 8; each is named by a neuron that only it has won.
TEST(FurtherLearning, NamesObjectsThatCameOneAfterTheOther) {
  const Recording all = recording();
  SystemModel model = model_of_first("growing_when_required");
  ASSERT_TRUE(learn_further(model, all, range(6, 12), {6}));
  ASSERT_TRUE(learn_further(model, all, range(12, 18), {7}));
  SomWorkspace workspace;
  for (std::size_t i = 0; i < 18; ++i) {
    const auto input = testing::frames_of(all, "joints", i).row(0);
    const std::vector<float> copy(input.begin(), input.end());
    const std::size_t named =
        model.answer->labels.classify(*som_of(model.system, 2), SignalView::dense(copy), workspace);
    EXPECT_EQ(model.answer->classes[named], find_label(all.explorations[i], "object").value());
  }
}

TEST(FurtherLearning, GivesNewClassesAScale) {
  SystemModel model = model_of_first("growing_when_required");
  const std::size_t known = model.answer->classes.size();
  model.answer->novelty = Novelty{0.1, 20, 1.0, std::vector<double>(known, 3.0)};
  ASSERT_TRUE(learn_further(model, recording(), range(6, 12), {6}));
  EXPECT_GT(model.answer->classes.size(), known);
  EXPECT_EQ(model.answer->novelty->scales, std::vector<double>(model.answer->classes.size(), 3.0));
}

// With the input of a neuron's only vote as evidence: an origin says where a neuron was before.
TEST(FurtherLearning, OriginsAreTheNumbersOfTheSameNeurons) {
  const Recording all = recording();
  for (const std::string& kind : kKinds) {
    SystemModel model = model_of_first(kind);
    const Matrix<float> before = som_of(model.system, 2)->weights().to_matrix();
    Matrix<float> inputs(0, before.columns());
    for (std::size_t i = 6; i < 12; ++i) {
      const auto row = testing::frames_of(all, "joints", i).row(0);
      std::copy(row.begin(), row.end(), inputs.add_row().begin());
    }
    const auto origins = learn_further(model.system, 2, Samples(inputs), {9});
    ASSERT_TRUE(origins) << kind;
    ASSERT_EQ(origins->size(), som_of(model.system, 2)->neurons()) << kind;
    StoredNumbers known;
    for (const auto& origin : *origins) {
      if (origin) known.push_back(*origin);
    }
    EXPECT_TRUE(std::is_sorted(known.begin(), known.end())) << kind;
    EXPECT_EQ(std::adjacent_find(known.begin(), known.end()), known.end()) << kind;
    EXPECT_TRUE(known.empty() || known.back() < before.rows()) << kind;
    if (kind == "som") {
      EXPECT_EQ(known, range(0, 12));
    }
  }
}

TEST(FurtherLearning, LeavesTheModelAsItIsWhenItFails) {
  const Recording all = recording();
  for (const std::string& kind : kKinds) {
    SystemModel model = model_of_first(kind);
    FurtherLearning stopped;
    stopped.progress = [](std::uint64_t, std::uint64_t) { return false; };
    const auto interrupted = learn_further(model, all, range(6, 12), stopped);
    ASSERT_FALSE(interrupted) << kind;
    EXPECT_EQ(interrupted.error().kind, ErrorKind::kInterrupted) << kind;
    ASSERT_FALSE(learn_further(model, all, {}, {})) << kind;
    Recording unnamed = all;
    for (Exploration& exploration : unnamed.explorations) exploration.labels.clear();
    ASSERT_FALSE(learn_further(model, unnamed, range(6, 12), {})) << kind;
    EXPECT_EQ(bytes_of_saved(model), bytes_of_saved(model_of_first(kind))) << kind;
  }
  SystemModel unnamed{build(system_text("som"), all), {}};
  EXPECT_THROW((void)learn_further(unnamed, all, range(0, 6), {}), InvalidArgument);
  SystemModel model = model_of_first("som");
  EXPECT_THROW((void)learn_further(model, all, StoredNumbers{1, 2, 1}, {}), InvalidArgument);
}

// A file of an earlier version has no votes: each name counts once.
TEST(FurtherLearning, TakesNamesWithoutVotesAsOneVoteEach) {
  const Recording all = recording();
  SystemModel model = model_of_first("som");
  const NeuronLabels labels = model.answer->labels;
  model.answer->votes = {};
  model = saved_and_loaded(model);
  EXPECT_EQ(model.answer->votes.neurons(), 0U);
  ASSERT_TRUE(learn_further(model, all, range(6, 12), {6}));
  std::size_t votes = 0;
  for (std::size_t neuron = 0; neuron < 12; ++neuron) votes += model.answer->votes.of(neuron, 0);
  EXPECT_EQ(votes, labels.labelled().size());
}

Archive::Content counts(std::vector<std::int64_t> values) {
  const std::uint64_t size = values.size();
  return Array<std::int64_t>{{size}, std::move(values)};
}

// A damaged or hostile file can contain anything in the place of each part.
TEST(FurtherLearning, RefusesStatesThatDoNotFitTheMap) {
  const TemporaryFolder folder;
  const auto refuses = [&](const std::string& kind, const std::string& part,
                           const std::optional<Archive::Content>& content) {
    const SystemModel model = model_of_first(kind);
    const std::string path = folder.file("model");
    ASSERT_TRUE(save_system(path, model.system, model.answer));
    const Archive archive = load_archive(path).value();
    const std::string name = part == "votes" ? part : "module.map." + part;
    ASSERT_TRUE(archive.find(name)) << kind << " " << part;
    ASSERT_TRUE(save_archive(
        path, content ? with_part(archive, name, *content) : without_part(archive, name)));
    const auto loaded = load_system(path);
    ASSERT_FALSE(loaded) << kind << " " << part;
    EXPECT_EQ(loaded.error().kind, ErrorKind::kData) << kind << " " << part;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto neurons = som_of(model_of_first("growing_cells").system, 2)->neurons();
  for (const std::string kind : {"growing_when_required", "growing_cells", "growing_grid"}) {
    refuses(kind, kind == "growing_when_required" ? "habituation" : "counters", std::nullopt);
  }
  refuses("growing_when_required", "habituation", Array<double>{{1}, {nan}});
  refuses("growing_when_required", "ages", counts({51}));
  refuses("growing_when_required", "ages", counts({-1, 2}));
  refuses("growing_when_required", "graph", std::nullopt);
  refuses("growing_cells", "counters", Array<double>{{neurons}, std::vector<double>(neurons, nan)});
  refuses("growing_cells", "counters", Array<double>{{neurons}, std::vector<double>(neurons, -1)});
  refuses("growing_cells", "triangles", counts({0, 1, 1000000}));
  refuses("growing_cells", "triangles", counts({0, 1}));
  refuses("growing_cells", "triangles", counts({0, 2, 1}));
  refuses("growing_cells", "inputs", counts({-1}));
  refuses("growing_grid", "inputs", counts({5}));
  refuses("growing_grid", "counters", counts({1, 2, 3}));
  refuses("som", "votes", counts({1, 2}));
  refuses("som", "votes", Array<std::int64_t>{{12, 1}, std::vector<std::int64_t>(12, -1)});
  refuses("som", "votes", Array<std::int64_t>{{12, 1}, std::vector<std::int64_t>(12, 1)});
}

}  // namespace
}  // namespace somato
