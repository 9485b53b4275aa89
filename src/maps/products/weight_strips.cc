#include "maps/products/weight_strips.h"

#include <algorithm>
#include <utility>

#include "base/kernels/product_kernels.h"
#include "maps/products/strip_rows.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using kernels::kRowLanes;

constexpr std::size_t kQuarters = 32;  // in a strip
constexpr std::size_t kElements = 4 * kQuarters;

}  // namespace

// Scratch memory of a thread.
class WeightStrips::Workspace {
 public:
  explicit Workspace(const WeightStrips& strips)
      : numbers(kElements * kRowLanes), weights(kElements * kRowLanes), squares(kRowLanes) {
    const Samples& samples = strips.samples_.samples();
    if (!samples.is_sparse()) values.resize(kElements * samples.count());
  }

  void read(const WeightStrips& strips, const Strip& strip) {
    if (!values.empty()) {
      strips.samples_.write_elements(strips.elements_[strip.first], strip.count, values);
    }
  }

  void read_rows(const WeightStrips& strips, const Strip& strip) {
    if (values.empty()) {
      rows.read(strips.listed(strip), strip.count, strips.samples_.samples().count());
    }
  }

  AlignedVector<float> numbers;
  AlignedVector<double> weights;  // they stay 0 where they do not start at random
  AlignedVector<double> squares;
  AlignedVector<double> values;  // of dense samples
  StripRows rows;                // of sparse ones
};

WeightStrips::WeightStrips(SomParameters parameters, const SampleProducts& samples,
                           std::vector<std::uint32_t> elements, std::vector<std::uint32_t> places,
                           InitialRanges ranges)
    : parameters_(std::move(parameters)),
      samples_(samples),
      elements_(std::move(elements)),
      places_(std::move(places)),
      ranges_(std::move(ranges)) {
  cut();
  if (samples_.samples().is_sparse()) find_columns();
}

void WeightStrips::cut() {
  numbers_.reserve(elements_.size());
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const std::uint32_t quarter = elements_[e] / 4;
    const bool known = !strips_.empty() && quarters_.back() == quarter;
    if (strips_.empty() || (!known && strips_.back().quarters == kQuarters)) {
      strips_.push_back({e, 0, quarters_.size(), 0});
    }
    Strip& strip = strips_.back();
    if (!known) {
      quarters_.push_back(quarter);
      ++strip.quarters;
    }
    ++strip.count;
    numbers_.push_back(static_cast<std::uint32_t>(4 * (strip.quarters - 1) + elements_[e] % 4));
  }
}

// Both are in ascending order.
void WeightStrips::find_columns() {
  const auto columns = samples_.columns().elements();
  const auto starts = samples_.columns().starts();
  begins_.resize(elements_.size());
  ends_.resize(elements_.size());
  std::size_t column = 0;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    while (column < columns.size() && columns[column] < elements_[e]) ++column;
    if (column == columns.size() || columns[column] != elements_[e]) continue;
    begins_[e] = starts[column];
    ends_[e] = starts[column + 1];
  }
}

kernels::ListedValues WeightStrips::listed(const Strip& strip) const {
  const SampleColumns& columns = samples_.columns();
  return {begins_.data() + strip.first, ends_.data() + strip.first, columns.samples().data(),
          columns.values().data()};
}

// Makes the initial weights of a strip.
void WeightStrips::start(const Strip& strip, std::size_t block, Workspace& workspace) const {
  const auto& kernels = kernels::product_table();
  const kernels::RandomRows rows{{static_cast<std::uint32_t>(parameters_.seed),
                                  static_cast<std::uint32_t>(parameters_.seed >> 32U)},
                                 static_cast<std::uint32_t>(Stream::kInitialWeights),
                                 static_cast<std::uint32_t>(block * kRowLanes)};
  kernels.uniform_rows(rows, &quarters_[strip.first_quarter], strip.quarters,
                       workspace.numbers.data());
  kernels.initial_weights(workspace.numbers.data(), &numbers_[strip.first],
                          &ranges_.low[strip.first], &ranges_.span[strip.first], strip.count,
                          workspace.weights.data(), workspace.squares.data());
}

void WeightStrips::add_products(std::size_t begin, std::size_t end, std::span<double> products,
                                std::span<double> squares) const {
  const auto& kernels = kernels::product_table();
  const std::size_t samples = samples_.samples().count();
  const std::size_t padded = squares.size();
  Workspace workspace(*this);
  for (const Strip& strip : strips_) {
    workspace.read(*this, strip);
    workspace.read_rows(*this, strip);
    for (std::size_t block = begin; block < end; ++block) {
      const std::size_t first = block * kRowLanes;
      std::copy_n(&squares[first], kRowLanes, workspace.squares.data());
      start(strip, block, workspace);
      std::copy_n(workspace.squares.data(), kRowLanes, &squares[first]);
      if (begins_.empty()) {
        kernels.add_products(workspace.weights.data(), workspace.values.data(), strip.count,
                             samples, &products[first], padded);
      } else {
        workspace.rows.add_products(workspace.weights.data(), &products[first], padded);
      }
    }
  }
}

void WeightStrips::form(std::size_t begin, std::size_t end, std::span<const double> of_start,
                        std::span<const double> coefficients, LaneMatrix<float>& weights) const {
  const std::size_t samples = samples_.samples().count();
  AlignedVector<double> lines((end - begin) * samples * kRowLanes);  // block by block
  for (std::size_t block = begin; block < end; ++block) {
    for (std::size_t s = 0; s < samples; ++s) {
      std::copy_n(&coefficients[s * of_start.size() + block * kRowLanes], kRowLanes,
                  &lines[((block - begin) * samples + s) * kRowLanes]);
    }
  }
  Workspace workspace(*this);
  for (const Strip& strip : strips_) {
    workspace.read(*this, strip);
    for (std::size_t block = begin; block < end; ++block) {
      if (random()) start(strip, block, workspace);
      form_block(strip, workspace, &of_start[block * kRowLanes],
                 &lines[(block - begin) * samples * kRowLanes],
                 weights.data() + block * kRowLanes * weights.columns());
    }
  }
}

void WeightStrips::form_block(const Strip& strip, const Workspace& workspace,
                              const double* of_start, const double* coefficients,
                              float* out) const {
  const auto& kernels = kernels::product_table();
  const std::uint32_t* places = &places_[strip.first];
  if (begins_.empty()) {
    kernels.form_weights(workspace.weights.data(), of_start, workspace.values.data(), coefficients,
                         strip.count, samples_.samples().count(), places, out);
  } else {
    kernels.form_listed_weights(workspace.weights.data(), of_start, listed(strip), coefficients,
                                strip.count, places, out);
  }
}

}  // namespace somato
