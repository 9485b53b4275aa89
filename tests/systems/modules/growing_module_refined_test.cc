// A map that grows by names, keeps a share of what it learns, and is refined by labels.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

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
using testing::try_build;

constexpr std::size_t kRefinedMap = 2;  // the number of the module
const std::vector<std::size_t> kSixOfThree{0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2};
const std::string kSharedByNames =
    "by_names = true\nmost_share = 0.34\nsimilarity = \"manhattan\"\nactivity_threshold = 0.22\n"
    "habituation_threshold = 2.0\ninsertion_share = 1.0\n";

std::string grown_by_names(const std::string& settings) {
  return "[module.joints]\ntype = \"channel\"\nchannel = \"joints\"\n" +
         module("closed", "last", "input = \"joints\"\n") +
         module("map", "growing_when_required", "input = \"closed\"\n" + settings);
}

Result<System> trained_with(const std::string& settings, const std::vector<std::size_t>& classes) {
  const Recording all = recording();
  System system = build(grown_by_names(settings), all);
  SystemTraining training{3};
  training.classes = classes;
  SOMATO_TRY_VOID(testing::try_train(system, all, 18, training));
  return system;
}

TEST(GrowingRefined, MovesTheNeuronsAndReportsTheOrder) {
  const System plain = trained_with(kSharedByNames, kSixOfThree).value();
  const System refined = trained_with(kSharedByNames + "refine = \"glvq\"\n", kSixOfThree).value();
  const Som& before = *som_of(plain, kRefinedMap);
  const Som& after = *som_of(refined, kRefinedMap);
  EXPECT_EQ(after.grid(), before.grid());
  EXPECT_LE(after.neurons(), 6U);  // 2 of 6 explorations of each object
  EXPECT_FALSE(after.weights() == before.weights());
  EXPECT_EQ(refined_order_of(plain, kRefinedMap), nullptr);
  const RefinedOrder* order = refined_order_of(refined, kRefinedMap);
  ASSERT_NE(order, nullptr);
  EXPECT_GT(order->before.quantization_error, 0.0);
  EXPECT_EQ(order->classes_without_neuron, 0U);
}

// The names, means, counted explorations and the unit are in the file.
TEST(GrowingRefined, LearnsFurtherAsIfItHadNotBeenSaved) {
  const TemporaryFolder folder;
  System kept = trained_with(kSharedByNames + "refine = \"glvq\"\n", kSixOfThree).value();
  ASSERT_TRUE(save_system(folder.file("a"), kept, {}));
  System loaded = load_system(folder.file("a")).value().system;
  Matrix<float> rows(9, som_of(kept, kRefinedMap)->input_size());
  for (std::size_t i = 0; i < rows.values().size(); ++i) {
    rows.values()[i] = static_cast<float>(17 * i % 23);
  }
  FurtherLearning options;
  options.classes = {3, 0, 3, 1, 3, 3, 3, 3, 0};
  const std::size_t before = som_of(kept, kRefinedMap)->neurons();
  for (System* system : {&kept, &loaded}) {
    ASSERT_TRUE(learn_further(*system, kRefinedMap, Samples(rows), options));
  }
  EXPECT_EQ(som_of(loaded, kRefinedMap)->weights(), som_of(kept, kRefinedMap)->weights());
  const std::size_t after = som_of(kept, kRefinedMap)->neurons();
  EXPECT_GT(after, before);
  EXPECT_LE(after, before + 2);  // 2 of the 6 of the new class; 0.34 * 8 and 0.34 * 7 are 2 as well
  ASSERT_TRUE(save_system(folder.file("b"), kept, {}));
  ASSERT_TRUE(save_system(folder.file("c"), loaded, {}));
  EXPECT_EQ(bytes_of(folder.file("c")), bytes_of(folder.file("b")));
}

std::string message_of(const std::string& settings) {
  const auto built = try_build(grown_by_names(settings), recording());
  return built ? "" : to_string(built.error());
}

TEST(GrowingRefined, RefusesWhatDoesNotFit) {
  EXPECT_NE(message_of("similarity = \"cosine\"\n").find("cosine"), std::string::npos);
  EXPECT_NE(message_of("refine = \"glvq\"\n").find("by_names = true"), std::string::npos);
  EXPECT_NE(message_of("most_share = 0.3\n").find("by_names is false"), std::string::npos);
  EXPECT_NE(message_of("by_names = true\nrefine_passes = 3\n").find("refine is none"),
            std::string::npos);
  EXPECT_NE(message_of("by_names = true\nmost_share = 1.5\n"), "");
  EXPECT_EQ(message_of(kSharedByNames + "refine = \"glvq\"\nrefine_passes = 3\n"), "");
}

// A refinement of one object has nothing to separate, and says so.
TEST(GrowingRefined, NeedsTwoClasses) {
  const auto one =
      trained_with(kSharedByNames + "refine = \"glvq\"\n", std::vector<std::size_t>(18, 0));
  ASSERT_FALSE(one);
  EXPECT_NE(to_string(one.error()).find("two classes"), std::string::npos);
}

}  // namespace
}  // namespace somato
