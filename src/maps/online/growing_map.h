#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/archives/archive.h"
#include "somato/core/matrix.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/labels.h"
#include "somato/maps/som.h"
#include "somato/maps/som_training.h"

namespace somato {

/// The parameters that all maps that grow have in common. declarations() gives the meaning, unit
/// and range of each.
struct GrowthParameters {
  std::optional<std::uint64_t> iterations;
  Draws draws = Draws::kWithoutReplacement;
  std::size_t most_neurons = 200;
  Softmax softmax = Softmax::kPower;
  double softmax_exponent = 10.0;
  ActivityNorm activity_norm = ActivityNorm::kMaximum;
  std::uint64_t seed = 1;

  static const Declarations<GrowthParameters>& declarations();
};

/// Samples, with the class of each if a map learns their names.
struct NamedSamples {
  Samples samples;
  std::vector<std::size_t> classes = {};
};

/// A map that adds neurons while it learns. Its winner is the neuron with the smallest distance
/// from an input: the Euclidean one, unless the kind of map has another similarity.
class GrowingMap {
 public:
  GrowingMap() = default;
  GrowingMap(GrowingMap&&) = delete;
  GrowingMap& operator=(const GrowingMap&) = delete;
  GrowingMap& operator=(GrowingMap&&) = delete;
  virtual ~GrowingMap() = default;

  /// The same map, which learns in the same way.
  virtual std::unique_ptr<GrowingMap> copy() const = 0;

  /// Learns an input, and grows if its rule says so.
  virtual void learn(std::span<const float> input) = 0;

  /// Learns an input with its class; a map that does not learn names ignores it.
  virtual void learn_named(std::span<const float> input, std::size_t /*the_class*/) {
    learn(input);
  }

  /// Sees samples once, before it learns from them in addition to what it has learned.
  virtual void see(const NamedSamples& /*samples*/) {}

  /// Takes the weights of `refined`, the same map after a refinement by labels, with the class of
  /// each neuron. Throws InvalidArgument unless the map learns names.
  virtual void refine(const Som& refined, const std::vector<std::size_t>& classes);

  /// Whether learning ends by itself: further inputs are ignored.
  virtual bool is_complete() const { return false; }

  virtual std::size_t neurons() const = 0;

  /// The present map. Learning is not affected.
  virtual Som map() const = 0;

  /// Adds a neuron with the weights `input`, with the highest number; no other neuron changes its
  /// weights. Returns false, and changes nothing, if the map cannot add a single neuron or is full.
  /// A map that learns names gives the neuron that of the class.
  virtual bool add_at(std::span<const float> /*input*/, std::size_t /*the_class*/) { return false; }

  /// Gives a neuron the weights `input`, and, if it learns names, that of the class; all else
  /// remains.
  virtual void place(std::size_t neuron, std::span<const float> input, std::size_t the_class) = 0;

  /// Prepares further learning: neurons are numbered anew, and a map whose learning has ended by
  /// itself tunes its weights again.
  virtual void resume() = 0;

  /// For each neuron its number at the last resume().
  virtual const NeuronOrigins& origins() const = 0;

  /// Adds to an archive what learning requires in addition to map(), under names that begin with
  /// `prefix`, and reads it back into a map that was made from the same map().
  virtual void save(Archive& archive, const std::string& prefix) const = 0;
  virtual Result<void> load(const Archive& archive, const std::string& prefix,
                            const std::string& where) = 0;

 protected:
  GrowingMap(const GrowingMap&) = default;
};

/// Learns `iterations` draws from `samples`, or fewer if the map is complete before. `parameters`
/// must have iterations. The number of neurons reported to the observer is that of the moment.
/// Fails with kInterrupted if progress or observer request to stop.
Result<void> grow(GrowingMap& map, const GrowthParameters& parameters, const NamedSamples& samples,
                  const Progress& progress, const TrainingObserver& observer);

/// Refuses (kData) samples that a map cannot learn; see train_som().
Result<void> check_growing(const Samples& samples);

/// How distances of vectors are compared: by their squares if they are Euclidean, otherwise by
/// themselves. `similarity` is that, or Manhattan.
double distance_score(Similarity similarity, std::span<const float> a, std::span<const float> b);

/// The distance with that score.
double distance_of_score(Similarity similarity, double score);

/// The weights of neurons, a row each, which learn one by one.
class GrowingWeights {
 public:
  explicit GrowingWeights(std::size_t inputs, Similarity similarity = Similarity::kEuclidean)
      : similarity_(similarity), rows_(0, inputs) {}
  explicit GrowingWeights(const Som& som);

  std::size_t neurons() const { return rows_.rows(); }
  std::span<const float> operator[](std::size_t neuron) const { return rows_.row(neuron); }
  const Matrix<float>& rows() const { return rows_; }

  /// For each neuron its number at the last call of number_anew(); none for a neuron that was added
  /// since.
  const NeuronOrigins& origins() const { return origins_; }
  void number_anew();

  /// Adds a neuron with these weights.
  void add(std::span<const float> weights);

  /// Adds neuron `neuron` of `others`, with its origin.
  void add_from(const GrowingWeights& others, std::size_t neuron);

  /// Adds a neuron with the mean of two vectors as weights.
  void add_between(std::span<const float> a, std::span<const float> b);

  /// Removes neurons (ascending); the others keep their order.
  void remove(const std::vector<std::size_t>& neurons);

  /// w = input.
  void place(std::size_t neuron, std::span<const float> input);

  /// w += rate (input - w).
  void move(std::size_t neuron, std::span<const float> input, double rate);

  /// The squared Euclidean distance of two vectors, in double precision.
  static double squared_distance(std::span<const float> a, std::span<const float> b);

  /// The distance of a neuron from `input` by the similarity.
  double distance(std::size_t neuron, std::span<const float> input) const;

  /// The two neurons nearest to `input` by the similarity; in a tie the first ones.
  Winners nearest_two(std::span<const float> input) const;

  /// The neuron nearest to `input` among those that `counts` accepts, the first in a tie; none if
  /// it accepts none.
  template <typename Counts>
  std::optional<std::size_t> nearest_of(std::span<const float> input, const Counts& counts) const {
    std::optional<std::size_t> nearest;
    double least = 0.0;
    for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
      if (!counts(neuron)) continue;
      const double score = distance_score(similarity_, rows_.row(neuron), input);
      if (nearest && score >= least) continue;
      least = score;
      nearest = neuron;
    }
    return nearest;
  }

  /// The two neurons nearest to each other, the lower number first; in a tie the first ones. There
  /// must be two.
  std::pair<std::size_t, std::size_t> nearest_pair() const;

  bool operator==(const GrowingWeights&) const = default;

 private:
  Similarity similarity_;
  Matrix<float> rows_;
  NeuronOrigins origins_;
};

/// Reads an array of `count` integers from 0 to `most` from an archive. Errors (kData, at `where`):
/// missing, or of another type, size or range.
Result<std::vector<std::uint64_t>> counts_from(const Archive& archive, const std::string& name,
                                               std::size_t count, std::uint64_t most,
                                               const std::string& where);

/// Reads an array of `count` finite numbers from `least` to `most`, with the same errors.
Result<std::vector<double>> numbers_from(const Archive& archive, const std::string& name,
                                         std::size_t count, double least, double most,
                                         const std::string& where);

/// Adds an array of integers.
void add_counts(Archive& archive, std::string name, const std::vector<std::uint64_t>& counts);

/// The number of each of `neurons` neurons after `removed` ones (ascending) are removed; empty for
/// these.
std::vector<std::optional<std::size_t>> numbers_after(std::size_t neurons,
                                                      const std::vector<std::size_t>& removed);

/// The numbers of the samples that are the first weights of `count` neurons: drawn at random,
/// without repeats if there are enough.
std::vector<std::size_t> drawn_samples(const Samples& samples, std::size_t count,
                                       std::uint64_t seed);

/// The weights of that many neurons.
GrowingWeights drawn_weights(const Samples& samples, std::size_t count, std::uint64_t seed,
                             Similarity similarity = Similarity::kEuclidean);

/// The parameters of the map that grew: one row with a column for each neuron.
SomParameters parameters_of_grown(const GrowthParameters& parameters, std::size_t rows,
                                  std::size_t columns,
                                  Similarity similarity = Similarity::kEuclidean);

}  // namespace somato
