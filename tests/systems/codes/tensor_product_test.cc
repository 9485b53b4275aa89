#include "somato/codes/tensor_product.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Shape = std::vector<std::size_t>;

Signal product_of(const std::vector<Signal>& inputs) {
  return tensor_product(inputs);
}

// Values with few digits, a third of them zero; stored explicitly too where the signal is sparse.
Signal random_factor(Random& random, bool sparse) {
  Shape shape(1 + random.below(2));
  std::size_t size = 1;
  for (std::size_t& extent : shape) size *= extent = random.below(5);
  std::vector<std::uint32_t> indices;
  std::vector<float> values;
  for (std::uint32_t i = 0; i < size; ++i) {
    if (sparse && random.below(2) == 0) continue;
    indices.push_back(i);
    values.push_back(random.below(3) == 0 ? 0.0F : static_cast<float>(random.normal()));
  }
  return sparse ? Signal::sparse(shape, indices, values) : Signal::dense(shape, values);
}

std::vector<Signal> random_signals(Random& random) {
  std::vector<Signal> signals(1 + random.below(4));
  const std::uint64_t sparse_in_four = random.below(5);
  for (Signal& signal : signals) signal = random_factor(random, random.below(4) < sparse_in_four);
  return signals;
}

// The definition, one element at a time: the digits of the flat index, in the inputs' sizes, say
// which elements are multiplied.
std::vector<float> oracle(const std::vector<Signal>& inputs) {
  std::size_t total = 1;
  for (const Signal& input : inputs) total *= input.size();
  std::vector<float> elements(total);
  for (std::size_t flat = 0; flat < total; ++flat) {
    float element = 1.0F;
    std::size_t below = total;
    for (const Signal& input : inputs) {
      below /= input.size();
      element *= input.to_dense()[flat / below % input.size()];
    }
    elements[flat] = element;
  }
  return elements;
}

TEST(TensorProduct, PutsTheRowsAfterEachOther) {
  const Signal product =
      product_of({Signal::dense({2.0F, 3.0F}), Signal::dense({5.0F, 7.0F, 11.0F})});
  EXPECT_EQ(product, Signal::dense({2, 3}, {10.0F, 14.0F, 22.0F, 15.0F, 21.0F, 33.0F}));
}

TEST(TensorProduct, AgreesWithItsDefinitionOnRandomSignals) {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const std::vector<Signal> inputs = random_signals(random);
    EXPECT_EQ(product_of(inputs).to_dense(), oracle(inputs));
  }
}

TEST(TensorProduct, JoinsShapesAndIsSparseWhenAnyInputIs) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const std::vector<Signal> inputs = random_signals(random);
    Shape shape;
    bool sparse = false;
    for (const Signal& input : inputs) {
      shape.insert(shape.end(), input.shape().begin(), input.shape().end());
      sparse = sparse || input.is_sparse();
    }
    const Signal product = product_of(inputs);
    EXPECT_EQ(product.shape(), shape);
    EXPECT_EQ(product.is_sparse(), sparse);
  }
}

TEST(TensorProduct, StoresNoZeroInASparseProduct) {
  const Signal touch = Signal::dense({0.0F, 0.5F, 0.0F, -0.0F});
  const Signal wrist = Signal::sparse({3}, {0, 2}, {0.0F, 1.0F});
  EXPECT_EQ(product_of({touch, wrist}), Signal::sparse({4, 3}, {5}, {0.5F}));
  EXPECT_EQ(product_of({wrist, touch}), Signal::sparse({3, 4}, {9}, {0.5F}));
  EXPECT_EQ(product_of({wrist}), Signal::sparse({3}, {2}, {1.0F}));
}

// 1e-30 squared is below the smallest float, and so is stored by neither order.
TEST(TensorProduct, StoresNoProductThatBecameZero) {
  const Signal tiny = Signal::sparse({2}, {0, 1}, {1e-30F, 1.0F});
  EXPECT_EQ(product_of({tiny, tiny}), Signal::sparse({2, 2}, {1, 2, 3}, {1e-30F, 1e-30F, 1.0F}));
}

// From the right 1e-30 would be left; from the left the first product is below the smallest float.
TEST(TensorProduct, MultipliesFromLeftToRight) {
  const Signal tiny = Signal::dense({1e-30F});
  EXPECT_EQ(product_of({tiny, tiny, Signal::dense({1e30F})}), Signal::dense({1, 1, 1}, {0.0F}));
}

// The chain of P06: height and wrist first, then joints, then touch.
TEST(TensorProduct, OfAChainIsTheProductOfAll) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const std::vector<Signal> inputs = random_signals(random);
    Signal chain = inputs.front();
    for (std::size_t next = 1; next < inputs.size(); ++next) {
      chain = product_of({chain, inputs[next]});
    }
    if (inputs.size() > 1) {
      EXPECT_EQ(chain, product_of(inputs));
    }
  }
}

TEST(TensorProduct, OfThePapersCodesHas270000ElementsAndTouchesFew) {
  const Signal height = Signal::sparse({10}, {4}, {1.0F});
  const Signal wrist = Signal::sparse({10}, {7}, {1.0F});
  const Signal joints = Signal::sparse({6, 10}, {1, 12, 20, 39, 45, 58}, {1, 1, 1, 1, 1, 1});
  std::vector<float> touch(45);
  touch[0] = 0.25F;
  touch[44] = 0.5F;
  const Signal all = product_of({height, wrist, joints, Signal::dense(touch)});
  EXPECT_EQ(all.shape(), (Shape{10, 10, 6, 10, 45}));
  EXPECT_EQ(all.size(), 270000U);
  ASSERT_EQ(all.indices().size(), 12U);
  EXPECT_EQ(all.indices()[0], (47U * 60U + 1U) * 45U);
  EXPECT_EQ(all.indices()[11], (47U * 60U + 58U) * 45U + 44U);
  EXPECT_EQ(all.values()[0], 0.25F);
  EXPECT_EQ(all.values()[11], 0.5F);
}

TEST(TensorProduct, ReachesTheLastIndexThat32BitsHold) {
  const Signal left = Signal::sparse({65537}, {65536}, {2.0F});
  const Signal right = Signal::sparse({65535}, {65534}, {3.0F});
  EXPECT_EQ(product_of({left, right}), Signal::sparse({65537, 65535}, {4294967294U}, {6.0F}));
}

TEST(TensorProduct, RefusesMoreElementsThanIndicesCanCount) {
  const Signal large = Signal::sparse({65536}, {0}, {1.0F});
  EXPECT_THROW(product_of({large, large}), InvalidArgument);
  EXPECT_THROW(product_of({Signal::sparse({std::size_t{1} << 32}, {}, {})}), InvalidArgument);
  const Signal huge = Signal::sparse({4294967295U}, {}, {});
  EXPECT_NO_THROW(product_of({huge}));
  EXPECT_THROW(product_of({huge, huge, huge, huge}), InvalidArgument);
}

TEST(TensorProduct, NeedsASignal) {
  EXPECT_THROW(product_of({}), InvalidArgument);
}

}  // namespace
}  // namespace somato
