#include "maps/training/training_checkpoint.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "base/support/temporary_folder.h"
#include "base/support/thread_group.h"
#include "maps/support/random_maps.h"
#include "somato/core/random.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

Samples noise_for_checkpoints(bool sparse, std::size_t count) {
  Random random(5);
  if (sparse) return testing::random_samples(count, 40, true, random);
  Matrix<float> rows(count, 9);
  for (float& value : rows.values()) value = static_cast<float>(random.normal());
  return Samples(std::move(rows));
}

Samples some_of(const Samples& samples, std::size_t begin, std::size_t end) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = begin; i < end; ++i) numbers.push_back(i);
  return samples.subset(numbers);
}

SomParameters parameters_for(const testing::Variant& variant, InitialWeights initial) {
  Random random(7);
  SomParameters p = testing::random_parameters(variant, random);
  p.rows = 6;
  p.columns = 4;
  p.training = Training::kBatch;
  p.epochs = 4;
  p.initial_weights = initial;
  return p;
}

class Checkpoints : public ::testing::Test {
 protected:
  std::string path() const { return folder_.file("checkpoint"); }

  // The map of a group, whose members read parts of two samples; stopped before the end of epoch
  // number `stop_in` in one of them, unless that is 0.
  std::vector<Result<Som>> trained(const SomParameters& p, const Samples& samples, std::size_t size,
                                   std::uint64_t stop_in = 0) const {
    std::vector<Result<Som>> maps(size, fail(ErrorKind::kData, "not trained"));
    testing::in_thread_group(size, [&](ProcessGroup& group) {
      const std::size_t begin = samples.count() * group.rank() / size;
      const std::size_t end = samples.count() * (group.rank() + 1) / size;
      const Samples own = some_of(samples, begin, end);
      SamplesInMemory source(own, 2);
      TrainingOptions options;
      options.checkpoint = path();
      options.processes = &group;
      if (stop_in > 0 && group.rank() == size - 1) {
        options.progress = [=](std::uint64_t done, std::uint64_t total) {
          return done * 4 / total < stop_in;
        };
      }
      maps[group.rank()] = train_som(p, source, options);
    });
    return maps;
  }

  TemporaryFolder folder_;
};

// Initial weights and lengths alternate over the variants; both kinds of samples see all of them.
TEST_F(Checkpoints, OfOneNumberOfProcessesContinueOnAnotherWithTheSameBits) {
  const std::vector<InitialWeights> initials{InitialWeights::kLinear, InitialWeights::kSamples,
                                             InitialWeights::kRange};
  const std::vector<std::size_t> sizes{2, 3, 4, 7, 25};  // more processes than samples, too
  std::size_t number = 0;
  for (const bool sparse : {false, true}) {
    const Samples samples = noise_for_checkpoints(sparse, 23);
    for (const testing::Variant& variant : testing::variants_in_pairs()) {
      SomParameters p = parameters_for(variant, initials[number % initials.size()]);
      p.tolerance = number % 2 == 0 ? 0.0 : 0.01;
      p.patience = 2;
      SamplesInMemory whole(samples);
      const auto expected = train_som(p, whole);
      ASSERT_TRUE(expected) << to_string(expected.error());
      const std::size_t size = sizes[number++ % sizes.size()];
      for (const auto& one : trained(p, samples, size, 2)) {
        ASSERT_FALSE(one);
        EXPECT_EQ(one.error().kind, ErrorKind::kInterrupted);
      }
      EXPECT_TRUE(std::filesystem::exists(path()));
      for (const auto& one : trained(p, samples, size % 3 + 1)) {
        ASSERT_TRUE(one) << to_string(one.error());
        ASSERT_TRUE(one->weights() == expected->weights()) << testing::name_of(variant);
      }
      std::filesystem::remove(path());
    }
  }
}

// The processes agree on the end, at any epoch after which training was interrupted.
TEST_F(Checkpoints, ContinueTrainingOfAutomaticLength) {
  const Samples samples = noise_for_checkpoints(false, 23);
  SomParameters p = parameters_for(testing::all_variants().front(), InitialWeights::kSamples);
  p.epochs = 2;
  p.tolerance = 1e-3;
  p.patience = 2;
  SamplesInMemory whole(samples);
  TrainingOptions options;
  std::uint64_t steps = 0;
  options.steps_done = &steps;
  const auto expected = train_som(p, whole, options);
  ASSERT_TRUE(expected);
  ASSERT_GT(steps, 5U);
  for (std::uint64_t last = 1; last <= steps; ++last) {
    options.checkpoint = path();
    options.progress = [=](std::uint64_t done, std::uint64_t) { return done < last; };
    ASSERT_FALSE(train_som(p, whole, options));
    options.progress = {};
    std::uint64_t resumed = 0;
    options.steps_done = &resumed;
    const auto som = train_som(p, whole, options);
    ASSERT_TRUE(som) << to_string(som.error());
    EXPECT_EQ(resumed, steps) << last;
    EXPECT_TRUE(som->weights() == expected->weights()) << last;
    std::filesystem::remove(path());
  }
}

TEST_F(Checkpoints, OfAnotherTrainingOrDamagedAreRefused) {
  const Samples samples = noise_for_checkpoints(false, 12);
  SomParameters p = parameters_for(testing::all_variants().front(), InitialWeights::kRange);
  ASSERT_TRUE(trained(p, samples, 1).front());
  const std::string bytes = bytes_of(path());
  const auto expect_refused = [&](const SomParameters& parameters, const Samples& data,
                                  ErrorKind kind) {
    for (const auto& one : trained(parameters, data, 2)) {
      ASSERT_FALSE(one);
      EXPECT_EQ(one.error().kind, kind) << to_string(one.error());
      EXPECT_EQ(one.error().where, path());
    }
  };
  expect_refused(p, some_of(samples, 0, 11), ErrorKind::kUsage);
  SomParameters other = p;
  other.epochs = 5;
  expect_refused(other, samples, ErrorKind::kUsage);
  EXPECT_TRUE(bytes_of(path()) == bytes);
  folder_.with("checkpoint", bytes.substr(0, bytes.size() / 2));
  expect_refused(p, samples, ErrorKind::kData);
  folder_.with("checkpoint", "something else");
  expect_refused(p, samples, ErrorKind::kData);
}

}  // namespace
}  // namespace somato
