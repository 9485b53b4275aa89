#include "maps/reading/screened_map.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/core/lanes.h"
#include "base/core/threads.h"

namespace somato {
namespace {

using kernels::kBlockNeurons;
using kernels::kGreatestInteger;

constexpr std::size_t kStripRows = 4;  // so that a block is about a square

// Neuron numbers along strips of rows, forth and back: neighbours in the order lie close together.
std::vector<std::size_t> order_in_strips(const Grid& grid) {
  std::vector<std::size_t> order;
  order.reserve(grid.size());
  bool forth = true;
  for (std::size_t top = 0; top < grid.rows(); top += kStripRows, forth = !forth) {
    const std::size_t bottom = std::min(top + kStripRows, grid.rows());
    for (std::size_t i = 0; i < grid.columns(); ++i) {
      const std::size_t column = forth ? i : grid.columns() - 1 - i;
      for (std::size_t row = top; row < bottom; ++row) {
        order.push_back(row * grid.columns() + column);
      }
    }
  }
  return order;
}

std::size_t blocks_for(std::size_t count) {
  return (count + kBlockNeurons - 1) / kBlockNeurons;
}

// Writes one row of integers to its lane of a block.
void interleave(std::span<const std::int16_t> integers, std::size_t lane, std::int16_t* block) {
  for (std::size_t pair = 0; pair < integers.size() / 2; ++pair) {
    std::memcpy(block + 2 * (pair * kBlockNeurons + lane), integers.data() + 2 * pair,
                2 * sizeof(std::int16_t));
  }
}

AlignedVector<float> infinite(std::size_t count) {
  return AlignedVector<float>(count, std::numeric_limits<float>::infinity());
}

}  // namespace

ScreenedMap::ScreenedMap(const Som& som, std::size_t threads)
    : euclidean_(som.parameters().similarity == Similarity::kEuclidean),
      order_(order_in_strips(som.grid())),
      centre_(som.weights().columns()),
      rows_(som.neurons(), som.weights().columns()),
      radii_(blocks_for(som.neurons())) {
  find_centre(som);
  for_each_range(som.weights().blocks(), threads,
                 [&](std::size_t begin, std::size_t end) { write_rows(som, begin, end); });
  find_unit(threads);
  if (all_alike()) return;
  const std::size_t block_size = 2 * pairs() * kBlockNeurons;
  values_.resize(blocks() * block_size);
  offsets_ = infinite(blocks() * kBlockNeurons);
  mean_values_.resize(mean_blocks() * block_size);
  mean_offsets_ = infinite(mean_blocks() * kBlockNeurons);
  rounded_off_.resize(order_.size() + blocks());
  for_each_range(blocks(), threads, [&](std::size_t begin, std::size_t end) {
    std::vector<std::int16_t> integers(2 * pairs());
    for (std::size_t block = begin; block < end; ++block) {
      write_block(block, integers);
      if (euclidean_) write_mean(block, integers);
    }
  });
  greatest_rounded_off_ = *std::max_element(rounded_off_.begin(), rounded_off_.end());
}

void ScreenedMap::find_centre(const Som& som) {
  const LaneMatrix<float>& weights = som.weights();
  AlignedVector<float> sums(columns() * kFloatLanes);
  for (std::size_t block = 0; block < weights.blocks(); ++block) {
    const float* values = weights.data() + block * sums.size();
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += values[i];
  }
  const auto count = static_cast<float>(weights.rows());
  for (std::size_t d = 0; d < columns(); ++d) {
    float sum = 0.0F;
    for (std::size_t lane = 0; lane < kFloatLanes; ++lane) sum += sums[d * kFloatLanes + lane];
    centre_[d] = sum / count;
  }
  squared_centre_ = kernels::batch_table().inner_product(centre_.data(), centre_.data(), columns());
}

// From blocks of lanes to rows: each cache line of the former is read once.
void ScreenedMap::write_rows(const Som& som, std::size_t begin, std::size_t end) {
  std::vector<std::size_t> place_of(order_.size());
  for (std::size_t place = 0; place < order_.size(); ++place) place_of[order_[place]] = place;
  for (std::size_t block = begin; block < end; ++block) {
    const float* values = som.weights().data() + block * columns() * kFloatLanes;
    const std::size_t lanes = std::min(kFloatLanes, som.neurons() - block * kFloatLanes);
    float* rows[kFloatLanes] = {};
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      rows[lane] = rows_.row(place_of[block * kFloatLanes + lane]).data();
    }
    for (std::size_t d = 0; d < columns(); ++d) {
      for (std::size_t lane = 0; lane < lanes; ++lane)
        rows[lane][d] = values[d * kFloatLanes + lane];
    }
  }
}

void ScreenedMap::find_unit(std::size_t threads) {
  squared_lengths_.resize(order_.size());
  for_each_range(order_.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t place = begin; place < end; ++place) {
      squared_lengths_[place] = kernels::batch_table().squared_distance(rows_.row(place).data(),
                                                                        centre_.data(), columns());
    }
  });
  unit_ = std::sqrt(*std::max_element(squared_lengths_.begin(), squared_lengths_.end()));
}

float ScreenedMap::offset_of(std::span<const float> weights, double squared_length) const {
  const double score = euclidean_
                           ? 0.5 * squared_length
                           : squared_centre_ - kernels::batch_table().inner_product(
                                                   weights.data(), centre_.data(), columns());
  return static_cast<float>(score / (unit_ * unit_));
}

void ScreenedMap::write_block(std::size_t block, std::vector<std::int16_t>& integers) {
  const std::size_t first = block * kBlockNeurons;
  const std::size_t count = std::min(kBlockNeurons, order_.size() - first);
  for (std::size_t lane = 0; lane < count; ++lane) {
    const auto row = rows_.row(first + lane);
    rounded_off_[first + lane] = kernels::batch_table().to_integers(
        row.data(), centre_.data(), integer_factor(unit_), columns(), integers.data());
    interleave(integers, lane, values_.data() + block * 2 * pairs() * kBlockNeurons);
    offsets_[first + lane] = offset_of(row, squared_lengths_[first + lane]);
  }
}

void ScreenedMap::write_mean(std::size_t block, std::vector<std::int16_t>& integers) {
  const std::size_t first = block * kBlockNeurons;
  const std::size_t count = std::min(kBlockNeurons, order_.size() - first);
  std::vector<float> mean(columns());
  for (std::size_t lane = 0; lane < count; ++lane) {
    const auto row = rows_.row(first + lane);
    for (std::size_t d = 0; d < mean.size(); ++d) mean[d] += row[d];
  }
  for (float& value : mean) value /= static_cast<float>(count);
  double radius = 0.0;
  for (std::size_t lane = 0; lane < count; ++lane) {
    radius = std::max(radius, kernels::batch_table().squared_distance(
                                  rows_.row(first + lane).data(), mean.data(), columns()));
  }
  radii_[block] = std::sqrt(radius) / unit_;
  rounded_off_[order_.size() + block] = kernels::batch_table().to_integers(
      mean.data(), centre_.data(), integer_factor(unit_), columns(), integers.data());
  interleave(integers, block % kBlockNeurons,
             mean_values_.data() + block / kBlockNeurons * 2 * pairs() * kBlockNeurons);
  const double squared_length =
      kernels::batch_table().squared_distance(mean.data(), centre_.data(), columns());
  mean_offsets_[block] = offset_of(mean, squared_length);
}

float ScreenedMap::integer_factor(double length) {
  return length > 0.0 ? static_cast<float>(double{kGreatestInteger} / length) : 0.0F;
}

float ScreenedMap::score_factor(double length) const {
  return static_cast<float>(length / unit_ / double{kGreatestInteger} / double{kGreatestInteger});
}

// The distance of a vector of integers from the represented vector, relative to kGreatestInteger:
// due to rounding to integers and to intermediate rounding errors.
double ScreenedMap::relative_error(float rounded_off) const {
  return std::sqrt(double{rounded_off}) * (1.0 + 1e-3) / double{kGreatestInteger} + 0x1p-21;
}

// By Cauchy and Schwarz |x . w - x' . w'| <= |x - x'| |w| + |x'| |w - w'|. Then what single
// precision rounds, and double precision where the score is decided.
double ScreenedMap::score_error(double distance, float rounded_off) const {
  const double of_sample = relative_error(rounded_off);
  const double of_weights = relative_error(greatest_rounded_off_);
  const double greatest_offset = euclidean_ ? 0.5 : std::sqrt(squared_centre_) / unit_;
  const double greatest_score = greatest_offset + 2.0 * distance;
  return distance * (of_sample + (1.0 + of_sample) * of_weights) + 0x1p-21 * greatest_score +
         0x1p-40 * (1.0 + distance) * (1.0 + distance);
}

}  // namespace somato
