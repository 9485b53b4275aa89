#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "somato/core/check.h"
#include "somato/core/random.h"
#include "somato/graph/further_learning.h"
#include "somato/graph/system_model.h"
#include "systems/walk/model_of_first.h"

namespace somato {
namespace {

using testing::bytes_of_saved;
using testing::kKinds;
using testing::map_of;
using testing::model_of_first;
using testing::recording;

// An exploration of the last object, which no model of the first one has learned.
constexpr std::size_t kNew = 15;

std::vector<float> input_of(const Recording& all, std::size_t exploration) {
  const auto row = testing::frames_of(all, "joints", exploration).row(0);
  return {row.begin(), row.end()};
}

// The obvious search for the nearest named neuron.
std::string named(const SystemModel& model, const std::vector<float>& input) {
  const Som& som = map_of(model);
  SomWorkspace workspace;
  std::optional<std::size_t> nearest;
  double least = 0.0;
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    if (!model.answer->labels[neuron]) continue;
    const double distance = som.distance(SignalView::dense(input), neuron, workspace);
    if (!nearest || distance < least) {
      nearest = neuron;
      least = distance;
    }
  }
  return model.answer->classes[*model.answer->labels[*nearest]];
}

TEST(Teaching, NamesTheExploration) {
  const Recording all = recording();
  for (const std::string& kind : kKinds) {
    SystemModel model = model_of_first(kind);
    const auto taught = teach(model, all, kNew, "cup");
    ASSERT_TRUE(taught) << kind << ": " << to_string(taught.error());
    EXPECT_EQ(taught->before, "object 1") << kind;
    ASSERT_TRUE(taught->neuron) << kind;
    EXPECT_EQ(named(model, input_of(all, kNew)), "cup") << kind;
    EXPECT_EQ(model.answer->classes, (std::vector<std::string>{"object 1", "cup"})) << kind;
  }
}

// The law: named neurons keep weights and names, so that answers change near the new neuron only.
TEST(Teaching, ChangesNoNamedNeuron) {
  const Recording all = recording();
  Random random(8);
  for (const std::string& kind : kKinds) {
    const SystemModel before = model_of_first(kind);
    SystemModel model = model_of_first(kind);
    const std::size_t neuron = teach(model, all, kNew, "cup")->neuron.value();
    const Matrix<float> weights = map_of(before).weights().to_matrix();
    const Matrix<float> after = map_of(model).weights().to_matrix();
    for (std::size_t one = 0; one < weights.rows(); ++one) {
      if (one == neuron) continue;
      EXPECT_TRUE(std::ranges::equal(after.row(one), weights.row(one))) << kind << " " << one;
      EXPECT_EQ(model.answer->labels[one], before.answer->labels[one]) << kind << " " << one;
    }
    EXPECT_TRUE(neuron == weights.rows() || !before.answer->labels[neuron]) << kind;
    SomWorkspace workspace;
    for (int i = 0; i < 200; ++i) {
      std::vector<float> input;
      for (int joint = 0; joint < 3; ++joint) {
        input.push_back(static_cast<float>(800.0 * random.uniform() - 100.0));
      }
      const std::size_t winner = map_of(model).winner_among(model.answer->labels.labelled(),
                                                            SignalView::dense(input), workspace);
      EXPECT_EQ(named(model, input), winner == neuron ? "cup" : named(before, input)) << kind;
    }
  }
}

TEST(Teaching, CountsANameThatWasKnown) {
  const Recording all = recording();
  for (const std::string& kind : kKinds) {
    SystemModel model = model_of_first(kind);
    const std::size_t votes = [&] {
      SomWorkspace workspace;
      const std::vector<float> input = input_of(all, 2);
      const std::size_t neuron = map_of(model).winner_among(model.answer->labels.labelled(),
                                                            SignalView::dense(input), workspace);
      const std::size_t count = model.answer->votes.of(neuron, 0);
      const auto taught = teach(model, all, 2, "object 1");
      EXPECT_TRUE(taught && taught->before == "object 1" && !taught->neuron) << kind;
      return model.answer->votes.of(neuron, 0) - count;
    }();
    EXPECT_EQ(votes, 1U) << kind;
    EXPECT_EQ(map_of(model).weights().to_matrix(),
              map_of(model_of_first(kind)).weights().to_matrix())
        << kind;
  }
}

TEST(Teaching, RenamesAnExplorationThatIsTheWeightOfANeuron) {
  const Recording all = recording();
  for (const std::string& kind : kKinds) {
    SystemModel model = model_of_first(kind);
    const auto first = teach(model, all, kNew, "cup");
    ASSERT_TRUE(teach(model, all, kNew, "cup"));
    const auto second = teach(model, all, kNew, "mug");
    ASSERT_TRUE(second) << kind;
    EXPECT_EQ(second->before, "cup") << kind;
    EXPECT_EQ(second->neuron, first->neuron) << kind;
    EXPECT_EQ(named(model, input_of(all, kNew)), "mug") << kind;
  }
}

TEST(Teaching, MakesAnUnknownExplorationKnown) {
  const Recording all = recording();
  for (const std::string& kind : kKinds) {
    SystemModel model = model_of_first(kind);
    model.answer->novelty = Novelty{0.1, 20, 1.0, {3.0}};
    EXPECT_EQ(teach(model, all, kNew, "cup")->before, "unknown") << kind;
    EXPECT_EQ(model.answer->novelty->scales, (std::vector<double>{3.0, 3.0})) << kind;
    EXPECT_EQ(teach(model, all, kNew, "cup")->before, "cup") << kind;
  }
}

TEST(Teaching, GivesACopyTheSameBits) {
  const Recording all = recording();
  for (const std::string& kind : kKinds) {
    SystemModel model = model_of_first(kind);
    SystemModel copy = copy_of(model);
    EXPECT_EQ(bytes_of_saved(copy), bytes_of_saved(model)) << kind;
    ASSERT_TRUE(teach(model, all, kNew, "cup"));
    EXPECT_NE(bytes_of_saved(copy), bytes_of_saved(model)) << kind;
    ASSERT_TRUE(teach(copy, all, kNew, "cup"));
    EXPECT_EQ(bytes_of_saved(copy), bytes_of_saved(model)) << kind;
    EXPECT_EQ(bytes_of_saved(testing::saved_and_loaded(model)), bytes_of_saved(model)) << kind;
  }
}

TEST(Teaching, LeavesTheModelAsItIsWhenItFails) {
  Recording all = recording();
  all.explorations.push_back(testing::exploration_of("short", {1.0F}));
  for (const std::string& kind : kKinds) {
    SystemModel model = model_of_first(kind);
    for (const std::string& name :
         {std::string(), std::string("unknown"), std::string("  "), std::string("two\nlines"),
          std::string(256, 'a'), std::string("nul\0", 4), std::string("\xFF")}) {
      const auto refused = teach(model, all, kNew, name);
      ASSERT_FALSE(refused) << kind;
      EXPECT_EQ(refused.error().kind, ErrorKind::kUsage) << kind;
    }
    EXPECT_FALSE(teach(model, all, all.explorations.size() - 1, "short")) << kind;
    EXPECT_EQ(bytes_of_saved(model), bytes_of_saved(model_of_first(kind))) << kind;
  }
  SystemModel unnamed{testing::build(testing::system_text("som"), all), {}};
  EXPECT_THROW((void)teach(unnamed, all, 0, "cup"), InvalidArgument);
}

// Of 12 neurons each, of a map that cannot grow further.
TEST(Teaching, EndsWhenAllNeuronsHaveNames) {
  Recording all = recording();
  for (const std::string& kind : kKinds) {
    SystemModel model = model_of_first(kind);
    std::size_t learned = 0;
    for (; learned <= 12; ++learned) {
      const float place = 1000.0F * static_cast<float>(learned + 1);
      all.explorations.push_back(testing::exploration_of("far", {place, 0.0F, place}));
      const std::string before = bytes_of_saved(model);
      const auto taught = teach(model, all, all.explorations.size() - 1, std::to_string(learned));
      if (taught) continue;
      EXPECT_EQ(taught.error().what, "all neurons of the map have names") << kind;
      EXPECT_EQ(bytes_of_saved(model), before) << kind;
      break;
    }
    EXPECT_EQ(model.answer->labels.labelled().size(), map_of(model).neurons()) << kind;
    EXPECT_EQ(kind == "som" || kind == "growing_when_required" ? map_of(model).neurons() : 12U, 12U)
        << kind;
  }
}

}  // namespace
}  // namespace somato
