#include "base/core/read_ahead.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

namespace somato {
namespace {

Samples numbered(std::size_t count) {
  Matrix<float> rows(count, 1);
  std::iota(rows.values().begin(), rows.values().end(), 0.0F);
  return Samples(std::move(rows));
}

// Fails, or throws, instead of giving part number `bad`.
class FailingSource final : public SampleSource {
 public:
  FailingSource(int bad, bool throws) : bad_(bad), throws_(throws) {}

  std::size_t size() const override { return 1; }
  Result<void> rewind() override {
    given_ = 0;
    return {};
  }
  Result<SamplePart> next() override {
    if (given_++ < bad_) return std::make_shared<const Samples>(numbered(1));
    if (throws_) throw std::runtime_error("broken");
    return fail(ErrorKind::kData, "broken");
  }

 private:
  int bad_;
  bool throws_;
  int given_ = 0;
};

TEST(ReadAheadThread, GivesTheSameSamplesInTheSameOrderInEveryPass) {
  const Samples samples = numbered(101);
  for (const std::size_t most : {1U, 7U, 100U, 200U}) {
    SamplesInMemory source(samples, most);
    ReadAhead ahead(source);
    EXPECT_EQ(ahead.size(), 1u);
    for (int pass = 0; pass < 3; ++pass) {
      float next = 0.0F;
      ASSERT_TRUE(for_each_part(ahead, [&](const Samples& part) -> Result<void> {
        for (std::size_t i = 0; i < part.count(); ++i) EXPECT_EQ(part[i].values[0], next++);
        return {};
      }));
      EXPECT_EQ(next, 101.0F);
    }
  }
}

TEST(ReadAheadThread, MayBeLeftOrRewoundInTheMiddle) {
  const Samples samples = numbered(10);
  SamplesInMemory source(samples, 3);
  ReadAhead ahead(source);
  const SamplePart first = ahead.next().value();
  ASSERT_TRUE(ahead.next());
  ASSERT_TRUE(ahead.rewind());
  EXPECT_EQ((**ahead.next())[0].values[0], 0.0F);
  EXPECT_EQ((*first)[2].values[0], 2.0F);  // a part exists as long as it is in use
}

TEST(ReadAheadThread, AFailureComesInItsPlace) {
  FailingSource source(2, false);
  ReadAhead ahead(source);
  EXPECT_TRUE(ahead.next());
  EXPECT_TRUE(ahead.next());
  EXPECT_EQ(ahead.next().error().what, "broken");
  ASSERT_TRUE(ahead.rewind());
  EXPECT_TRUE(ahead.next());
}

TEST(ReadAheadThread, AnExceptionComesInItsPlace) {
  FailingSource source(1, true);
  ReadAhead ahead(source);
  EXPECT_TRUE(ahead.next());
  EXPECT_THROW((void)ahead.next(), std::runtime_error);
}

}  // namespace
}  // namespace somato
