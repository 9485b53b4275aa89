#include "studies/exploration_samples.h"

#include <gtest/gtest.h>

#include "support/made_recording.h"

namespace somato {
namespace {

Recording recording() {
  return {{testing::exploration_of("ball", {1}), testing::exploration_of("cube", {2}),
           testing::exploration_of("ball", {3})}};
}

TEST(LabelsOf, AreThoseOfTheExplorations) {
  EXPECT_EQ(labels_of(recording(), "object").value(),
            (std::vector<std::string>{"ball", "cube", "ball"}));
  EXPECT_EQ(labels_of(recording(), "objcet").error().kind, ErrorKind::kUsage);
}

TEST(NumbersOf, AreEqualWhereLabelsAre) {
  EXPECT_EQ(numbers_of(recording(), "object").value(), (std::vector<std::size_t>{0, 1, 0}));
  EXPECT_EQ(numbers_of(recording(), "").value(), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(numbers_of(recording(), "objcet").error().kind, ErrorKind::kUsage);
}

TEST(SingleValues, ComeInTheOrderAskedFor) {
  Activations activations(2, 3);
  for (std::size_t exploration = 0; exploration < 3; ++exploration) {
    const auto value = static_cast<float>(exploration);
    activations.set(1, exploration,
                    std::make_shared<const Sequence>(
                        Sequence{Samples(Matrix<float>(1, 2, {value, -value})), 0.0}));
  }
  const Samples samples = single_values(activations, 1, {2, 0});
  ASSERT_EQ(samples.count(), 2U);
  EXPECT_EQ(samples[0].values[0], 2.0F);
  EXPECT_EQ(samples[0].values[1], -2.0F);
  EXPECT_EQ(samples[1].values[0], 0.0F);
}

}  // namespace
}  // namespace somato
