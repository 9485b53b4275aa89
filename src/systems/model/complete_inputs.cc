#include "systems/model/complete_inputs.h"

#include "maps/som/fill_from_winner.h"

namespace somato {

Result<void> check_fills(const SomModel& model, MissingFill missing) {
  if (missing == MissingFill::kNearest) return check_takes_incomplete(model.som);
  if (missing == MissingFill::kRefuse || !model.fill_values().empty()) return {};
  return fail(ErrorKind::kUsage, "the map does not contain the means of its training data", {},
              "train a map with the means of the columns, or take missing values from the winner");
}

Samples complete_inputs(const SomModel& model, MissingFill missing, const Samples& samples) {
  switch (missing) {
    case MissingFill::kMean:
      return model.prepare(filled_with(model.fill_values(), samples));
    case MissingFill::kNearest:
      return filled_from_winners(model.som, model.prepare(samples));
    case MissingFill::kRefuse:
      break;
  }
  return model.prepare(samples);
}

}  // namespace somato
