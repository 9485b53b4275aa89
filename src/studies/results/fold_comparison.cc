#include "studies/results/fold_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "somato/core/check.h"

namespace somato {
namespace {

const std::string& blocks() {
  static const std::string name = choice_name(FoldChoice::kBlocks);
  return name;
}

}  // namespace

FoldChoice other_choice(FoldChoice choice) {
  return choice == FoldChoice::kBlocks ? FoldChoice::kInterleaved : FoldChoice::kBlocks;
}

void count_right(const std::vector<std::string>& labels, const std::vector<std::string>& named,
                 const std::vector<std::string>& other_named, FoldComparison& comparison) {
  require(labels.size() == named.size() && labels.size() == other_named.size(),
          "the fold choices are compared by the same samples");
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const bool right = named[i] == labels[i];
    const bool other_right = other_named[i] == labels[i];
    ++comparison.samples;
    comparison.right += right ? 1 : 0;
    comparison.other_right += other_right ? 1 : 0;
    comparison.only_right += right && !other_right ? 1 : 0;
    comparison.only_other_right += other_right && !right ? 1 : 0;
  }
}

void add(const FoldComparison& found, FoldComparison& all) {
  all.largest_block = std::max(all.largest_block, found.largest_block);
  all.samples += found.samples;
  all.right += found.right;
  all.other_right += found.other_right;
  all.only_right += found.only_right;
  all.only_other_right += found.only_other_right;
}

std::optional<double> accuracy_by(const std::string& choice, const FoldComparison& comparison) {
  if (comparison.samples == 0) return {};
  const std::size_t right = choice == comparison.choice ? comparison.right : comparison.other_right;
  return static_cast<double>(right) / static_cast<double>(comparison.samples);
}

bool neighbours_leak(const FoldComparison& comparison) {
  const auto own = static_cast<double>(comparison.only_right);
  const auto other = static_cast<double>(comparison.only_other_right);
  const double falls = comparison.choice == blocks() ? other - own : own - other;
  return falls > 2.0 * std::sqrt(own + other);
}

std::string sentence_of(const FoldComparison& comparison) {
  if (comparison.samples == 0) {
    return "Whether neighbouring explorations are alike was not measured, because no class has two "
           "explorations in the same fold.";
  }
  const double together = *accuracy_by(blocks(), comparison);
  const double apart = *accuracy_by(choice_name(FoldChoice::kInterleaved), comparison);
  if (neighbours_leak(comparison)) {
    return fmt::format(
        "The accuracy falls from {:.3f} to {:.3f} when neighbouring explorations are kept together "
        "(interleaved folds and blocks, first seed).",
        apart, together);
  }
  return fmt::format(
      "Neighbouring explorations make no clear difference: the accuracy is {:.3f} when they are "
      "kept together and {:.3f} in interleaved folds (first seed).",
      together, apart);
}

}  // namespace somato
