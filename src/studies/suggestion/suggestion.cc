#include "studies/suggestion/suggestion.h"

#include <string>
#include <utility>
#include <vector>

#include "recordings/explorations/true_values.h"
#include "studies/suggestion/code_search.h"
#include "studies/suggestion/suggested_system.h"
#include "studies/suggestion/suggestion_state.h"
#include "studies/suggestion/vector_choice.h"

namespace somato {
namespace {

Result<void> check_usable(const Recording& recording) {
  SOMATO_TRY_VOID(validate(recording));
  if (has_true_values(recording)) {
    return fail(ErrorKind::kData,
                "the recording contains true values of a simulation, which no robot has", {},
                "make a recording without them: sense() and 'somato sense' leave them out");
  }
  if (recording.explorations.size() > 1) return {};
  return fail(ErrorKind::kData, "the recording has only one exploration", {},
              "a comparison requires at least two; explore more, or cut a long recording into "
              "windows when it is imported ('window')");
}

}  // namespace

const std::vector<std::pair<ChannelRole, std::string>>& Choices<ChannelRole>::all() {
  static const std::vector<std::pair<ChannelRole, std::string>> choices{
      {ChannelRole::kSense, "sense"},
      {ChannelRole::kConstant, "constant"},
      {ChannelRole::kSetting, "setting"},
      {ChannelRole::kUnrelated, "unrelated"}};
  return choices;
}

const Declarations<SuggestionParameters>& SuggestionParameters::declarations() {
  using P = SuggestionParameters;
  static const auto declared =
      Declarations<P>()
          .add("name", &P::name, "", Range::any(), "Name of the study in the file.")
          .add("label", &P::label, "", Range::any(),
               "Label by which the study in the file measures accuracy; it does not affect the "
               "search.")
          .add("budget", &P::budget, "combinations", Range::between(1, 1e9),
               "Maximum number of combinations that are compared; not in the papers.")
          .add("explorations", &P::explorations, "", Range::between(2, 4096),
               "Maximum number of explorations that are compared; of more, that many are drawn at "
               "random. Automatic: 200, or 500 if explorations have one frame, as the rows of a "
               "table.")
          .add("candidates", &P::candidates, "", Range::between(1, 1000),
               "Number of the best codes of each sense that are combined with other senses.")
          .add("products", &P::products, "", Range::between(0, 1000),
               "Maximum number of tensor products of two senses.")
          .add("elements", &P::elements, "", Range::between(1, 1e7),
               "Maximum number of elements of a vector; longer ones are not compared.")
          .add("weights", &P::weights, "", Range::between(1e-3, 1e3),
               "Weights with which a part is added, relative to parts of unit spread; the first of "
               "equally good ones is used.")
          .add("least_gain", &P::least_gain, "", Range::between(0, 1),
               "Least decrease of the score for which a further part is added.")
          .add(
              "least_side", &P::least_side, "neurons", Range::between(1, 40),
              "Least number of rows and of columns of the map, which otherwise has at most as many "
              "neurons as explorations; automatic: 15 as in the papers, or 1 if "
              "explorations have one frame, as the rows of a table.")
          .add("seed", &P::seed, "", Range::between(0, 1e15),
               "Seed of the draw of explorations, if there are more than are compared.");
  return declared;
}

Result<Suggestion> suggest(const Recording& recording, const SuggestionParameters& parameters,
                           const SuggestionOptions& options) {
  SOMATO_TRY_VOID(check_ranges(parameters));
  if (parameters.weights.empty()) {
    return fail(ErrorKind::kUsage, "'weights' is empty", "weights", "use a list such as 0.5,1,2");
  }
  SOMATO_TRY_VOID(check_usable(recording));
  SuggestionState state(recording, parameters, options);
  SOMATO_TRY_VOID(search_codes(state));
  SOMATO_TRY_VOID(choose_vector(state));
  state.suggestion.system = system_of(state.suggestion, state.groups);
  return std::move(state.suggestion);
}

}  // namespace somato
