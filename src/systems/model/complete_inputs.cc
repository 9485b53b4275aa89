#include "systems/model/complete_inputs.h"

#include <cmath>

#include "maps/som/fill_from_winner.h"

namespace somato {

Result<void> check_fills(const SomModel& model, MissingFill missing) {
  if (missing == MissingFill::kNearest || missing == MissingFill::kLeaveOut)
    return check_takes_incomplete(model.som);
  if (missing == MissingFill::kRefuse || !model.fill_values().empty()) return {};
  return fail(ErrorKind::kUsage, "the map does not contain the means of its training data", {},
              "train a map with the means of the columns, or take missing values from the winner");
}

Samples complete_inputs(const SomModel& model, MissingFill missing, const Samples& samples) {
  switch (missing) {
    case MissingFill::kMean:
      return model.prepare(filled_with(model.fill_values(), samples));
    case MissingFill::kNearest:
    case MissingFill::kLeaveOut:
      return filled_from_winners(model.som, model.prepare(samples));
    case MissingFill::kRefuse:
      break;
  }
  return model.prepare(samples);
}

double in_units(const std::optional<Standardization>& standardization, std::size_t element,
                float weight) {
  if (!standardization) return double{weight};
  const auto& [means, deviations] = *standardization;
  return std::fma(deviations[element], double{weight}, means[element]);
}

Result<Som> train_leaving_out(const SomParameters& parameters, const Samples& samples,
                              TrainingOptions options) {
  KnownValues known;
  SOMATO_TRY_VOID(known.take(samples));
  SOMATO_TRY(const auto means, known.means({}));
  options.incomplete = &samples;
  return train_som(parameters, filled_with(means, samples), options);
}

}  // namespace somato
