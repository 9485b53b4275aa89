#include "systems/model/weight_folding.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "systems/model/learned_parts.h"
#include "systems/signals/logarithm.h"

namespace somato::detail {
namespace {

constexpr std::size_t kMostEnds = 256;

// kLeading: each element of the input has several neighbouring ones in the output; kTrailing: the
// elements of the input repeat in the output.
enum class Kind {
  kEnd,
  kPass,
  kUndo,
  kProduct,
  kConcatenation,
  kOneHot,
  kTMpsom,
  kLeading,
  kTrailing
};

struct KnownType {
  const char* name;
  Kind of_weights;
  Kind of_contributions;
  bool keeps_unit;
};

constexpr KnownType kTypes[] = {{"first", Kind::kPass, Kind::kPass, true},
                                {"last", Kind::kPass, Kind::kPass, true},
                                {"change", Kind::kPass, Kind::kPass, true},
                                {"tare", Kind::kPass, Kind::kPass, true},
                                {"high_pass", Kind::kPass, Kind::kPass, true},
                                {"mean_removal", Kind::kEnd, Kind::kPass, true},
                                {"window", Kind::kEnd, Kind::kPass, true},
                                {"onset_window", Kind::kEnd, Kind::kPass, true},
                                {"delay", Kind::kEnd, Kind::kPass, true},
                                {"accumulate", Kind::kPass, Kind::kPass, false},
                                {"leaky_accumulate", Kind::kPass, Kind::kPass, false},
                                {"mean", Kind::kPass, Kind::kPass, true},
                                {"normalization", Kind::kPass, Kind::kPass, false},
                                {"scale", Kind::kUndo, Kind::kPass, true},
                                {"logarithm", Kind::kUndo, Kind::kPass, true},
                                {"standardization", Kind::kUndo, Kind::kPass, true},
                                {"resampling", Kind::kEnd, Kind::kTrailing, true},
                                {"spectrum", Kind::kEnd, Kind::kLeading, false},
                                {"number_code", Kind::kEnd, Kind::kLeading, false},
                                {"concatenation", Kind::kConcatenation, Kind::kConcatenation, true},
                                {"tensor_product", Kind::kProduct, Kind::kProduct, false},
                                {"one_hot", Kind::kOneHot, Kind::kLeading, false},
                                {"t_mpsom", Kind::kTMpsom, Kind::kEnd, false}};

// How a module passes on what is projected.
struct Passage {
  Kind kind = Kind::kEnd;
  bool keeps_unit = true;
};

Passage passage_through(const System& system, std::size_t module, Folded folded) {
  for (const KnownType& type : kTypes) {
    if (system.modules()[module].type->name != type.name) continue;
    if (folded == Folded::kWeights) return {type.of_weights, type.keeps_unit};
    // A module that is undone for weights has changed the unit of their differences.
    return {type.of_contributions, type.keeps_unit && type.of_weights != Kind::kUndo};
  }
  return {};
}

// Whether only the first input has the elements of the output: the other one of a spectrum is a
// speed.
bool has_one_source(Kind kind) {
  return kind == Kind::kLeading || kind == Kind::kTrailing || kind == Kind::kPass;
}

double setting(const System& system, std::size_t module, const std::string& name, double absent) {
  const Table::Entry* entry = system.description().modules[module].settings.find(name);
  const auto* value = entry ? std::get_if<Value>(&entry->content) : nullptr;
  if (!value) return absent;
  if (const auto* whole = std::get_if<std::int64_t>(&value->content)) {
    return static_cast<double>(*whole);
  }
  const auto* number = std::get_if<double>(&value->content);
  return number ? *number : absent;
}

std::size_t place(const FoldedWeights& weights, std::size_t i) {
  return weights.places.empty() ? i : weights.places[i];
}

FoldedWeights all_of(std::vector<double> values) {
  const std::size_t size = values.size();
  return {size, {}, std::move(values)};
}

std::vector<double> dense(const FoldedWeights& weights) {
  if (weights.places.empty()) return weights.values;
  std::vector<double> values(weights.size);
  for (std::size_t i = 0; i < weights.values.size(); ++i) {
    values[weights.places[i]] = weights.values[i];
  }
  return values;
}

// Shares of a neuron's input from each element, by arbor and weights.
Matrix<float> shares(Matrix<float> receptive, const Matrix<float>& arbor) {
  for (std::size_t neuron = 0; neuron < receptive.rows(); ++neuron) {
    double sum = 0.0;
    for (std::size_t k = 0; k < receptive.columns(); ++k) {
      receptive(neuron, k) = std::max(0.0F, receptive(neuron, k) * arbor(neuron, k));
      sum += double{receptive(neuron, k)};
    }
    for (float& share : receptive.row(neuron)) {
      share = sum > 0.0 ? static_cast<float>(double{share} / sum) : 0.0F;
    }
  }
  return receptive;
}

}  // namespace

WeightFolding::WeightFolding(const System& system, std::size_t input, bool unit, Folded folded)
    : system_(system), input_(input), folded_(folded), start_{unit, true} {
  find_ends(input, start_, 0);
  if (ends_.size() <= kMostEnds) return;
  ends_ = {{input, unit}};
  whole_ = true;
  plain_ = true;
}

std::size_t WeightFolding::size_of(std::size_t module) const {
  return system_.modules()[module].output.size();
}

// A loop never ends by itself, and neither need ways that part and meet again and again.
void WeightFolding::find_ends(std::size_t module, Way way, std::size_t depth) {
  if (ends_.size() > kMostEnds) return;
  const Passage type = passage_through(system_, module, folded_);
  if (type.kind == Kind::kEnd || depth > system_.modules().size()) {
    ends_.push_back({module, way.unit});
    return;
  }
  remember(module);
  const bool sums = type.kind == Kind::kProduct || type.kind == Kind::kTMpsom;
  plain_ = plain_ && !sums && type.kind != Kind::kOneHot;
  way.unit = type.kind == Kind::kOneHot || (way.unit && type.keeps_unit);
  way.single = type.kind == Kind::kOneHot || (way.single && !sums);
  for (const std::size_t input : system_.modules()[module].inputs) {
    find_ends(input, way, depth + 1);
    if (has_one_source(type.kind)) break;
  }
}

void WeightFolding::remember(std::size_t module) {
  if (folded_ == Folded::kContributions) return;
  if (auto ranges = one_hot_ranges_of(system_, module)) ranges_[module] = std::move(*ranges);
  if (auto found = standardization_of(system_, module)) {
    standardizations_[module] = std::move(*found);
  }
  if (receptive_.contains(module)) return;
  const auto map = t_mpsom_of(system_, module);
  for (std::size_t i = 0; map && i < map->parameters().input_sizes.size(); ++i) {
    receptive_[module].push_back(shares(map->weights(i), map->arbor(i)));
  }
}

WeightFolding::Rows WeightFolding::fold(FoldedWeights weights) const {
  Rows rows;
  rows.reserve(ends_.size());
  fold(input_, std::move(weights), start_, 0, rows);
  return rows;
}

void WeightFolding::fold(std::size_t module, FoldedWeights weights, Way way, std::size_t depth,
                         Rows& rows) const {
  const Kind kind = whole_ ? Kind::kEnd : passage_through(system_, module, folded_).kind;
  if (kind == Kind::kEnd || depth > system_.modules().size()) {
    rows.push_back(dense(weights));
    return;
  }
  if (kind == Kind::kProduct) return fold_product(module, weights, way, depth, rows);
  if (kind == Kind::kConcatenation) return fold_concatenation(module, weights, way, depth, rows);
  if (kind == Kind::kTMpsom) return fold_t_mpsom(module, weights, way, depth, rows);
  if (kind == Kind::kOneHot) {
    weights = all_of(bin_centres(module, weights));
    way.single = true;
  }
  if (kind == Kind::kLeading || kind == Kind::kTrailing) {
    weights = all_of(sums_of_places(module, weights));
  }
  if (kind == Kind::kUndo && way.single) weights = all_of(undone(module, weights));
  fold(system_.modules()[module].inputs.front(), std::move(weights), way, depth + 1, rows);
}

// Element (i, j, ...) of the product belongs to i of the first input, j of the second, ... It is 0
// unless all of its factors are there, so that they share a contribution equally.
void WeightFolding::fold_product(std::size_t module, const FoldedWeights& weights, Way way,
                                 std::size_t depth, Rows& rows) const {
  way.single = false;
  std::size_t after = weights.size;
  const auto factors = static_cast<double>(system_.modules()[module].inputs.size());
  const double share = folded_ == Folded::kContributions ? 1.0 / factors : 1.0;
  for (const std::size_t input : system_.modules()[module].inputs) {
    const std::size_t size = size_of(input);
    after /= size;
    std::vector<double> sums(size);
    for (std::size_t i = 0; i < weights.values.size(); ++i) {
      sums[place(weights, i) / after % size] += share * weights.values[i];
    }
    fold(input, all_of(std::move(sums)), way, depth + 1, rows);
  }
}

void WeightFolding::fold_concatenation(std::size_t module, const FoldedWeights& weights, Way way,
                                       std::size_t depth, Rows& rows) const {
  std::size_t first = 0;
  std::size_t next = 0;
  for (const std::size_t input : system_.modules()[module].inputs) {
    std::vector<double> own(size_of(input));
    for (; next < weights.values.size() && place(weights, next) < first + own.size(); ++next) {
      own[place(weights, next) - first] = weights.values[next];
    }
    first += own.size();
    fold(input, all_of(std::move(own)), way, depth + 1, rows);
  }
}

void WeightFolding::fold_t_mpsom(std::size_t module, const FoldedWeights& weights, Way way,
                                 std::size_t depth, Rows& rows) const {
  way.single = false;
  const std::vector<Matrix<float>>& receptive = receptive_.at(module);
  for (std::size_t a = 0; a < receptive.size(); ++a) {
    std::vector<double> sums(receptive[a].columns());
    for (std::size_t i = 0; i < weights.values.size(); ++i) {
      const auto shares = receptive[a].row(place(weights, i));
      for (std::size_t k = 0; k < sums.size(); ++k)
        sums[k] += weights.values[i] * double{shares[k]};
    }
    fold(system_.modules()[module].inputs[a], all_of(std::move(sums)), way, depth + 1, rows);
  }
}

// The sums of the output's elements that belong to each element of the first input.
std::vector<double> WeightFolding::sums_of_places(std::size_t module,
                                                  const FoldedWeights& weights) const {
  const std::size_t size = size_of(system_.modules()[module].inputs.front());
  const bool leads = passage_through(system_, module, folded_).kind == Kind::kLeading;
  const std::size_t each = weights.size / size;
  std::vector<double> sums(size);
  for (std::size_t i = 0; i < weights.values.size(); ++i) {
    const std::size_t at = place(weights, i);
    sums[leads ? at / each : at % size] += weights.values[i];
  }
  return sums;
}

std::vector<double> WeightFolding::bin_centres(std::size_t module,
                                               const FoldedWeights& weights) const {
  const auto& ranges = ranges_.at(module);
  const std::size_t bins = weights.size / ranges.size();
  std::vector<double> sums(ranges.size());
  std::vector<double> means(ranges.size());
  for (std::size_t i = 0; i < weights.values.size(); ++i) {
    const std::size_t element = place(weights, i) / bins;
    const auto [low, high] = ranges[element];
    const double share =
        (static_cast<double>(place(weights, i) % bins) + 0.5) / static_cast<double>(bins);
    const double weight = std::max(0.0, weights.values[i]);
    sums[element] += weight;
    means[element] += weight * (low + share * (high - low));
  }
  for (std::size_t i = 0; i < means.size(); ++i) {
    means[i] = sums[i] > 0.0 ? means[i] / sums[i] : std::numeric_limits<double>::quiet_NaN();
  }
  return means;
}

// Before a standardization, a logarithm, or a factor and an offset.
std::vector<double> WeightFolding::undone(std::size_t module, const FoldedWeights& weights) const {
  std::vector<double> values = dense(weights);
  if (system_.modules()[module].type->name == "logarithm") {
    const double unit = setting(system_, module, "unit", LogarithmParameters{}.unit);
    for (double& value : values) value = inverse_signed_logarithm(value, unit);
    return values;
  }
  const auto found = standardizations_.find(module);
  const double factor = setting(system_, module, "factor", 1.0);
  const double offset = setting(system_, module, "offset", 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (found != standardizations_.end()) {
      values[i] = values[i] * found->second.deviations[i] + found->second.means[i];
    } else if (factor != 0.0) {
      values[i] = (values[i] - offset) / factor;
    }
  }
  return values;
}

}  // namespace somato::detail
