#include "somato/maps/som_training.h"

#include <gtest/gtest.h>

#include <optional>

#include "base/core/read_ahead.h"
#include "base/support/instruction_sets.h"
#include "maps/support/random_maps.h"
#include "somato/maps/som_quality.h"

namespace somato {
namespace {

SomParameters batch(const testing::Variant& variant, Random& random) {
  SomParameters p = testing::random_parameters(variant, random);
  const auto& starts = Choices<InitialWeights>::all();
  p.initial_weights = starts[random.below(starts.size())].first;
  p.training = Training::kBatch;
  p.epochs = random.below(4);
  if (random.below(3) == 0) p.normalize_input = random.below(2) == 0;
  return p;
}

// Everything that a model file keeps of a map.
void expect_same(const Som& som, const Som& expected) {
  EXPECT_EQ(som.weights(), expected.weights());
  EXPECT_EQ(som.elements(), expected.elements());
  EXPECT_EQ(parameters_to_toml(som.parameters()), parameters_to_toml(expected.parameters()));
}

TEST(SomTrainingThread, FromASourceGivesTheSameBitsHoweverItIsParted) {
  Random random(71);
  bool reads_ahead = false;
  for (int round = 0; round < 2; ++round) {
    for (const auto& variant : testing::variants_in_pairs()) {
      const Samples samples =
          testing::random_samples(1 + random.below(60), 1 + random.below(20), false, random);
      const SomParameters p = batch(variant, random);
      const Som expected = train_som(p, samples).value();
      for (const std::size_t most : {1U, 7U, 59U, 100U}) {
        for (const std::size_t threads : {1U, 2U, 4U}) {
          SCOPED_TRACE(testing::name_of(variant) + " " + std::to_string(most) + " " +
                       std::to_string(threads));
          SamplesInMemory source(samples, most);
          std::optional<ReadAhead> ahead;
          if (reads_ahead) ahead.emplace(source);
          SampleSource& read = ahead ? static_cast<SampleSource&>(*ahead) : source;
          expect_same(train_som(p, read, {threads, {}}).value(), expected);
          reads_ahead = !reads_ahead;
        }
      }
      reads_ahead = !reads_ahead;  // the number of cases is even
    }
  }
}

TEST(SomTraining, FromASourceGivesTheSameBitsForEveryInstructionSet) {
  Random random(72);
  const Samples samples = testing::random_samples(50, 19, false, random);
  SomParameters p;
  p.training = Training::kBatch;
  p.epochs = 3;
  const LaneMatrix<float> expected = train_som(p, samples).value().weights();
  testing::for_each_instruction_set([&](InstructionSet set) {
    SamplesInMemory source(samples, 11);
    EXPECT_EQ(train_som(p, source).value().weights(), expected) << name_of(set);
  });
}

// More neurons than samples: these are drawn in several rounds.
TEST(SomTraining, FromASourceMayStartAtFewSamples) {
  Random random(73);
  const Samples samples = testing::random_samples(5, 3, false, random);
  SomParameters p;
  p.training = Training::kBatch;
  p.initial_weights = InitialWeights::kSamples;
  p.epochs = 0;
  SamplesInMemory source(samples, 2);
  expect_same(train_som(p, source).value(), train_som(p, samples).value());
}

TEST(SomTraining, FromASourceReportsItsPartsAndStopsBetweenThem) {
  const Samples samples(Matrix<float>(10, 2, 1.0F));
  SomParameters p;
  p.training = Training::kBatch;
  p.epochs = 3;
  SamplesInMemory source(samples, 3);
  std::vector<std::uint64_t> reported;
  const auto report = [&](std::uint64_t done, std::uint64_t total) {
    reported.push_back(done);
    EXPECT_EQ(total, 12u);
    return true;
  };
  ASSERT_TRUE(train_som(p, source, {1, report}));
  EXPECT_EQ(reported, (std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  for (const std::uint64_t last : {2U, 4U, 12U}) {
    const auto stop = [&](std::uint64_t done, std::uint64_t) { return done < last; };
    EXPECT_EQ(train_som(p, source, {1, stop}).error().kind, ErrorKind::kInterrupted) << last;
  }
}

TEST(SomTraining, FromASourceRefusesWhatCannotBeTrainedOn) {
  SomParameters p;
  p.training = Training::kBatch;
  const auto refusal = [&](const Samples& samples) {
    SamplesInMemory source(samples, 1);
    return train_som(p, source).error();
  };
  EXPECT_EQ(refusal(Samples()).what, train_som(p, Samples()).error().what);
  EXPECT_EQ(refusal(Samples(Matrix<float>(3, 0))).kind, ErrorKind::kData);
  for (const float scale : {1e20F, 1e-20F}) {
    const Samples samples(Matrix<float>(3, 2, {0, 0, 0, 0, 0, scale}));
    EXPECT_EQ(refusal(samples).what, train_som(p, samples).error().what);
  }
  p.rows = 1 << 12;
  p.columns = 1 << 12;
  EXPECT_EQ(refusal(Samples(Matrix<float>(2, 20000, 1.0F))).kind, ErrorKind::kSystem);
  p = {};
  const Error online = refusal(Samples(Matrix<float>(3, 2, 1.0F)));
  EXPECT_EQ(online.kind, ErrorKind::kUsage);
  EXPECT_NE(online.advice.find("batch"), std::string::npos);
}

// Fails in pass number `bad`.
class FailingSource final : public SampleSource {
 public:
  explicit FailingSource(int bad) : bad_(bad) {}

  std::size_t size() const override { return 2; }
  Result<void> rewind() override {
    ++pass_;
    given_ = false;
    return {};
  }
  Result<SamplePart> next() override {
    if (pass_ > bad_) return fail(ErrorKind::kData, "the file has changed");
    if (std::exchange(given_, true)) return SamplePart();
    return std::make_shared<const Samples>(Matrix<float>(2, 2, {0, 1, 2, 3}));
  }

 private:
  int bad_;
  int pass_ = 0;
  bool given_ = false;
};

TEST(SomTraining, FromASourceFailsAsItDoesInAnyPass) {
  SomParameters p;
  p.training = Training::kBatch;
  p.initial_weights = InitialWeights::kSamples;
  p.epochs = 2;
  for (const int pass : {0, 1, 2, 3}) {
    FailingSource source(pass);
    EXPECT_EQ(train_som(p, source).error().what, "the file has changed") << pass;
  }
  FailingSource source(4);
  EXPECT_TRUE(train_som(p, source));
}

TEST(SomQualityThread, IsTheSameHoweverTheSamplesAreParted) {
  Random random(74);
  const Samples samples = testing::random_samples(40, 5, false, random);
  SomParameters p;
  p.iterations = 100;
  const Som som = train_som(p, samples).value();
  const SomQuality expected = measure_quality(som, samples, 1);
  for (const std::size_t most : {1U, 7U, 40U}) {
    for (const std::size_t threads : {1U, 2U, 4U}) {
      SomQualityMeasurement measurement(som, threads);
      std::vector<std::size_t> winners;
      SamplesInMemory source(samples, most);
      ASSERT_TRUE(for_each_part(source, [&](const Samples& part) -> Result<void> {
        const auto of_part = measurement.add(part);
        winners.insert(winners.end(), of_part.begin(), of_part.end());
        return {};
      }));
      const SomQuality quality = measurement.quality();
      EXPECT_EQ(quality.quantization_error, expected.quantization_error);
      EXPECT_EQ(quality.topographic_error, expected.topographic_error);
      EXPECT_EQ(quality.hits, expected.hits);
      EXPECT_EQ(winners, expected.winners);
    }
  }
}

}  // namespace
}  // namespace somato
