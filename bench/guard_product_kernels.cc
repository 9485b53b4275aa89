// The kernels of product_kernels.h.

#include <cstdint>
#include <numeric>
#include <vector>

#include "base/kernels/product_kernels.h"
#include "guard.h"

namespace somato::bench {
namespace {

using kernels::kRowLanes;

static_assert(kKernels<kernels::ProductTable> == 11, "count each of them");

constexpr std::size_t kElements = 61;
constexpr std::size_t kSamples = 29;

std::vector<std::uint32_t> first_numbers(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

void count_initial_weights(const Counted& counted) {
  const auto& table = kernels::product_table();
  constexpr std::size_t kQuarters = 20;
  constexpr std::size_t kQuartersOfRow = 200;
  const kernels::RandomRows rows{{1, 2}, 0, 32};
  const auto quarters = first_numbers(kQuarters);
  AlignedVector<float> uniform(4 * kQuarters * kRowLanes);
  counted(
      "product.uniform_rows",
      [&] { table.uniform_rows(rows, quarters.data(), kQuarters, uniform.data()); },
      [&] { return digest_of(uniform); });
  AlignedVector<float> row(4 * kQuartersOfRow);
  counted(
      "product.uniform_row", [&] { table.uniform_row(rows, 5, kQuartersOfRow, row.data()); },
      [&] { return digest_of(row); });
  const auto places = first_numbers(kElements);
  const auto low = noise<float>(kElements, 41);
  const auto span = noise<float>(kElements, 42);
  AlignedVector<double> out(kElements * kRowLanes);
  AlignedVector<double> squares(kRowLanes);
  counted(
      "product.initial_weights",
      [&] {
        table.initial_weights(uniform.data(), places.data(), low.data(), span.data(), kElements,
                              out.data(), squares.data());
      },
      [&] { return digest_of(out, digest_of(squares)); });
}

// Every third value of samples, in lists by element or by sample.
struct Lists {
  std::vector<std::uint32_t> starts{0};
  std::vector<std::uint32_t> numbers;
  std::vector<float> values;
};

Lists lists_of(std::size_t lines, std::size_t length) {
  Lists lists;
  lists.starts.reserve(lines + 1);
  lists.numbers.reserve(lines * length);
  for (std::size_t line = 0; line < lines; ++line) {
    for (std::size_t i = line % 3; i < length; i += 3) {
      lists.numbers.push_back(static_cast<std::uint32_t>(i));
    }
    lists.starts.push_back(static_cast<std::uint32_t>(lists.numbers.size()));
  }
  const auto values = noise<float>(lists.numbers.size(), 43);
  lists.values.assign(values.begin(), values.end());
  return lists;
}

void count_products(const Counted& counted) {
  const auto& table = kernels::product_table();
  const auto w = noise<double>(kElements * kRowLanes, 44);
  const auto x = noise<double>(kElements * kSamples, 45);
  const Lists by_sample = lists_of(kSamples, kElements);
  AlignedVector<double> products(kSamples * kRowLanes);
  const Digest bits = [&] { return digest_of(products); };
  counted(
      "product.add_products",
      [&] {
        table.add_products(w.data(), x.data(), kElements, kSamples, products.data(), kRowLanes);
      },
      bits);
  counted(
      "product.add_listed_products",
      [&] {
        table.add_listed_products(w.data(), by_sample.starts.data(), by_sample.numbers.data(),
                                  by_sample.values.data(), kSamples, products.data(), kRowLanes);
      },
      bits);
}

void count_forming(const Counted& counted) {
  const auto& table = kernels::product_table();
  const auto w = noise<double>(kElements * kRowLanes, 44);
  const auto x = noise<double>(kElements * kSamples, 45);
  const auto of_start = noise<double>(kRowLanes, 46);
  const auto coefficients = noise<double>(kSamples * kRowLanes, 47);
  const auto places = first_numbers(kElements);
  const Lists by_element = lists_of(kElements, kSamples);
  const kernels::ListedValues listed{by_element.starts.data(), by_element.starts.data() + 1,
                                     by_element.numbers.data(), by_element.values.data()};
  AlignedVector<float> out(kElements * kRowLanes);
  const Digest bits = [&] { return digest_of(out); };
  counted(
      "product.form_weights",
      [&] {
        table.form_weights(w.data(), of_start.data(), x.data(), coefficients.data(), kElements,
                           kSamples, places.data(), out.data());
      },
      bits);
  counted(
      "product.form_listed_weights",
      [&] {
        table.form_listed_weights(w.data(), of_start.data(), listed, coefficients.data(), kElements,
                                  places.data(), out.data());
      },
      bits);
}

void count_moves(const Counted& counted) {
  const auto& table = kernels::product_table();
  constexpr std::size_t kPadded = 21 * kRowLanes;
  auto of_start = noise<double>(kPadded, 51);
  auto factors = noise<double>(kPadded, 52);
  auto squared_lengths = noise<double>(kPadded, 53);
  auto coefficients = noise<double>(kPadded * kSamples, 54);
  const kernels::ProductMap map{kPadded,
                                kSamples,
                                of_start.data(),
                                factors.data(),
                                squared_lengths.data(),
                                coefficients.data()};
  const auto of_initial = noise<double>(kPadded, 55);
  const auto of_samples = noise<double>(kSamples, 56);
  AlignedVector<double> products(kPadded);
  counted(
      "product.products_with",
      [&] { table.products_with(map, of_initial.data(), of_samples.data(), products.data()); },
      [&] { return digest_of(products); });
  AlignedVector<double> gains = noise<double>(kPadded, 57);
  for (std::size_t i = 0; i < kPadded / 3; ++i) gains[i] = 0.0;
  counted(
      "product.move",
      [&] {
        table.move(map, 3, 1.0, products.data(), gains.data(), true);
        table.move(map, 4, 1.0, products.data(), gains.data(), false);
      },
      [&] {
        return digest_of(of_start,
                         digest_of(factors, digest_of(squared_lengths, digest_of(coefficients))));
      });
}

void count_vectors(const Counted& counted) {
  const auto& table = kernels::product_table();
  constexpr std::size_t kLength = 1003;
  const auto offsets = noise<double>(kLength, 58);
  const auto products = noise<double>(kLength, 59);
  AlignedVector<double> scores(kLength);
  std::size_t winner = 0;
  counted(
      "product.least",
      [&] { winner = table.least(offsets.data(), products.data(), 2.0, kLength, scores.data()); },
      [&] { return digest_of(scores, winner); });
  auto values = noise<double>(kLength, 60);
  for (double& value : values) value *= -720.0;
  counted(
      "product.exponentials", [&] { table.exponentials(values.data(), kLength); },
      [&] { return digest_of(values); });
}

}  // namespace

void count_product_kernels(const Counted& counted) {
  count_initial_weights(counted);
  count_products(counted);
  count_forming(counted);
  count_moves(counted);
  count_vectors(counted);
}

}  // namespace somato::bench
