#include "somato/maps/known_samples.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "somato/maps/product_som.h"
#include "support/random_maps.h"

namespace somato {
namespace {

TEST(KnownSamples, AreNoneUnlessGiven) {
  EXPECT_EQ(KnownSamples().count(), 0U);
  EXPECT_EQ(KnownSamples(Samples(Matrix<float>(3, 2))).count(), 3U);
  EXPECT_EQ(KnownSamples(Samples(Matrix<float>(3, 2))).size(), 2U);
}

// Maps that scale their inputs and maps that do not.
TEST(KnownSamples, AreSharedByMapsOnSeveralThreads) {
  Random random(109);
  const KnownSamples known(testing::random_samples(6, 200, true, random));
  const std::vector<std::size_t> training{0, 1, 2, 4};
  std::vector<SomParameters> parameters(4);
  for (std::size_t i = 0; i < 4; ++i) {
    parameters[i].iterations = 50;
    parameters[i].normalize_input = i % 2 == 1;
  }
  std::vector<Som> soms(4);
  {
    std::vector<std::jthread> threads;
    threads.reserve(soms.size());
    for (std::size_t i = 0; i < 4; ++i) {
      threads.emplace_back(
          [&, i] { soms[i] = (*train_product_som(parameters[i], known, training))->form_som(); });
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const Som expected = train_som(parameters[i], known.samples().subset(training)).value();
    EXPECT_EQ(soms[i].weights(), expected.weights());
  }
}

}  // namespace
}  // namespace somato
