#include "somato/maps/contributions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "maps/reading/known_elements.h"
#include "maps/reading/sample_reader.h"
#include "maps/reading/similarity_scores.h"
#include "somato/core/check.h"
#include "somato/maps/layers.h"

namespace somato {
namespace {

// Input and weights for the stored elements. Those that are missing are 0 in all three vectors, so
// that no distance, product or length depends on them.
struct Compared {
  std::vector<float> x;
  std::vector<float> a;
  std::vector<float> b;
  double left_out = 0.0;  // as in distance_between()
};

struct ComparedPart {
  std::span<const float> x;
  std::span<const float> a;
  std::span<const float> b;
};

Signal without_missing(const SignalView& input) {
  Signal known = Signal::copy_of(input);
  for (float& value : known.values()) {
    if (std::isnan(value)) value = 0.0F;
  }
  return known;
}

double length_of(std::span<const float> values, double left_out = 0.0) {
  double sum = left_out;
  for (const float value : values) sum = std::fma(double{value}, double{value}, sum);
  return std::sqrt(sum);
}

double inverse_or_zero(double value) {
  return value > 0.0 ? 1.0 / value : 0.0;
}

std::vector<float> row_of(const Som& som, std::size_t neuron) {
  std::vector<float> row(som.elements().count());
  som.weights().copy_row(neuron, row);
  return row;
}

Compared compare(const Som& som, const SignalView& input, DecidingNeurons neurons) {
  const StoredElements& elements = som.elements();
  const SomParameters& parameters = som.parameters();
  const Signal known = without_missing(input);
  const double length = length_of(known.values());
  const bool normalize = parameters.normalize_input.value_or(false) && length > 0.0;
  const double factor = normalize ? 1.0 / length : 1.0;
  Compared all{std::vector<float>(elements.count()), row_of(som, neurons.nearest),
               row_of(som, neurons.other)};
  all.left_out = elements.gather(known.view(), all.x, factor);
  if (parameters.similarity == Similarity::kManhattan) {
    all.left_out = elements.magnitude_of_others(known.view(), factor);
  }
  scale_elements(som.input_scales(), all.x);
  for (std::size_t i = 0; i < input.values.size(); ++i) {
    if (!std::isnan(input.values[i])) continue;
    const auto place = elements.place_of(input.sparse ? input.indices[i] : i);
    if (place) all.a[*place] = all.b[*place] = 0.0F;
  }
  return all;
}

double greatest_difference(std::span<const float> x, std::span<const float> w) {
  double most = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    most = std::max(most, std::fabs(double{x[i]} - double{w[i]}));
  }
  return most;
}

// Adds the greatest difference, times `factor`, to the elements that have it, in equal shares.
void share_greatest(std::span<const float> x, std::span<const float> w, double factor,
                    std::span<double> out) {
  const double most = greatest_difference(x, w);
  const auto has_most = [&](std::size_t i) {
    return std::fabs(double{x[i]} - double{w[i]}) == most;
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < x.size(); ++i) count += has_most(i) ? 1 : 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (has_most(i)) out[i] += factor * most / static_cast<double>(count);
  }
}

// (x - b)^2 - (x - a)^2 as a product, which is exactly 0 for equal weights.
void write_euclidean(const ComparedPart& part, double left_out, std::span<double> out) {
  const double both = distance_between(Similarity::kEuclidean, part.a, part.x, left_out) +
                      distance_between(Similarity::kEuclidean, part.b, part.x, left_out);
  if (both == 0.0) return;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double x = part.x[i];
    const double a = part.a[i];
    const double b = part.b[i];
    out[i] = (a - b) * ((x - a) + (x - b)) / both;
  }
}

void write_cosine(const ComparedPart& part, double left_out, std::span<double> out) {
  const double of_x = inverse_or_zero(length_of(part.x, left_out));
  const double of_a = inverse_or_zero(length_of(part.a));
  const double of_b = inverse_or_zero(length_of(part.b));
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = double{part.x[i]} * of_x * (double{part.a[i]} * of_a - double{part.b[i]} * of_b);
  }
}

// `out` is 0 before.
void write(Similarity similarity, const ComparedPart& part, double left_out,
           std::span<double> out) {
  if (similarity == Similarity::kEuclidean) return write_euclidean(part, left_out, out);
  if (similarity == Similarity::kCosine) return write_cosine(part, left_out, out);
  if (similarity == Similarity::kChebyshev) {
    share_greatest(part.x, part.b, 1.0, out);
    share_greatest(part.x, part.a, -1.0, out);
    return;
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double x = part.x[i];
    const double a = part.a[i];
    const double b = part.b[i];
    out[i] =
        similarity == Similarity::kManhattan ? std::fabs(x - b) - std::fabs(x - a) : x * (a - b);
  }
}

void write_layers(const SomParameters& parameters, const Compared& all, std::span<double> out) {
  for (const Layer& layer : parameters.layers) {
    const auto part_of = [&](const std::vector<float>& values) {
      return std::span(values).subspan(layer.first, layer.count);
    };
    const std::span<double> part = out.subspan(layer.first, layer.count);
    write(layer.similarity, {part_of(all.x), part_of(all.a), part_of(all.b)}, 0.0, part);
    for (double& value : part) value *= factor_of(layer);
  }
}

double product(std::span<const float> a, std::span<const float> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum = std::fma(double{a[i]}, double{b[i]}, sum);
  return sum;
}

// The map compares distances, or inner products.
double compared_value(const SomParameters& parameters, const Compared& all,
                      const std::vector<float>& weights) {
  const bool multiplies =
      parameters.layers.empty() && parameters.similarity == Similarity::kDotProduct;
  return multiplies ? product(weights, all.x)
                    : distance_between(parameters, weights, all.x, all.left_out);
}

std::vector<std::size_t> of_other_classes(const NeuronLabels& labels, std::size_t the_class) {
  std::vector<std::size_t> others;
  for (const std::size_t neuron : labels.labelled()) {
    if (*labels[neuron] != the_class) others.push_back(neuron);
  }
  return others;
}

}  // namespace

std::vector<DecidingNeurons> deciding_neurons(const Som& som, const NeuronLabels& labels,
                                              const Samples& samples, std::size_t threads) {
  require(labels.neurons() == som.neurons(), "labels need one entry for each neuron");
  require(!labels.labelled().empty() &&
              !of_other_classes(labels, *labels[labels.labelled().front()]).empty(),
          "two classes need a neuron each");
  const std::vector<std::size_t> nearest =
      SampleReader(som, threads, labels.labelled()).read(samples).nearest;
  std::vector<DecidingNeurons> deciding(samples.count());
  std::map<std::size_t, std::vector<std::size_t>> samples_of_class;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    deciding[i].nearest = nearest[i];
    samples_of_class[*labels[nearest[i]]].push_back(i);
  }
  for (const auto& [the_class, places] : samples_of_class) {
    const std::vector<std::size_t> others =
        SampleReader(som, threads, of_other_classes(labels, the_class))
            .read(samples.subset(places))
            .nearest;
    for (std::size_t i = 0; i < places.size(); ++i) deciding[places[i]].other = others[i];
  }
  return deciding;
}

Contributions contributions(const Som& som, const SignalView& input, DecidingNeurons neurons) {
  require(neurons.nearest < som.neurons() && neurons.other < som.neurons(),
          "the map does not have this neuron");
  require(input.size == som.input_size(), "the input's size differs from the map's input size");
  const Compared all = compare(som, input, neurons);
  const SomParameters& parameters = som.parameters();
  Contributions found{compared_value(parameters, all, all.a),
                      compared_value(parameters, all, all.b), std::vector<double>(all.x.size())};
  if (!parameters.layers.empty()) {
    write_layers(parameters, all, found.values);
  } else {
    write(parameters.similarity, {all.x, all.a, all.b}, all.left_out, found.values);
  }
  return found;
}

}  // namespace somato
