#include "somato/maps/som_training.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

#include "maps/products/product_weights.h"
#include "maps/som/fill_from_winner.h"
#include "maps/som/som_preparation.h"
#include "maps/som/stop.h"
#include "maps/training/batch_training.h"
#include "maps/training/length_checks.h"
#include "maps/training/moments.h"
#include "maps/training/online_training.h"
#include "maps/training/som_start.h"
#include "maps/training/source_preparation.h"
#include "maps/training/training_checkpoint.h"
#include "somato/core/check.h"
#include "somato/maps/layers.h"

namespace somato {
namespace {

// An epoch on the samples of a survey; stops after any part.
Result<void> train_epoch(Som& som, SampleSource& prepared, std::uint64_t epoch,
                         const SampleSurvey& survey, const TrainingOptions& options,
                         const Stop& stop, LengthChecks& checks) {
  const SumScales scales(survey.count, survey.low, survey.high);
  BatchEpoch training(som, scales, options.threads, options.incomplete != nullptr);
  const bool is_check = epoch >= som.parameters().epochs;
  if (is_check) training.measure(survey.longest);
  std::uint64_t done = epoch * survey.parts;
  const auto gone_through = for_each_part(prepared, [&](const Samples& part) -> Result<void> {
    training.add(part);
    ++done;
    if (done % survey.parts != 0 && stop.after(done)) return Stop::error();
    return {};
  });
  SOMATO_TRY_VOID(agreed(gone_through, options.processes));
  if (options.processes) training.combine(*options.processes);
  if (is_check) checks.add(training.mean_distance(survey.count));
  training.finish(som.parameters().radius().at(epoch));
  return {};
}

// The epochs from `first` on: `learn` is given the number of each, `map` gives the map after it.
Result<void> train_epochs(const Som& som, std::uint64_t first, std::uint64_t parts,
                          const TrainingOptions& options, const LengthChecks& checks,
                          const std::function<Result<void>(std::uint64_t, const Stop&)>& learn,
                          const std::function<Som()>& map) {
  const SomParameters& p = som.parameters();
  const auto total_after = [&](std::uint64_t epochs) {
    return std::max(epochs, p.epochs) + checks.checks_left();
  };
  Stop stop(options.progress, total_after(first) * parts, 1);
  const Moments moments(options.observer, som, p.epochs);
  std::uint64_t epoch = first;
  while (epoch < p.epochs || checks.go_on()) {
    SOMATO_TRY_VOID(learn(epoch, stop));
    const double radius = p.radius().at(epoch++);
    const std::uint64_t total = total_after(epoch);
    stop.set_total(total * parts);
    const bool stops =
        stop.after(epoch * parts) || moments.stop_after(epoch, total, 0.0, radius, map);
    SOMATO_TRY_VOID(
        agreed<void>(stops ? Result<void>(Stop::error()) : Result<void>(), options.processes));
  }
  if (options.steps_done) *options.steps_done = epoch;
  return {};
}

// Loads and saves the state after an epoch, if the options name a file for it.
class Checkpoints {
 public:
  Checkpoints(const TrainingOptions& options, const Som& som, const SampleSurvey& survey)
      : options_(options), identity_(training_identity(som.parameters(), survey)) {}

  // Returns the number of completed epochs, and sets the map and the checks after them. All
  // processes read the file, which they must share.
  Result<std::uint64_t> load(Som& som, LengthChecks& checks) const {
    if (options_.checkpoint.empty()) return 0;
    SOMATO_TRY(auto loaded,
               agreed(load_checkpoint(options_.checkpoint, identity_), options_.processes));
    const std::uint64_t epochs = loaded ? loaded->epochs : 0;
    SOMATO_TRY_VOID(agreed(check_shared(epochs), options_.processes));
    if (loaded) {
      som = std::move(loaded->som);
      checks.restore(loaded->checks);
    }
    return epochs;
  }

  Result<void> save(std::uint64_t epochs, const Som& som, const LengthChecks& checks) const {
    if (options_.checkpoint.empty()) return {};
    const bool saves = !options_.processes || options_.processes->is_first();
    return agreed(
        saves ? save_checkpoint(options_.checkpoint, identity_, {epochs, som, checks.state()})
              : Result<void>(),
        options_.processes);
  }

 private:
  Result<void> check_shared(std::uint64_t epochs) const {
    if (!options_.processes) return {};
    const auto own = static_cast<std::int64_t>(epochs);
    for (const std::int64_t of_other : options_.processes->gather(own)) {
      if (of_other == own) continue;
      return fail(ErrorKind::kSystem, "the processes do not see the same checkpoint",
                  options_.checkpoint, "use a file on a file system that all machines share");
    }
    return {};
  }

  const TrainingOptions& options_;
  std::string identity_;
};

Result<void> train_batch(SomStart& start, SampleSource& prepared, const SampleSurvey& survey,
                         const TrainingOptions& options) {
  Som& som = start.som;
  const Checkpoints checkpoints(options, som, survey);
  LengthChecks checks(som.parameters());
  SOMATO_TRY(const auto done, checkpoints.load(som, checks));
  return train_epochs(
      som, done, survey.parts, options, checks,
      [&](std::uint64_t epoch, const Stop& stop) {
        return train_epoch(som, prepared, epoch, survey, options, stop, checks).and_then([&] {
          return checkpoints.save(epoch + 1, som, checks);
        });
      },
      [&] { return start.whole(som); });
}

Result<void> train_batch_by_products(Som& som, const TrainingOptions& options) {
  const std::shared_ptr<const ProductWeights> before = som.products();
  ProductState state = before->state();
  const auto map = [&] {
    return Som(std::make_shared<const ProductWeights>(before->known(), state, before->threads()));
  };
  LengthChecks checks(som.parameters());
  auto trained = train_epochs(
      som, 0, 1, options, checks,
      [&](std::uint64_t epoch, const Stop&) -> Result<void> {
        if (epoch >= som.parameters().epochs) checks.add(state.mean_distance());
        state.learn_all(som.parameters().radius().at(epoch));
        return {};
      },
      map);
  if (trained) som = map();
  return trained;
}

Result<void> train(SomStart& start, const TrainingOptions& options) {
  if (start.som.parameters().training == Training::kOnline) return train_online(start, options);
  if (start.som.products()) return train_batch_by_products(start.som, options);
  SamplesInMemory source(start.samples);
  SOMATO_TRY(const auto survey, survey_samples(source, nullptr));
  if (!options.incomplete) return train_batch(start, source, survey, options);
  SamplesInMemory incomplete(*options.incomplete);
  return train_batch(start, incomplete, survey, options);
}

Result<SomParameters> resolve_for(const SomParameters& parameters, const SampleSurvey& survey) {
  SOMATO_TRY_VOID(check_samples(survey.count, survey.low.size()));
  SOMATO_TRY_VOID(check_longest(survey.longest));
  SOMATO_TRY_VOID(check_layers(parameters, survey.low.size()));
  SOMATO_TRY_VOID(check_scales(parameters));
  return resolve(parameters, survey.count, survey.low.size());
}

// The samples as the map sees them.
Result<Som> train_on_prepared(const SomParameters& parameters, SampleSource& prepared,
                              const TrainingOptions& options) {
  SOMATO_TRY(const SampleSurvey survey, survey_samples(prepared, options.processes));
  SOMATO_TRY(const auto resolved, agreed(resolve_for(parameters, survey), options.processes));
  auto som = initial_som(resolved, prepared, survey, options.processes, options.threads);
  if (!som) return som;
  SomStart start{std::move(*som), {}, {}, StoredElements(prepared.size())};
  SOMATO_TRY_VOID(train_batch(start, prepared, survey, options));
  return std::move(start.som);
}

Result<void> check_plain(const SomParameters& parameters) {
  if (parameters.arithmetic != Arithmetic::kInnerProducts) return {};
  return fail(ErrorKind::kUsage, "inner products are not known of samples with missing elements",
              "arithmetic", "set 'arithmetic' to plain or leave it out");
}

Result<Som> train_on_incomplete(SomParameters parameters, const Samples& samples,
                                const TrainingOptions& options) {
  require(options.incomplete->count() == samples.count() &&
              options.incomplete->size() == samples.size() && !samples.is_sparse() &&
              !options.incomplete->is_sparse() && !options.training,
          "incomplete samples are dense and as many as the complete ones");
  SOMATO_TRY_VOID(check_plain(parameters));
  parameters.arithmetic = Arithmetic::kPlain;
  SOMATO_TRY(auto start, start_som(parameters, samples, options));
  SOMATO_TRY_VOID(check_takes_incomplete(start.som));
  SOMATO_TRY_VOID(train(start, options));
  return start.whole(std::move(start.som));
}

}  // namespace

Result<Som> train_som(const SomParameters& parameters, const Samples& samples,
                      const TrainingOptions& options) {
  if (options.incomplete) return train_on_incomplete(parameters, samples, options);
  SOMATO_TRY(auto start, start_som(parameters, samples, options));
  SOMATO_TRY_VOID(train(start, options));
  return start.whole(std::move(start.som));
}

Result<Som> train_som(const SomParameters& parameters, const Matrix<float>& samples,
                      const TrainingOptions& options) {
  return train_som(parameters, Samples(samples), options);
}

Result<Som> train_som(const SomParameters& parameters, SampleSource& samples,
                      const TrainingOptions& options) {
  SOMATO_TRY(const auto resolved, resolve(parameters, 1, samples.size()));
  if (resolved.training != Training::kBatch) {
    return fail(ErrorKind::kUsage, "online training needs all samples in memory", {},
                "set 'training' to batch");
  }
  SOMATO_TRY_VOID(check_memory(resolved, samples.size()));
  if (!*resolved.normalize_input) return train_on_prepared(parameters, samples, options);
  ChangedSamples normalized(samples, [&](const Samples& part) {
    Samples storage;
    prepared_samples(resolved, part, storage);
    return storage;
  });
  return train_on_prepared(parameters, normalized, options);
}

DrawSequence::DrawSequence(Draws draws, std::size_t samples, std::uint64_t seed)
    : draws_(draws), samples_(samples), random_(seed, Stream::kDraws) {}

std::size_t DrawSequence::next() {
  if (draws_ == Draws::kWithReplacement) return random_.below(samples_);
  if (left_.empty()) {
    left_.resize(samples_);
    std::iota(left_.begin(), left_.end(), std::size_t{0});
  }
  std::swap(left_[random_.below(left_.size())], left_.back());
  const std::size_t drawn = left_.back();
  left_.pop_back();
  return drawn;
}

}  // namespace somato
