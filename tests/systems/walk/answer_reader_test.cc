#include "systems/walk/answer_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "somato/core/check.h"
#include "somato/core/random.h"
#include "somato/graph/further_learning.h"
#include "systems/walk/model_of_first.h"

namespace somato {
namespace {

using testing::map_of;
using testing::recording;

SystemModel three_names(const std::string& kind) {
  SystemModel model = testing::model_of_first(kind);
  EXPECT_TRUE(teach(model, recording(), 15, "cup"));
  EXPECT_TRUE(teach(model, recording(), 9, "jar"));
  model.answer->novelty = Novelty{0.1, 9, 0.8, {20.0, 50.0, 30.0}};
  return model;
}

double least_distance(const SystemModel& model, std::size_t number, const SignalView& input) {
  const Som& som = map_of(model);
  double least = std::numeric_limits<double>::infinity();
  SomWorkspace workspace;
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    if (model.answer->labels[neuron] != number) continue;
    least = std::min(least, som.distance(input, neuron, workspace));
  }
  return least;
}

TEST(AnswerReader, OrdersClassesByTheirNearestNeurons) {
  Random random(8);
  for (const std::string& kind : testing::kKinds) {
    const SystemModel model = three_names(kind);
    const AnswerReader reader(model);
    for (int trial = 0; trial < 30; ++trial) {
      std::vector<float> values(map_of(model).input_size());
      for (float& value : values) value = static_cast<float>(60.0 * random.uniform());
      const SignalView input = SignalView::dense(values);
      const std::vector<NearestOfClass> classes = reader.classes(input);
      ASSERT_EQ(classes.size(), model.answer->classes.size()) << kind;
      SomWorkspace workspace;
      for (std::size_t i = 0; i < classes.size(); ++i) {
        const NearestOfClass& one = classes[i];
        EXPECT_EQ(model.answer->labels[one.neuron], one.number) << kind;
        EXPECT_EQ(one.distance, map_of(model).distance(input, one.neuron, workspace));
        EXPECT_EQ(one.distance, least_distance(model, one.number, input)) << kind;
        if (i > 0) {
          EXPECT_GE(one.distance, classes[i - 1].distance) << kind;
        }
      }
      const InputAnswer answer = reader.answer(input);
      EXPECT_EQ(answer.nearest, classes.front().number) << kind;
      EXPECT_EQ(answer.distance, classes.front().distance) << kind;
      EXPECT_EQ(answer.novelty, reader.novelty(input, classes.front())) << kind;
    }
  }
}

TEST(AnswerReader, WithoutNamesThereAreNoClasses) {
  SystemModel model = three_names(testing::kKinds.front());
  model.answer->labels =
      NeuronLabels(std::vector<std::optional<std::size_t>>(model.answer->labels.neurons()));
  const AnswerReader reader(model);
  const std::vector<float> values(map_of(model).input_size());
  EXPECT_TRUE(reader.classes(SignalView::dense(values)).empty());
  EXPECT_FALSE(reader.novelty(SignalView::dense(values), {}));
  EXPECT_THROW(reader.answer(SignalView::dense(values)), InvalidArgument);
}

}  // namespace
}  // namespace somato
