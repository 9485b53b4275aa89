#include "base/kernels/product_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/core/elementary.h"
#include "base/support/instruction_sets.h"
#include "somato/core/matrix.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using kernels::kRowLanes;
using kernels::product_table;

AlignedVector<double> normal_numbers(std::size_t count, Random& random) {
  AlignedVector<double> numbers(count);
  for (double& number : numbers) number = random.normal();
  return numbers;
}

// Sums are consecutive std::fma operations for every instruction set: every test requires identical
// bits.
template <typename Check>
void on_random_problems(std::uint64_t seed, const Check& check) {
  testing::for_each_instruction_set([&](InstructionSet set) {
    Random random(seed);
    for (int i = 0; i < 30; ++i) {
      SCOPED_TRACE(name_of(set));
      check(random);
    }
  });
}

TEST(ProductKernels, MakeTheNumbersOfAPlace) {
  on_random_problems(91, [](Random& random) {
    const std::uint64_t seed = (std::uint64_t{random.next()} << 32U) | random.next();
    const kernels::RandomRows rows{
        {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U)},
        static_cast<std::uint32_t>(Stream::kInitialWeights),
        static_cast<std::uint32_t>(16 * random.below(1000))};
    std::vector<std::uint32_t> quarters;
    for (int i = 0; i < 5; ++i) quarters.push_back(random.next() >> (2 + random.below(20)));
    AlignedVector<float> out(4 * quarters.size() * kRowLanes);
    product_table().uniform_rows(rows, quarters.data(), quarters.size(), out.data());
    for (std::size_t i = 0; i < out.size(); ++i) {
      const auto row = static_cast<std::uint32_t>(rows.first_row + i % kRowLanes);
      const auto line = static_cast<std::uint32_t>(i / kRowLanes);
      EXPECT_EQ(out[i],
                uniform_at(seed, Stream::kInitialWeights, row, 4 * quarters[line / 4] + line % 4));
    }
  });
}

TEST(ProductKernels, MakeTheNumbersOfARow) {
  on_random_problems(90, [](Random& random) {
    const std::uint64_t seed = random.next();
    const kernels::RandomRows rows{{static_cast<std::uint32_t>(seed), 0},
                                   static_cast<std::uint32_t>(Stream::kNoise),
                                   random.next()};
    const std::uint32_t first = random.next() >> 3U;
    const std::size_t quarters = random.below(50);
    std::vector<float> out(4 * quarters + 1, 7.0F);
    product_table().uniform_row(rows, first, quarters, out.data());
    for (std::uint32_t i = 0; i < 4 * quarters; ++i) {
      EXPECT_EQ(out[i], uniform_at(seed, Stream::kNoise, rows.first_row, 4 * first + i));
    }
    EXPECT_EQ(out.back(), 7.0F);
  });
}

TEST(ProductKernels, PutInitialWeightsIntoTheirRanges) {
  on_random_problems(92, [](Random& random) {
    const std::size_t elements = 1 + random.below(50);
    AlignedVector<float> uniform(64 * kRowLanes);
    for (float& number : uniform) number = static_cast<float>(random.uniform());
    std::vector<std::uint32_t> places;
    std::vector<float> low;
    std::vector<float> span;
    for (std::size_t e = 0; e < elements; ++e) {
      places.push_back(static_cast<std::uint32_t>(random.below(64)));
      low.push_back(static_cast<float>(random.normal()));
      span.push_back(static_cast<float>(random.normal()));
    }
    AlignedVector<double> out(elements * kRowLanes);
    AlignedVector<double> squares = normal_numbers(kRowLanes, random);
    AlignedVector<double> expected = squares;
    product_table().initial_weights(uniform.data(), places.data(), low.data(), span.data(),
                                    elements, out.data(), squares.data());
    for (std::size_t i = 0; i < out.size(); ++i) {
      const std::size_t e = i / kRowLanes;
      const float scaled = span[e] * uniform[places[e] * kRowLanes + i % kRowLanes];
      const float weight = low[e] + scaled;
      EXPECT_EQ(out[i], double{weight});
      double& square = expected[i % kRowLanes];
      square = std::fma(double{weight}, double{weight}, square);
    }
    EXPECT_EQ(squares, expected);
  });
}

// Samples with a value in about a third of the elements, element by element and sample by sample.
struct ListedProblem {
  std::size_t elements;
  std::size_t samples;
  AlignedVector<double> all;  // elements x samples
  std::vector<std::uint32_t> begins;
  std::vector<std::uint32_t> ends;
  std::vector<std::uint32_t> sample_of;
  std::vector<float> values;
  std::vector<std::uint32_t> starts;
  std::vector<std::uint32_t> element_of;
  std::vector<float> values_by_sample;
};

ListedProblem listed_problem(Random& random) {
  ListedProblem p{1 + random.below(60), 1 + random.below(40), {}, {}, {}, {}, {}, {}, {}, {}};
  p.all.resize(p.elements * p.samples);
  for (std::size_t e = 0; e < p.elements; ++e) {
    p.begins.push_back(static_cast<std::uint32_t>(p.values.size()));
    for (std::size_t s = 0; s < p.samples; ++s) {
      if (random.below(3) != 0) continue;
      p.values.push_back(static_cast<float>(random.normal()));
      p.sample_of.push_back(static_cast<std::uint32_t>(s));
      p.all[e * p.samples + s] = double{p.values.back()};
    }
    p.ends.push_back(static_cast<std::uint32_t>(p.values.size()));
  }
  for (std::size_t s = 0; s < p.samples; ++s) {
    p.starts.push_back(static_cast<std::uint32_t>(p.element_of.size()));
    for (std::size_t e = 0; e < p.elements; ++e) {
      if (p.all[e * p.samples + s] == 0.0) continue;
      p.element_of.push_back(static_cast<std::uint32_t>(e));
      p.values_by_sample.push_back(static_cast<float>(p.all[e * p.samples + s]));
    }
  }
  p.starts.push_back(static_cast<std::uint32_t>(p.element_of.size()));
  return p;
}

TEST(ProductKernels, AddProductsInTheOrderOfElements) {
  on_random_problems(93, [](Random& random) {
    const ListedProblem p = listed_problem(random);
    const std::size_t stride = 48;
    const AlignedVector<double> w = normal_numbers(p.elements * kRowLanes, random);
    const AlignedVector<double> before = normal_numbers(p.samples * stride, random);
    AlignedVector<double> expected = before;
    for (std::size_t e = 0; e < p.elements; ++e) {
      for (std::size_t s = 0; s < p.samples; ++s) {
        for (std::size_t lane = 0; lane < kRowLanes; ++lane) {
          double& product = expected[s * stride + lane];
          product = std::fma(w[e * kRowLanes + lane], p.all[e * p.samples + s], product);
        }
      }
    }
    AlignedVector<double> products = before;
    product_table().add_products(w.data(), p.all.data(), p.elements, p.samples, products.data(),
                                 stride);
    EXPECT_EQ(products, expected);
    products = before;
    product_table().add_listed_products(w.data(), p.starts.data(), p.element_of.data(),
                                        p.values_by_sample.data(), p.samples, products.data(),
                                        stride);
    EXPECT_EQ(products, expected);
  });
}

TEST(ProductKernels, FormWeightsInTheOrderOfSamples) {
  on_random_problems(94, [](Random& random) {
    const ListedProblem p = listed_problem(random);
    const AlignedVector<double> w = normal_numbers(p.elements * kRowLanes, random);
    const AlignedVector<double> of_start = normal_numbers(kRowLanes, random);
    const AlignedVector<double> coefficients = normal_numbers(p.samples * kRowLanes, random);
    std::vector<std::uint32_t> places;
    for (std::uint32_t e = 0; e < p.elements; ++e) places.push_back(3 * e + 1);
    AlignedVector<float> expected(3 * p.elements * kRowLanes);
    for (std::size_t e = 0; e < p.elements; ++e) {
      for (std::size_t lane = 0; lane < kRowLanes; ++lane) {
        double weight = of_start[lane] * w[e * kRowLanes + lane];
        for (std::size_t s = 0; s < p.samples; ++s) {
          weight = std::fma(coefficients[s * kRowLanes + lane], p.all[e * p.samples + s], weight);
        }
        expected[places[e] * kRowLanes + lane] = static_cast<float>(weight);
      }
    }
    AlignedVector<float> out(expected.size());
    product_table().form_weights(w.data(), of_start.data(), p.all.data(), coefficients.data(),
                                 p.elements, p.samples, places.data(), out.data());
    EXPECT_EQ(out, expected);
    out.assign(expected.size(), 0.0F);
    const kernels::ListedValues listed{p.begins.data(), p.ends.data(), p.sample_of.data(),
                                       p.values.data()};
    product_table().form_listed_weights(w.data(), of_start.data(), listed, coefficients.data(),
                                        p.elements, places.data(), out.data());
    EXPECT_EQ(out, expected);
  });
}

struct MapProblem {
  std::size_t padded;
  std::size_t samples;
  AlignedVector<double> of_start;
  AlignedVector<double> factors;
  AlignedVector<double> squared_lengths;
  AlignedVector<double> coefficients;

  kernels::ProductMap map() {
    return {padded,
            samples,
            of_start.data(),
            factors.data(),
            squared_lengths.data(),
            coefficients.data()};
  }
};

MapProblem map_problem(Random& random) {
  const std::size_t padded = kRowLanes * (1 + random.below(20));
  const std::size_t samples = 1 + random.below(10);
  return {padded,
          samples,
          normal_numbers(padded, random),
          normal_numbers(padded, random),
          normal_numbers(padded, random),
          normal_numbers(padded * samples, random)};
}

TEST(ProductKernels, ReadProductsOffTheCoefficients) {
  on_random_problems(95, [](Random& random) {
    MapProblem p = map_problem(random);
    const AlignedVector<double> of_initial = normal_numbers(p.padded, random);
    const AlignedVector<double> of_samples = normal_numbers(p.samples, random);
    AlignedVector<double> out(p.padded);
    product_table().products_with(p.map(), of_initial.data(), of_samples.data(), out.data());
    for (std::size_t j = 0; j < p.padded; ++j) {
      double sum = 0.0;
      for (std::size_t s = 0; s < p.samples; ++s) {
        sum = std::fma(p.coefficients[s * p.padded + j], of_samples[s], sum);
      }
      EXPECT_EQ(out[j], std::fma(sum, p.factors[j], p.of_start[j] * of_initial[j]));
    }
  });
}

TEST(ProductKernels, FindTheFirstOfTheLeast) {
  on_random_problems(96, [](Random& random) {
    const std::size_t count = 1 + random.below(100);
    AlignedVector<double> offsets(count);
    AlignedVector<double> products(count);
    AlignedVector<double> scores(count);
    for (std::size_t i = 0; i < count; ++i) {
      offsets[i] = static_cast<double>(random.below(4));  // so that there are ties
      products[i] = static_cast<double>(random.below(4));
    }
    std::size_t expected = 0;
    for (std::size_t i = 1; i < count; ++i) {
      if (offsets[i] - 2 * products[i] < offsets[expected] - 2 * products[expected]) expected = i;
    }
    EXPECT_EQ(product_table().least(offsets.data(), products.data(), 2.0, count, scores.data()),
              expected);
  });
}

// Moves one neuron, step by step.
void move_neuron(MapProblem& p, std::size_t j, std::size_t sample, double squared_length,
                 double product, double gain, bool normalize) {
  const double kept = 1.0 - gain;
  double squared = kept * kept * p.squared_lengths[j];
  squared = std::fma((gain + gain) * kept, product, squared);
  squared = std::fma(gain * gain, squared_length, squared);
  p.of_start[j] *= kept;
  double& value = p.coefficients[sample * p.padded + j];
  value += gain / p.factors[j];
  if (normalize && squared > 0.0) {
    const double shrink = 1.0 / std::sqrt(squared);
    p.factors[j] *= shrink;
    p.of_start[j] *= shrink;
    squared = 1.0;
  }
  p.squared_lengths[j] = squared;
}

TEST(ProductKernels, MoveEveryNeuronByItsGain) {
  on_random_problems(97, [](Random& random) {
    MapProblem p = map_problem(random);
    MapProblem expected = p;
    const bool normalize = random.below(2) == 0;
    const std::size_t sample = random.below(p.samples);
    const double squared_length = random.uniform();
    const AlignedVector<double> products = normal_numbers(p.padded, random);
    AlignedVector<double> gains(p.padded);
    for (std::size_t j = 0; j < p.padded; ++j) gains[j] = j % 40 < 20 ? random.uniform() : 0.0;
    product_table().move(p.map(), sample, squared_length, products.data(), gains.data(), normalize);
    for (std::size_t j = 0; j < p.padded; ++j) {
      if (gains[j] == 0.0) continue;
      expected.factors[j] *= 1.0 - gains[j];
      move_neuron(expected, j, sample, squared_length, products[j], gains[j], normalize);
      EXPECT_EQ(p.squared_lengths[j], expected.squared_lengths[j]);
      EXPECT_EQ(p.of_start[j], expected.of_start[j]);
      EXPECT_EQ(p.factors[j], expected.factors[j]);
    }
    EXPECT_EQ(p.coefficients, expected.coefficients);
  });
}

// A gain of 1 forgets everything, and many small ones nearly do: factors must not come to 0, nor
// coefficients to where numbers end.
TEST(ProductKernels, KeepCoefficientsInRange) {
  on_random_problems(98, [](Random& random) {
    MapProblem p = map_problem(random);
    const std::size_t sample = random.below(p.samples);
    const AlignedVector<double> products(p.padded);
    AlignedVector<double> gains(p.padded, random.below(2) == 0 ? 1.0 : 0.875);
    for (int i = 0; i < 800; ++i) {
      product_table().move(p.map(), sample, 1.0, products.data(), gains.data(), false);
    }
    for (std::size_t j = 0; j < p.padded; ++j) {
      for (std::size_t s = 0; s < p.samples; ++s) {
        const double coefficient = p.factors[j] * p.coefficients[s * p.padded + j];
        EXPECT_NEAR(coefficient, s == sample ? 1.0 : 0.0, 1e-12);
        EXPECT_NE(std::fpclassify(p.coefficients[s * p.padded + j]), FP_SUBNORMAL);
      }
      EXPECT_EQ(p.of_start[j], 0.0);
    }
  });
}

TEST(ProductKernels, TakeExponentials) {
  on_random_problems(99, [](Random& random) {
    std::vector<double> values;
    for (std::size_t i = random.below(30); i > 0; --i) values.push_back(-700.0 * random.uniform());
    values.insert(values.end(),
                  {0.0, -0.0, -1e-300, -699.999, -700.1, -std::numeric_limits<double>::infinity()});
    std::vector<double> out = values;
    product_table().exponentials(out.data(), out.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_EQ(out[i], values[i] < -700.0 ? 0.0 : exponential(values[i])) << values[i];
    }
  });
}

}  // namespace
}  // namespace somato
