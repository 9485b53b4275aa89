#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/core/random.h"
#include "somato/core/samples.h"
#include "somato/maps/som_parameters.h"

namespace somato::testing {

/// One kind of map: what laws are tried on, once for all.
struct Variant {
  Lattice lattice;
  Topology topology;
  Similarity similarity;
  NeighbourhoodShape neighbourhood;
};

inline std::vector<Similarity> all_similarities() {
  std::vector<Similarity> similarities;
  for (const auto& [similarity, name] : Choices<Similarity>::all()) {
    similarities.push_back(similarity);
  }
  return similarities;
}

/// The neighbourhoods that are never negative, so that an update never moves a weight away from the
/// sample.
inline std::vector<NeighbourhoodShape> shapes_that_attract() {
  std::vector<NeighbourhoodShape> shapes;
  for (const auto& [shape, name] : Choices<NeighbourhoodShape>::all()) {
    if (shape != NeighbourhoodShape::kMexicanHat) shapes.push_back(shape);
  }
  return shapes;
}

/// The neighbourhoods that laws of a similarity are tried with: all with the Euclidean distance,
/// otherwise two, because a neighbourhood does not depend on the similarity.
inline std::vector<NeighbourhoodShape> shapes_with(Similarity similarity) {
  return similarity == Similarity::kEuclidean
             ? shapes_that_attract()
             : std::vector{NeighbourhoodShape::kGaussian, NeighbourhoodShape::kBubble};
}

/// All kinds that attract.
inline std::vector<Variant> all_variants() {
  std::vector<Variant> variants;
  for (const Lattice lattice : {Lattice::kRectangular, Lattice::kHexagonal}) {
    for (const Topology topology : {Topology::kPlane, Topology::kTorus}) {
      for (const Similarity similarity : all_similarities()) {
        for (const NeighbourhoodShape shape : shapes_with(similarity)) {
          variants.push_back({lattice, topology, similarity, shape});
        }
      }
    }
  }
  return variants;
}

/// Kinds for costly laws, a third of all: every two values of different properties that meet in all
/// kinds meet in one of these. Each shape of the Euclidean distance has both topologies, one with
/// each lattice; the two shapes of another similarity share these.
inline std::vector<Variant> variants_in_pairs() {
  std::vector<Variant> variants;
  std::size_t number = 0;
  for (const Similarity similarity : all_similarities()) {
    const auto shapes = shapes_with(similarity);
    const bool is_euclidean = similarity == Similarity::kEuclidean;
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      const bool is_crossed = (number + (is_euclidean ? s : 0)) % 2 == 1;
      for (const Topology topology : {Topology::kPlane, Topology::kTorus}) {
        const bool is_torus = topology == Topology::kTorus;
        if (!is_euclidean && is_torus != (s % 2 == 1)) continue;
        const bool is_hexagonal = is_torus != is_crossed;
        variants.push_back({is_hexagonal ? Lattice::kHexagonal : Lattice::kRectangular, topology,
                            similarity, shapes[s]});
      }
    }
    ++number;
  }
  return variants;
}

/// The kinds that can train by inner products.
inline std::vector<Variant> variants_by_products() {
  std::vector<Variant> variants = all_variants();
  std::erase_if(variants,
                [](const Variant& variant) { return !follows_from_products(variant.similarity); });
  return variants;
}

inline std::string name_of(const Variant& variant) {
  return choice_name(variant.lattice) + "_" + choice_name(variant.topology) + "_" +
         choice_name(variant.similarity) + "_" + choice_name(variant.neighbourhood);
}

/// Parameters of that kind with a small map of random size.
inline SomParameters random_parameters(const Variant& variant, Random& random) {
  SomParameters parameters;
  parameters.lattice = variant.lattice;
  parameters.topology = variant.topology;
  parameters.similarity = variant.similarity;
  parameters.neighbourhood = variant.neighbourhood;
  const bool even = variant.lattice == Lattice::kHexagonal && variant.topology == Topology::kTorus;
  parameters.rows = even ? 2 * (1 + random.below(3)) : 1 + random.below(6);
  parameters.columns = 1 + random.below(6);
  parameters.radius_start = 3.0 * random.uniform();
  parameters.radius_end = *parameters.radius_start * random.uniform();
  parameters.learning_rate_start = random.uniform();
  parameters.learning_rate_end = parameters.learning_rate_start * random.uniform();
  parameters.seed = random.next();
  return parameters;
}

/// Random samples, dense, or sparse with about a third of the elements.
inline Samples random_samples(std::size_t count, std::size_t size, bool sparse, Random& random) {
  std::vector<Signal> signals;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::uint32_t> indices;
    std::vector<float> values;
    for (std::uint32_t d = 0; d < size; ++d) {
      if (sparse && random.below(3) != 0) continue;
      indices.push_back(d);
      values.push_back(static_cast<float>(random.normal()));
    }
    signals.push_back(sparse ? Signal::sparse({size}, indices, values) : Signal::dense(values));
  }
  return Samples::from_signals(signals);
}

}  // namespace somato::testing
