#include "somato/maps/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "maps/reading/similarity_scores.h"
#include "maps/som/fill_from_winner.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr std::size_t kMostSamplesOfScale = 300;

tl::unexpected<Error> wrong_layer(std::string what, std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), "layers", std::move(advice));
}

Result<void> check_layer(const Layer& layer) {
  const auto is_positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (layer.name.empty()) return wrong_layer("a layer has no name", "name each layer");
  if (layer.similarity == Similarity::kDotProduct) {
    return wrong_layer(
        fmt::format("layer '{}' needs a distance, which 'dot_product' is not", layer.name),
        "choose euclidean, manhattan, chebyshev or cosine");
  }
  if (!is_positive(layer.weight) || !is_positive(layer.scale.value_or(1.0))) {
    return wrong_layer(
        fmt::format("weight and scale of layer '{}' must be above 0 and finite", layer.name),
        "correct it, or leave the layer out");
  }
  return {};
}

// The samples of all pairs of which the mean distance is taken.
std::vector<std::vector<float>> samples_of_scale(const Samples& samples) {
  const std::size_t count = std::min(samples.count(), kMostSamplesOfScale);
  std::vector<std::vector<float>> chosen(count, std::vector<float>(samples.size()));
  for (std::size_t i = 0; i < count; ++i) {
    write_dense(samples[i * samples.count() / count], chosen[i]);
  }
  return chosen;
}

double mean_distance(const Layer& layer, const std::vector<std::vector<float>>& samples) {
  double sum = 0.0;
  std::size_t pairs = 0;
  for (std::size_t a = 0; a < samples.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b, ++pairs) {
      sum += distance_between(layer.similarity,
                              std::span(samples[a]).subspan(layer.first, layer.count),
                              std::span(samples[b]).subspan(layer.first, layer.count));
    }
  }
  return pairs > 0 ? sum / static_cast<double>(pairs) : 0.0;
}

}  // namespace

double factor_of(const Layer& layer) {
  return layer.weight / layer.scale.value_or(1.0);
}

Result<void> check_layers(const SomParameters& parameters, std::size_t elements) {
  if (parameters.layers.empty()) return {};
  if (parameters.similarity != Similarity::kEuclidean) {
    return fail(without_effect("similarity", "each layer has a distance", "layers"));
  }
  if (parameters.normalize_input.value_or(false)) {
    return wrong_layer("'normalize_input' would scale all layers together",
                       "scale the columns of each layer before");
  }
  std::size_t end = 0;
  std::set<std::string> names;
  for (const Layer& layer : parameters.layers) {
    SOMATO_TRY_VOID(check_layer(layer));
    if (!names.insert(layer.name).second) {
      return wrong_layer(fmt::format("two layers are named '{}'", layer.name), "rename one");
    }
    if (layer.first != end || layer.count == 0) {
      return wrong_layer(
          fmt::format("layer '{}' does not begin where the layer before it ends", layer.name),
          "put each column into one layer, in the order of the columns");
    }
    end += layer.count;
  }
  if (end == elements) return {};
  return wrong_layer(fmt::format("the layers have {} columns, and the data {}", end, elements),
                     "put each column into one layer, or leave it out");
}

Result<void> check_scales(const SomParameters& parameters) {
  for (const Layer& layer : parameters.layers) {
    if (!layer.scale) {
      return wrong_layer(
          fmt::format("the scale of layer '{}' needs all samples in memory", layer.name),
          "give its scale");
    }
    if (*layer.scale > 0.0) continue;
    return fail(
        ErrorKind::kData,
        fmt::format("all samples are alike in layer '{}', which leaves its scale open", layer.name),
        "layers", "leave the layer out, or give its scale");
  }
  return {};
}

SomParameters with_scales(SomParameters parameters, const Samples& samples) {
  const auto has_scale = [](const Layer& layer) { return layer.scale.has_value(); };
  if (std::all_of(parameters.layers.begin(), parameters.layers.end(), has_scale)) {
    return parameters;
  }
  const std::vector<std::vector<float>> chosen = samples_of_scale(samples);
  for (Layer& layer : parameters.layers) {
    if (!layer.scale) layer.scale = mean_distance(layer, chosen);
  }
  return parameters;
}

Result<Layer> layer_named(const SomParameters& parameters, const std::string& name) {
  std::string names;
  for (const Layer& layer : parameters.layers) {
    names += (names.empty() ? "" : ", ") + layer.name;
    if (layer.name != name) continue;
    if (parameters.layers.size() > 1) return layer;
    return fail(ErrorKind::kUsage,
                fmt::format("'{}' is the map's only layer, which no other predicts", name), {},
                "train a map with several layers");
  }
  return fail(ErrorKind::kUsage, fmt::format("the map has no layer '{}'", name), {},
              names.empty() ? "train a map with layers" : "its layers are " + names);
}

Matrix<float> predict_layer(const Som& som, const Layer& layer, const Samples& samples,
                            std::size_t threads) {
  require(samples.size() == som.input_size(), "samples have as many elements as the map's inputs");
  require(layer.first + layer.count <= som.input_size(), "a layer lies outside the map's inputs");
  Matrix<float> rows(samples.count(), samples.size());
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    write_dense(samples[i], rows.row(i));
    std::fill_n(rows.row(i).begin() + static_cast<std::ptrdiff_t>(layer.first), layer.count,
                std::numeric_limits<float>::quiet_NaN());
  }
  const std::vector<std::size_t> winners = winners_by_known(som, Samples(std::move(rows)), threads);
  Matrix<float> predicted(winners.size(), layer.count);
  for (std::size_t i = 0; i < winners.size(); ++i) {
    for (std::size_t d = 0; d < layer.count; ++d) {
      predicted(i, d) = som.weight(winners[i], layer.first + d);
    }
  }
  return predicted;
}

}  // namespace somato
