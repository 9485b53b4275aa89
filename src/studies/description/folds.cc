#include "studies/description/folds.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "base/core/values_at.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

std::vector<std::size_t> range(std::size_t begin, std::size_t end) {
  std::vector<std::size_t> numbers(end - begin);
  std::iota(numbers.begin(), numbers.end(), begin);
  return numbers;
}

// A fold for each part: `parts[i]` is the part in which sample i is tested.
std::vector<Fold> folds_of_parts(const std::vector<std::size_t>& parts) {
  const std::set<std::size_t> distinct(parts.begin(), parts.end());
  std::vector<Fold> folds;
  folds.reserve(distinct.size());
  for (const std::size_t part : distinct) {
    Fold fold;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      (parts[i] == part ? fold.test : fold.training).push_back(i);
    }
    folds.push_back(std::move(fold));
  }
  return folds;
}

// Class by class, each in random order, the samples are dealt to the parts in turn.
std::vector<std::size_t> deal(const FoldSamples& samples) {
  Random random(samples.seed, Stream::kGroupings);
  const std::vector<std::size_t> shuffled = random_order(samples.samples, random);
  std::vector<std::pair<std::size_t, std::size_t>> order;  // class, place among the shuffled
  order.reserve(shuffled.size());
  for (std::size_t i = 0; i < shuffled.size(); ++i) {
    order.emplace_back(samples.classes[shuffled[i]], i);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> parts(samples.samples);
  for (std::size_t i = 0; i < order.size(); ++i)
    parts[shuffled[order[i].second]] = i % samples.folds;
  return parts;
}

// The same parts in ascending order for the samples of each class, so that those of a part follow
// each other in the recording.
void keep_together(const FoldSamples& samples, std::vector<std::size_t>& parts) {
  std::map<std::size_t, std::vector<std::size_t>> classes;
  for (std::size_t i = 0; i < samples.samples; ++i) classes[samples.classes[i]].push_back(i);
  for (const auto& [number, members] : classes) {
    std::vector<std::size_t> ascending = values_at(parts, members);
    std::sort(ascending.begin(), ascending.end());
    for (std::size_t i = 0; i < members.size(); ++i) parts[members[i]] = ascending[i];
  }
}

// 1 for the last samples of each class, 0 for the earlier ones.
std::vector<std::size_t> last_of_classes(const FoldSamples& samples) {
  std::map<std::size_t, std::size_t> later;  // samples by class
  std::vector<std::size_t> parts(samples.samples);
  for (std::size_t i = samples.samples; i-- > 0;) {
    parts[i] = later[samples.classes[i]]++ < samples.test_last ? 1 : 0;
  }
  require(std::find(parts.begin(), parts.end(), 0) != parts.end(),
          "test_last needs earlier samples");
  return parts;
}

std::vector<std::size_t> parts_of(const FoldSamples& samples) {
  if (samples.test_last > 0) return last_of_classes(samples);
  std::vector<std::size_t> parts = deal(samples);
  if (samples.choice == FoldChoice::kBlocks) keep_together(samples, parts);
  return parts;
}

// The number of the class in order, modulo the number of parts, is the part that is held out of the
// other classes; with test_last it is always the last samples.
std::vector<Fold> class_folds(const FoldSamples& samples) {
  const std::vector<std::size_t> parts = parts_of(samples);
  std::vector<Fold> classes = folds_of_parts(samples.classes);
  require(classes.size() >= 2, "leave_class_out needs at least two classes");
  for (std::size_t number = 0; number < classes.size(); ++number) {
    Fold& fold = classes[number];
    const std::size_t part = samples.test_last > 0 ? 1 : number % samples.folds;
    const auto is_held_out = [&](std::size_t sample) { return parts[sample] == part; };
    std::copy_if(fold.training.begin(), fold.training.end(), std::back_inserter(fold.known),
                 is_held_out);
    std::erase_if(fold.training, is_held_out);
  }
  return classes;
}

}  // namespace

std::vector<Fold> folds(Protocol protocol, const FoldSamples& samples) {
  const bool divides = protocol != Protocol::kTrainIsTest && protocol != Protocol::kTestData;
  require(samples.samples >= (divides ? 2U : 1U), "a protocol needs training samples");
  const std::vector<std::size_t> all = range(0, samples.samples);
  switch (protocol) {
    case Protocol::kTrainIsTest:
      return {{all, all}};
    case Protocol::kTestData:
      require(samples.test_samples > 0, "test_data needs test samples");
      return {{all, range(samples.samples, samples.samples + samples.test_samples)}};
    case Protocol::kLeaveOneOut:
      return folds_of_parts(all);
    case Protocol::kLeaveGroupOut: {
      require(samples.groups.size() == samples.samples,
              "leave_group_out needs a group for each sample");
      std::vector<Fold> groups = folds_of_parts(samples.groups);
      require(groups.size() >= 2, "leave_group_out needs at least two groups");
      return groups;
    }
    case Protocol::kLeaveClassOut:
    case Protocol::kFolds:
    case Protocol::kObjectAfterObject:
      break;
  }
  require(samples.classes.size() == samples.samples, "k_folds needs a class for each sample");
  require(samples.test_last > 0 || (samples.folds >= 2 && samples.folds <= samples.samples),
          "k_folds needs at least one sample per fold");
  if (protocol == Protocol::kLeaveClassOut) return class_folds(samples);
  std::vector<Fold> parts = folds_of_parts(parts_of(samples));
  if (samples.test_last > 0) return {std::move(parts.back())};
  return parts;
}

std::size_t largest_block(const FoldSamples& samples) {
  const std::vector<std::size_t> parts = parts_of(samples);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> blocks;
  std::size_t largest = 0;
  for (std::size_t i = 0; i < samples.samples; ++i) {
    largest = std::max(largest, ++blocks[{samples.classes[i], parts[i]}]);
  }
  return largest;
}

std::vector<Fold> folds_among(const std::vector<std::size_t>& chosen,
                              const std::vector<std::size_t>& classes, std::size_t parts,
                              std::uint64_t seed, FoldChoice choice) {
  FoldSamples samples{chosen.size()};
  samples.classes = values_at(classes, chosen);
  samples.folds = std::min(parts, chosen.size());
  samples.seed = seed;
  samples.choice = choice;
  std::vector<Fold> divided = folds(Protocol::kFolds, samples);
  for (Fold& fold : divided)
    fold = {values_at(chosen, fold.training), values_at(chosen, fold.test)};
  return divided;
}

}  // namespace somato
