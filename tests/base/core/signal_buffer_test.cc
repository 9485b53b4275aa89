#include "somato/core/signal.h"

#include <gtest/gtest.h>

#include "base/support/no_malloc.h"

namespace somato {
namespace {

const Signal kDenseSignal = Signal::dense({1.0F, 0.0F, 3.0F});
const Signal kSparseSignal = Signal::sparse({9}, {2, 7}, {5.0F, 6.0F});

TEST(SignalBuffer, HoldsWhatItIsGiven) {
  SignalBuffer buffer;
  for (const Signal* signal : {&kDenseSignal, &kSparseSignal, &kDenseSignal}) {
    buffer.assign(signal->view());
    const SignalView view = buffer.view();
    EXPECT_EQ(view.size, signal->size());
    EXPECT_EQ(view.sparse, signal->is_sparse());
    std::vector<float> values(view.size);
    write_dense(view, values);
    EXPECT_EQ(values, signal->to_dense());
  }
}

TEST(SignalBuffer, IsFilledElementByElement) {
  SignalBuffer buffer;
  buffer.assign(kSparseSignal.view());
  buffer.begin_sparse(4);
  buffer.add(3, 2.0F);
  std::vector<float> values(4);
  write_dense(buffer.view(), values);
  EXPECT_EQ(values, (std::vector<float>{0.0F, 0.0F, 0.0F, 2.0F}));
  buffer.begin_dense(2) = {8.0F, 9.0F};
  values.resize(2);
  write_dense(buffer.view(), values);
  EXPECT_EQ(values, (std::vector<float>{8.0F, 9.0F}));
}

TEST(SignalBuffer, AllocatesNothingOnceItHasGrown) {
  SignalBuffer buffer;
  buffer.assign(kDenseSignal.view());
  buffer.assign(kSparseSignal.view());
  const testing::AllocationCounter counter;
  buffer.assign(kDenseSignal.view());
  buffer.assign(kSparseSignal.view());
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace somato
