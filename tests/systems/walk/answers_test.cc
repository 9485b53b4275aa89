#include "somato/graph/answers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "somato/core/check.h"
#include "somato/core/random.h"
#include "somato/graph/further_learning.h"
#include "systems/walk/model_of_first.h"

namespace somato {
namespace {

using testing::kKinds;
using testing::map_of;
using testing::model_of_first;
using testing::recording;

// A model with two classes and a threshold, some of whose neurons have no name.
SystemModel model_with_threshold(const std::string& kind) {
  SystemModel model = model_of_first(kind);
  EXPECT_TRUE(teach(model, recording(), 15, "cup"));
  model.answer->novelty = Novelty{0.1, 9, 0.8, {20.0, 50.0}};
  return model;
}

TEST(Answers, AreThoseOfAllNeurons) {
  std::size_t unknown = 0;
  std::size_t known = 0;
  const Recording all = recording();
  Random random(4);
  for (const std::string& kind : kKinds) {
    const SystemModel model = model_with_threshold(kind);
    const Som& som = map_of(model);
    for (int trial = 0; trial < 100; ++trial) {
      const auto frame = testing::frames_of(all, "joints", random.below(18)).row(0);
      std::vector<float> values(frame.begin(), frame.end());
      for (float& value : values) value += static_cast<float>(40.0 * random.uniform());
      const SignalView input = SignalView::dense(values);
      const InputAnswer answer = answer_to(model, input);
      SomWorkspace workspace;
      std::optional<std::size_t> named;
      for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
        const double distance = som.distance(input, neuron, workspace);
        EXPECT_GE(distance, answer.winner_distance) << kind;
        if (!model.answer->labels[neuron]) continue;
        if (!named || distance < som.distance(input, *named, workspace)) named = neuron;
      }
      EXPECT_EQ(som.distance(input, answer.winner, workspace), answer.winner_distance);
      EXPECT_EQ(answer.nearest, model.answer->labels[*named].value()) << kind;
      EXPECT_EQ(answer.distance, som.distance(input, *named, workspace)) << kind;
      const double scale = answer.nearest == 0 ? 20.0 : 50.0;
      EXPECT_DOUBLE_EQ(answer.novelty.value(), answer.distance / scale / 0.8);
      const bool is_far = answer.distance > scale * 0.8;
      EXPECT_EQ(answer.is_unknown(), is_far);
      EXPECT_EQ(answer.name(model.answer->classes),
                is_far ? "unknown" : model.answer->classes[answer.nearest]);
      (is_far ? unknown : known) += 1;
    }
  }
  EXPECT_GT(unknown, 0U);
  EXPECT_GT(known, 0U);
}

// The whitening leaves the first element only: novelty is the distance along it, while the answer
// remains that of the nearest neuron.
TEST(Answers, HaveTheNoveltyAfterWhitening) {
  SystemModel model = model_with_threshold("growing_when_required");
  const Som& som = map_of(model);
  const std::size_t size = som.input_size();
  const InputAnswer plain =
      answer_to(model, SignalView::dense(testing::frames_of(recording(), "joints", 9).row(0)));
  model.answer->novelty->whitening = Matrix<double>(size, size);
  model.answer->novelty->whitening(0, 0) = 0.5;
  for (std::size_t i = 0; i < 18; ++i) {
    const Matrix<float> frames = testing::frames_of(recording(), "joints", i);
    const InputAnswer answer = answer_to(model, SignalView::dense(frames.row(0)));
    double least = std::numeric_limits<double>::infinity();
    double scale = 0.0;
    for (const std::size_t neuron : model.answer->labels.labelled()) {
      const double distance = 0.5 * std::abs(double{frames(0, 0)} - double{som.weight(neuron, 0)});
      if (distance >= least) continue;
      least = distance;
      scale = *model.answer->labels[neuron] == 0 ? 20.0 : 50.0;
    }
    EXPECT_NEAR(answer.novelty.value(), least / scale / 0.8, 1e-9);
    if (i == 9) {
      EXPECT_EQ(answer.nearest, plain.nearest);
    }
  }
}

TEST(Answers, WithoutAThresholdNothingIsUnknown) {
  SystemModel model = model_with_threshold(kKinds.front());
  model.answer->novelty.reset();
  const auto given = answers(model, recording());
  ASSERT_TRUE(given);
  for (const InputAnswer& answer : *given) {
    EXPECT_FALSE(answer.novelty);
    EXPECT_FALSE(answer.is_unknown());
  }
}

TEST(Answers, OfARecordingAreThoseOfItsInputs) {
  const SystemModel model = model_with_threshold(kKinds.front());
  const Recording all = recording();
  const auto given = answers(model, all, 2).value();
  ASSERT_EQ(given.size(), all.explorations.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    const auto frames = testing::frames_of(all, "joints", i);
    const InputAnswer one = answer_to(model, SignalView::dense(frames.row(frames.rows() - 1)));
    EXPECT_EQ(given[i].winner, one.winner) << i;
    EXPECT_EQ(given[i].novelty, one.novelty) << i;
  }
}

TEST(Answers, NeedAnAnswer) {
  SystemModel model = model_of_first(kKinds.front());
  model.answer.reset();
  const auto refused = answers(model, recording());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kData);
  EXPECT_EQ(refused.error().what, "the system has no output map");
  EXPECT_THROW(answer_to(model, SignalView::dense(std::vector<float>{0.0F})), InvalidArgument);
}

TEST(Answers, ValuesAreInTheRangeOfTheMap) {
  const SystemModel model = model_of_first(kKinds.front());
  Recording all = recording();
  all.explorations[3].channels[0].frames.values().back() = 1e30F;
  const auto refused = answers(model, all);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("exploration 4"), std::string::npos) << refused.error().what;
}

}  // namespace
}  // namespace somato
