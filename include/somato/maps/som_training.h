#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/process_group.h"
#include "somato/core/progress.h"
#include "somato/core/random.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// A snapshot of training, after `step` of `steps` iterations, or epochs in batch training.
struct TrainingMoment {
  std::uint64_t step = 0;
  std::uint64_t steps = 0;
  double learning_rate = 0.0;  ///< The rate of the last iteration; 0 in batch training.
  double radius = 0.0;         ///< The radius of the last iteration or epoch.
  std::size_t weights = 0;     ///< Number of elements with stored weights.
  std::function<Som()> map;    ///< Returns the current map; training continues with the same bits.
};

/// Receives about a hundred snapshots, evenly distributed, and one after each check of the error in
/// training of automatic length; the last one after the last step. If it returns false, training
/// ends with an Error of kind kInterrupted.
using TrainingObserver = std::function<bool(const TrainingMoment&)>;

/// Options of training.
struct TrainingOptions {
  std::size_t threads = 1;  ///< Does not affect the map.
  Progress progress = {};   ///< In iterations, or epochs, or parts of samples in all epochs. If the
                            ///< length is automatic (SomParameters::tolerance), the total is that
                            ///< without further improvement, and grows with each improvement.
  TrainingObserver observer = {};

  /// The numbers of the training samples, in this order; empty: all. The other samples do not
  /// affect the map, but in training by inner products it knows() them as well.
  std::optional<std::vector<std::size_t>> training = {};

  /// The same samples, dense, with NaN for missing elements; or nullptr. The map then learns from
  /// these: winners by known elements, and each weight from the samples that know its element
  /// (Samad and Harp, "Self-organization with partial data", Network 3, 1992). Only initial weights
  /// are those of the samples without missing elements. Only for samples in memory, in plain
  /// arithmetic, and maps whose distance is a sum or maximum over elements, without
  /// `normalize_input`; otherwise training fails with kUsage. Not together with `training`.
  const Samples* incomplete = nullptr;

  /// A trained map of the same size from whose weights training starts, with the schedule of a new
  /// training and in plain arithmetic; nullptr: initial weights. Only for samples in memory.
  const Som* start = nullptr;

  /// A file for the map after the last complete epoch of training from a SampleSource, which
  /// continues from it if it exists; or empty. The caller removes it after saving the map.
  std::string checkpoint = {};

  /// The processes that train the map together from a SampleSource, each from the samples of its
  /// own source: the samples of the first, then those of the second, and so on. The map has the
  /// same bits as from all samples in one process. Every process returns the same map, or the same
  /// error. nullptr: only this one.
  ProcessGroup* processes = nullptr;

  /// Set to the number of completed iterations or epochs, with those before a checkpoint, when
  /// training ends; or nullptr.
  std::uint64_t* steps_done = nullptr;
};

/// Trains a map on `samples`. If they are sparse and use fewer than half of the elements, and
/// initial weights are not uniform, the map only stores weights for the elements that they use: all
/// others would be exactly 0, and the stored ones have the same bits. The same parameters and
/// samples give the same bits for every number of threads, instruction set and compiler.
///
/// Fails with kUsage if the parameters contradict each other, with kData if there are no samples,
/// or if they have no elements or a length outside 1e-15 .. 1e18, with kInterrupted if the progress
/// requests to stop.
Result<Som> train_som(const SomParameters& parameters, const Samples& samples,
                      const TrainingOptions& options = {});

/// The same for one dense sample per row.
Result<Som> train_som(const SomParameters& parameters, const Matrix<float>& samples,
                      const TrainingOptions& options = {});

/// The same for samples that need not fit into memory, in batch training: the same bits as from
/// dense Samples, regardless of the division into parts. They are read once before training, once
/// more if initial weights are samples or linear, and once per epoch. Linear initial weights of
/// fewer samples than elements read all samples into memory.
///
/// Also fails if the source does, with kUsage for online training, which draws from all samples at
/// any time, and as save_whole() and read_whole() do for the checkpoint; kUsage if that is of
/// another training, kData if it is damaged.
Result<Som> train_som(const SomParameters& parameters, SampleSource& samples,
                      const TrainingOptions& options = {});

/// The initial map of train_som(), before any learning. `samples` determine automatic parameters
/// and initial weights. Fails like train_som().
Result<Som> untrained_som(const SomParameters& parameters, const Samples& samples);

/// The order of the samples in online training: a function of the seed.
class DrawSequence {
 public:
  DrawSequence(Draws draws, std::size_t samples, std::uint64_t seed);

  /// The number of the next sample.
  std::size_t next();

 private:
  Draws draws_;
  std::size_t samples_;
  Random random_;
  std::vector<std::size_t> left_;
};

/// The samples after the normalization of a map with these (resolved) parameters: `samples` itself,
/// or `storage` filled with samples scaled to length 1.
const Samples& prepared_samples(const SomParameters& parameters, const Samples& samples,
                                Samples& storage);

}  // namespace somato
