#include "systems/modules/som_module.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/support/temporary_folder.h"
#include "recordings/support/made_recording.h"
#include "somato/graph/further_learning.h"
#include "somato/graph/system_model.h"
#include "somato/graph/system_training.h"
#include "somato/maps/refinement.h"
#include "systems/support/systems.h"

namespace somato {
namespace {

std::string refined_text(const std::string& settings) {
  return testing::channels({"joints"}) + testing::module("closed", "last", "input = \"joints\"\n") +
         testing::module(
             "map", "som",
             "input = \"closed\"\nrows = 3\ncolumns = 3\niterations = 200\n" + settings);
}

const std::string kRefine = "refine = \"glvq\"\nrefine_passes = 5\n";

Result<void> train_all(System& system, const Recording& recording,
                       const std::vector<std::size_t>& classes) {
  std::vector<std::size_t> all(recording.explorations.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  Activations activations(system.modules().size(), all.size());
  SystemTraining training;
  training.classes = classes;
  return train_system(system, recording, all, training, activations);
}

std::vector<std::size_t> classes_by_turns(std::size_t count) {
  std::vector<std::size_t> classes;
  for (std::size_t i = 0; i < count; ++i) classes.push_back(i % 2);
  return classes;
}

TEST(SomRefinement, IsThatOfTheTrainedMap) {
  const Recording recording = testing::hand_recording(12, 4);
  const auto classes = classes_by_turns(12);
  System plain = testing::build(refined_text(""), recording);
  System refined = testing::build(refined_text(kRefine), recording);
  ASSERT_TRUE(train_all(plain, recording, classes));
  ASSERT_TRUE(train_all(refined, recording, classes));
  Matrix<float> last(12, 3);
  for (std::size_t i = 0; i < 12; ++i) {
    const Matrix<float>& frames = testing::frames_of(recording, "joints", i);
    for (std::size_t d = 0; d < 3; ++d) last(i, d) = frames(frames.rows() - 1, d);
  }
  RefinementParameters parameters;
  parameters.refine = Refinement::kGlvq;
  parameters.refine_passes = 5;
  const auto expected =
      refine_som(*som_of(plain, 2), Samples(last), {classes.begin(), classes.end()}, parameters);
  EXPECT_EQ(som_of(refined, 2)->weights(), expected->som.weights());
  EXPECT_NE(som_of(refined, 2)->weights(), som_of(plain, 2)->weights());
  ASSERT_NE(refined_order_of(refined, 2), nullptr);
  EXPECT_EQ(refined_order_of(refined, 2)->after.topographic_error,
            expected->order.after.topographic_error);
  EXPECT_EQ(refined_order_of(plain, 2), nullptr);
}

TEST(SomRefinement, RelevancesAreSavedAndLoaded) {
  const Recording recording = testing::hand_recording(12, 4);
  System system = testing::build(refined_text("refine = \"grlvq\"\n"), recording);
  ASSERT_TRUE(train_all(system, recording, classes_by_turns(12)));
  const std::vector<double>& relevances = som_of(system, 2)->parameters().relevances;
  EXPECT_EQ(relevances.size(), 3U);
  const TemporaryFolder folder;
  ASSERT_TRUE(save_system(folder.file("model"), system));
  const SystemModel loaded = testing::value_or_throw(load_system(folder.file("model")));
  EXPECT_EQ(som_of(loaded.system, 2)->parameters().relevances, relevances);
  EXPECT_EQ(som_of(loaded.system, 2)->weights(), som_of(system, 2)->weights());
}

TEST(SomRefinement, ARefinedSystemIsSavedAndLoaded) {
  const Recording recording = testing::hand_recording(12, 4);
  System system = testing::build(refined_text(kRefine), recording);
  ASSERT_TRUE(train_all(system, recording, classes_by_turns(12)));
  const TemporaryFolder folder;
  ASSERT_TRUE(save_system(folder.file("model"), system));
  const SystemModel loaded = testing::value_or_throw(load_system(folder.file("model")));
  EXPECT_EQ(som_of(loaded.system, 2)->weights(), som_of(system, 2)->weights());
  EXPECT_EQ(refined_order_of(loaded.system, 2), nullptr);
}

TEST(SomRefinement, NeedsClasses) {
  const Recording recording = testing::hand_recording(12, 4);
  System system = testing::build(refined_text(kRefine), recording);
  const auto trained = train_all(system, recording, {});
  ASSERT_FALSE(trained);
  EXPECT_EQ(trained.error().kind, ErrorKind::kUsage);
  EXPECT_NE(trained.error().what.find("refined by labels"), std::string::npos);
}

TEST(SomRefinement, CannotLearnFurther) {
  const Recording recording = testing::hand_recording(12, 4);
  System system = testing::build(refined_text(kRefine), recording);
  ASSERT_TRUE(train_all(system, recording, classes_by_turns(12)));
  const LaneMatrix<float> before = som_of(system, 2)->weights();
  const auto learned = learn_further(system, 2, Samples(Matrix<float>(2, 3, 0.5F)), {});
  ASSERT_FALSE(learned);
  EXPECT_EQ(learned.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(som_of(system, 2)->weights(), before);
}

TEST(SomRefinement, IsRefusedForFramesAndOtherDistances) {
  const Recording recording = testing::hand_recording(12, 4);
  const std::string of_frames =
      testing::channels({"joints"}) +
      testing::module("map", "som", "input = \"joints\"\nrows = 2\ncolumns = 2\n" + kRefine);
  System system = testing::build(of_frames, recording);
  EXPECT_EQ(train_all(system, recording, classes_by_turns(12)).error().kind, ErrorKind::kUsage);
  for (const std::string settings :
       {"similarity = \"cosine\"\nrefine = \"glvq\"\n", "refine_passes = 3\n"}) {
    const auto built = testing::try_build(refined_text(settings), recording);
    ASSERT_FALSE(built) << settings;
    EXPECT_EQ(built.error().kind, ErrorKind::kUsage);
    EXPECT_NE(to_string(built.error()).find("refine"), std::string::npos);
  }
}

}  // namespace
}  // namespace somato
