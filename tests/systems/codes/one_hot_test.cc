#include "somato/codes/one_hot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "somato/core/check.h"

namespace somato {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

OneHotParameters bins_of(double low, double high, std::size_t elements = 10,
                         OutsideRange outside = OutsideRange::kRefuse) {
  return {low, high, elements, outside};
}

TEST(OneHot, PutsEveryBinsLowerEdgeAndMiddleIntoIt) {
  const OneHot code(bins_of(-90.0, 90.0));  // bins of 18 degrees
  for (std::uint32_t bin = 0; bin < 10; ++bin) {
    EXPECT_EQ(code.bin(-90.0F + 18.0F * static_cast<float>(bin)), bin);
    EXPECT_EQ(code.bin(-81.0F + 18.0F * static_cast<float>(bin)), bin);
  }
}

TEST(OneHot, PutsTheUpperEndIntoTheLastBin) {
  EXPECT_EQ(OneHot(bins_of(0.0, 10.0)).bin(10.0F), 9U);
  EXPECT_EQ(OneHot(bins_of(0.0, 10.0, 1)).bin(10.0F), 0U);
}

// 0.1 and 0.7 have no exact binary form, and a float 0.1 is larger than a double 0.1.
TEST(OneHot, TakesDecimalEdgesAsTheyAreWritten) {
  const OneHot tenths(bins_of(0.0, 1.0));
  const float edges[] = {0.0F, 0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 0.6F, 0.7F, 0.8F, 0.9F};
  for (std::uint32_t bin = 0; bin < 10; ++bin) {
    EXPECT_EQ(tenths.bin(edges[bin]), bin);
    if (bin > 0) {
      EXPECT_EQ(tenths.bin(std::nextafter(edges[bin], 0.0F)), bin - 1);
    }
  }
  EXPECT_EQ(OneHot(bins_of(0.0, 0.1)).bin(0.1F), 9U);
}

TEST(OneHot, RefusesAValueOutsideWithItsRange) {
  const OneHot code(bins_of(-5.0, 90.0));
  const Result<std::uint32_t> above = code.bin(91.5F);
  ASSERT_FALSE(above);
  EXPECT_EQ(above.error().kind, ErrorKind::kData);
  EXPECT_EQ(above.error().what, "the value 91.5 is outside the range -5 to 90 of its one-hot code");
  EXPECT_EQ(above.error().advice, "widen 'low' and 'high', or set outside = \"clamp\"");
  EXPECT_FALSE(code.bin(-5.01F));
  EXPECT_FALSE(code.bin(kInfinity));
  EXPECT_FALSE(code.encode(-kInfinity));
}

TEST(OneHot, ClampsOnRequest) {
  const OneHot code(bins_of(0.0, 10.0, 5, OutsideRange::kClamp));
  EXPECT_EQ(code.bin(-0.1F), 0U);
  EXPECT_EQ(code.bin(-kInfinity), 0U);
  EXPECT_EQ(code.bin(10.1F), 4U);
  EXPECT_EQ(code.bin(kInfinity), 4U);
}

TEST(OneHot, NeverTakesNaN) {
  for (const OutsideRange outside : {OutsideRange::kRefuse, OutsideRange::kClamp}) {
    const Result<std::uint32_t> bin = OneHot(bins_of(0.0, 1.0, 10, outside)).bin(std::nanf(""));
    ASSERT_FALSE(bin);
    EXPECT_EQ(bin.error().what, "the value to be encoded is not a number");
  }
}

TEST(OneHot, EncodesASingleOne) {
  EXPECT_EQ(OneHot(bins_of(0.0, 4.0, 4)).encode(2.5F), Signal::sparse({4}, {2}, {1.0F}));
}

TEST(OneHot, RefusesARangeThatIsNone) {
  EXPECT_THROW(OneHot(bins_of(1.0, 1.0)), InvalidArgument);
  EXPECT_THROW(OneHot(bins_of(2.0, 1.0)), InvalidArgument);
  EXPECT_THROW(OneHot(bins_of(0.0, std::nan(""))), InvalidArgument);
  EXPECT_THROW(OneHot(bins_of(0.0, 1e39)), InvalidArgument);
  EXPECT_THROW(OneHot(bins_of(0.0, 1.0, 0)), InvalidArgument);
  EXPECT_THROW(OneHot(bins_of(0.0, 1.0, (1U << 20) + 1)), InvalidArgument);
}

TEST(OneHotParameters, AreReadByTheirNames) {
  const Table table{"",
                    {{"low", "", Value{-1.5}},
                     {"high", "", Value{2.5}},
                     {"elements", "", Value{std::int64_t{7}}},
                     {"outside", "", Value{std::string("clamp")}}}};
  const auto parameters = read_parameters<OneHotParameters>(table);
  ASSERT_TRUE(parameters);
  EXPECT_EQ(parameters->low, -1.5);
  EXPECT_EQ(parameters->high, 2.5);
  EXPECT_EQ(parameters->elements, 7U);
  EXPECT_EQ(parameters->outside, OutsideRange::kClamp);
  EXPECT_EQ(OneHotParameters{}.elements, 10U);
  EXPECT_EQ(OneHotParameters{}.outside, OutsideRange::kRefuse);
}

TEST(OneHotSequence, MakesSixtyElementsOfSixJoints) {
  const OneHotSequence code(std::vector<OneHotParameters>(6, bins_of(0.0, 10.0)));
  const Result<Signal> signal =
      code.encode(std::vector<float>{0.5F, 9.5F, 3.5F, 0.0F, 10.0F, 5.0F});
  ASSERT_TRUE(signal);
  EXPECT_EQ(*signal, Signal::sparse({6, 10}, {0, 19, 23, 30, 49, 55}, {1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(signal->size(), 60U);
}

TEST(OneHotSequence, GivesEachJointItsOwnRange) {
  const OneHotSequence code({bins_of(0.0, 2.0, 2), bins_of(0.0, 200.0, 2)});
  EXPECT_EQ(code.encode(std::vector<float>{1.5F, 1.5F}), Signal::sparse({2, 2}, {1, 2}, {1, 1}));
}

TEST(OneHotSequence, NamesTheJointItCannotCode) {
  const OneHotSequence code({bins_of(0.0, 1.0), bins_of(0.0, 1.0)});
  const Result<Signal> signal = code.encode(std::vector<float>{0.5F, 1.5F});
  ASSERT_FALSE(signal);
  EXPECT_EQ(signal.error().where, "joint 2");
  EXPECT_EQ(signal.error().what, "the value 1.5 is outside the range 0 to 1 of its one-hot code");
}

TEST(OneHotSequence, RefusesJointsAndValuesThatDoNotFit) {
  EXPECT_THROW(OneHotSequence({}), InvalidArgument);
  EXPECT_THROW(OneHotSequence({bins_of(0.0, 1.0, 5), bins_of(0.0, 1.0, 6)}), InvalidArgument);
  const OneHotSequence code({bins_of(0.0, 1.0)});
  EXPECT_THROW((void)code.encode(std::vector<float>{0.5F, 0.5F}), InvalidArgument);
  EXPECT_THROW((void)code.encode({}), InvalidArgument);
}

}  // namespace
}  // namespace somato
