#include "somato/maps/refinement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <utility>

#include "base/core/dense_rows.h"
#include "maps/reading/winner_search.h"
#include "maps/som/fill_from_winner.h"
#include "maps/som/map_rows.h"
#include "maps/som/som_preparation.h"
#include "maps/som/stop.h"
#include "maps/training/glvq.h"
#include "somato/core/check.h"
#include "somato/maps/som_measures.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

using SampleClasses = std::vector<std::optional<std::size_t>>;

// The samples that have a class.
struct LabelledSamples {
  Samples samples;
  std::vector<std::size_t> classes;
};

LabelledSamples labelled_of(const Samples& samples, const SampleClasses& classes) {
  LabelledSamples labelled{samples, {}};
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (!classes[i]) continue;
    numbers.push_back(i);
    labelled.classes.push_back(*classes[i]);
  }
  if (numbers.size() < samples.count()) labelled.samples = samples.subset(numbers);
  return labelled;
}

std::set<std::size_t> distinct(const std::vector<std::size_t>& classes) {
  return {classes.begin(), classes.end()};
}

Result<void> check_classes(const LabelledSamples& labelled) {
  if (distinct(labelled.classes).size() >= 2) return {};
  return fail(ErrorKind::kData,
              "a map is refined by samples of at least two classes, and these have fewer", {},
              "label samples of another class as well, or leave the refinement out");
}

// Missing elements have no effect on it.
Result<void> check_known_range(const Samples& samples) {
  Matrix<float> rows = dense_rows(samples);
  for (float& value : rows.values()) value = std::isnan(value) ? 0.0F : value;
  return check_range(Samples(std::move(rows)));
}

MapOrder order_of(const Som& som, const Samples& samples, bool incomplete, std::size_t threads) {
  constexpr std::size_t kRankedSamples = 500;  // a comparison of each pair takes less than training
  MeasureParameters parameters;
  parameters.ranked_samples = kRankedSamples;
  const SomMeasures measured =
      measure_som(som, incomplete ? filled_from_winners(som, samples) : samples,
                  {SomMeasure::kQuantizationError, SomMeasure::kTopographicError,
                   SomMeasure::kTrustworthiness, SomMeasure::kContinuity},
                  parameters, {}, threads);
  return {measured.values.at(SomMeasure::kQuantizationError),
          measured.values.at(SomMeasure::kTopographicError),
          measured.values.at(SomMeasure::kTrustworthiness),
          measured.values.at(SomMeasure::kContinuity)};
}

// Whether two samples differ in an element. The unit of a relevance must not depend on the others.
std::vector<bool> varying_elements(const Samples& seen) {
  std::vector<float> first(seen.size(), std::numeric_limits<float>::quiet_NaN());
  std::vector<bool> varying(seen.size(), false);
  std::vector<float> row(seen.size());
  for (std::size_t i = 0; i < seen.count(); ++i) {
    write_dense(seen[i], row);
    for (std::size_t d = 0; d < row.size(); ++d) {
      if (std::isnan(row[d])) continue;
      if (std::isnan(first[d])) first[d] = row[d];
      if (row[d] != first[d]) varying[d] = true;
    }
  }
  return varying;
}

// From start to end over all passes; the learning rates fall to 0 at the end.
GlvqStep step_at(const RefinementParameters& p, std::uint64_t done, std::uint64_t total) {
  const double part = static_cast<double>(done) / static_cast<double>(total);
  const bool relevances = p.refine == Refinement::kGrlvq;
  return {
      p.refine_learning_rate * (1.0 - part),
      std::fma(part, p.refine_steepness_end - p.refine_steepness_start, p.refine_steepness_start),
      relevances ? p.refine_relevance_rate * (1.0 - part) : 0.0};
}

// `seen` without relevances, which `som` gets.
Result<void> run_passes(Som& som, Glvq& glvq, const Samples& seen,
                        const std::vector<std::size_t>& classes,
                        const RefinementParameters& parameters, const RefinementOptions& options) {
  constexpr std::uint64_t kSamplesBetweenReports = 64;
  constexpr std::uint64_t kSamplesBetweenUpdates = 64;  // of relevances, which change all weights
  const std::uint64_t total = parameters.refine_passes * seen.count();
  const Stop stop(options.progress, total, kSamplesBetweenReports);
  DrawSequence draws(Draws::kWithoutReplacement, seen.count(), options.seed);
  std::vector<float> row(seen.size());
  for (std::uint64_t done = 0; done < total; ++done) {
    const std::size_t sample = draws.next();
    write_dense(seen[sample], row);
    scale_elements(som.input_scales(), row);
    glvq.learn(row, classes[sample], step_at(parameters, done, total));
    const bool is_update = (done + 1) % kSamplesBetweenUpdates == 0 || done + 1 == total;
    if (parameters.refine == Refinement::kGrlvq && is_update) glvq.update_relevances();
    if (stop.after(done + 1)) return Stop::error();
  }
  return {};
}

// A copy whose weights may change, for all elements of the samples.
Result<Som> map_for(const Som& som, const Samples& samples, Refinement refinement) {
  const bool fits = refinement == Refinement::kGlvq && has_weights_for(som, samples);
  SOMATO_TRY_VOID(check_memory(som.parameters(), fits ? som.elements().count() : som.input_size()));
  Som changing = som;
  weights_to_change(changing);
  if (!fits) changing.store_all();
  return changing;
}

Result<void> check_input(const Som& som, const LabelledSamples& labelled, bool incomplete) {
  SOMATO_TRY_VOID(check_classes(labelled));
  if (incomplete) {
    SOMATO_TRY_VOID(check_takes_incomplete(som));
    return check_known_range(labelled.samples);
  }
  Samples storage;
  return check_range(prepared_samples(som.parameters(), labelled.samples, storage));
}

std::size_t without_neuron(const std::vector<std::size_t>& of_neuron,
                           const std::vector<std::size_t>& classes) {
  std::set<std::size_t> without = distinct(classes);
  for (const std::size_t one : of_neuron) without.erase(one);
  return without.size();
}

}  // namespace

const std::vector<std::pair<Refinement, std::string>>& Choices<Refinement>::all() {
  static const std::vector<std::pair<Refinement, std::string>> choices{
      {Refinement::kNone, "none"}, {Refinement::kGlvq, "glvq"}, {Refinement::kGrlvq, "grlvq"}};
  return choices;
}

const Declarations<RefinementParameters>& RefinementParameters::declarations() {
  using P = RefinementParameters;
  static const auto declared =
      Declarations<P>()
          .add("refine", &P::refine, "", Range::any(),
               "Whether labels move the neurons of the trained map: glvq is generalized learning "
               "vector quantization (Sato and Yamada, 1996), for the Euclidean and the manhattan "
               "distance; grlvq also learns how much each element of the input counts in the "
               "distance (Hammer and Villmann, 2002). "
               "Classes are recognized better, and neighbouring neurons are less alike. "
               "The papers train without labels.")
          .add("refine_passes", &P::refine_passes, "passes over all samples",
               Range::between(1, 1e6),
               "Length of the refinement. Our choice: 60 passes are no better on the "
               "grasps of 10 objects that docs/mathematics/refinement.md describes.")
          .add("refine_learning_rate", &P::refine_learning_rate, "", Range::between(0, 0.5),
               "Learning rate at the start, which falls to 0 as a line. Our choice: "
               "0.05 to 0.2 are equally good on these grasps, and beyond 0.5 a neuron could pass "
               "the sample.")
          .add("refine_steepness_start", &P::refine_steepness_start, "", Range::above(0),
               "Steepness of the sigmoid at the start: with a low one all samples count alike. Our "
               "choice; Sato and Yamada let it increase with time.")
          .add("refine_steepness_end", &P::refine_steepness_end, "", Range::above(0),
               "Steepness of the sigmoid at the end, reached as a line: with a high one only "
               "samples between two classes count. Our choice: 15 to 60 differ by at "
               "most 5 points on these grasps.")
          .add("refine_neighbours", &P::refine_neighbours, "", Range::between(0, 1),
               "Share of a step by which adjacent neurons of the same class follow the nearest "
               "one, so that the map keeps more of its order; 0 as in Sato and Yamada, 1: as much "
               "as "
               "the nearest. Our choice: 0.3 reduces the topographic error of these grasps "
               "by a fifth to two fifths at the same accuracy.")
          .add(
              "refine_relevance_rate", &P::refine_relevance_rate, "", Range::between(0, 1),
              "With grlvq: by how much the relevance of an element changes with a sample, relative "
              "to its own size, at the start; it falls to 0 as a line. Our choice, of 0.01, 0.03, "
              "0.1 and 0.3 by inner folds of the grasps of 41 objects; with 0.1 a Manhattan map "
              "uses few elements and is no better than by glvq.");
  return declared;
}

std::string reason_without_effect(const RefinementParameters& parameters, std::string_view name) {
  if (!name.starts_with("refine_")) return "";
  if (parameters.refine == Refinement::kNone) return "refine is none";
  const bool of_relevances = name == "refine_relevance_rate";
  return of_relevances && parameters.refine == Refinement::kGlvq ? "refine is glvq" : "";
}

Result<void> check_refinement(const RefinementParameters& parameters, const SomParameters& som) {
  if (parameters.refine == Refinement::kNone) return {};
  if (!som.layers.empty()) {
    return fail(ErrorKind::kUsage, "a map with layers cannot be refined by labels", "refine",
                "leave the layers or 'refine' out");
  }
  if (!som.relevances.empty()) {
    return fail(ErrorKind::kUsage, "the map has relevances, which labels have refined already",
                "refine", "refine the map as it was trained, or leave 'refine' out");
  }
  if (som.similarity == Similarity::kEuclidean || som.similarity == Similarity::kManhattan) {
    return {};
  }
  return fail(ErrorKind::kUsage,
              fmt::format("a map of similarity '{}' cannot be refined by labels: a step of {} is "
                          "defined for the Euclidean and the manhattan distance",
                          choice_name(som.similarity), choice_name(parameters.refine)),
              "refine", "choose one of these as 'similarity', or leave 'refine' out");
}

Result<RefinedSom> refine_som(const Som& som, const Samples& samples, const SampleClasses& classes,
                              const RefinementParameters& parameters,
                              const RefinementOptions& options) {
  require(samples.size() == som.input_size(),
          "the samples' size differs from the map's input size");
  require(classes.size() == samples.count(), "a refinement needs a class, or none, of each sample");
  require(check_ranges(parameters).has_value(), "a parameter of the refinement is out of range");
  SOMATO_TRY_VOID(check_refinement(parameters, som.parameters()));
  const bool incomplete = has_missing(samples);
  const LabelledSamples labelled = labelled_of(samples, classes);
  if (parameters.refine != Refinement::kNone) {
    SOMATO_TRY_VOID(check_input(som, labelled, incomplete));
  }
  const MapOrder before = order_of(som, samples, incomplete, options.threads);
  if (parameters.refine == Refinement::kNone) return RefinedSom{som, {before, before}};
  SOMATO_TRY(auto changing, map_for(som, labelled.samples, parameters.refine));
  RefinedSom refined{std::move(changing), {before, {}}};
  Samples storage;
  const Samples& seen = seen_samples(refined.som, labelled.samples, storage);
  NeuronClasses found = classes_of_neurons(refined.som, seen, labelled.classes);
  refined.order.named_by_nearest = found.named_by_nearest;
  refined.order.classes_without_neuron = without_neuron(found.of_neuron, labelled.classes);
  const bool relevances = parameters.refine == Refinement::kGrlvq;
  Glvq glvq(refined.som, std::move(found.of_neuron), parameters.refine_neighbours,
            relevances ? varying_elements(seen) : std::vector<bool>());
  SOMATO_TRY_VOID(run_passes(refined.som, glvq, seen, labelled.classes, parameters, options));
  refined.order.after = order_of(refined.som, samples, incomplete, options.threads);
  return refined;
}

}  // namespace somato
