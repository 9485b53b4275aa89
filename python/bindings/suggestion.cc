#include "studies/suggestion/suggestion.h"

#include <string>
#include <utility>

#include "base/files/toml_file.h"
#include "bindings.h"
#include "errors.h"
#include "interrupts.h"
#include "nanobind/stl/string.h"
#include "parameters.h"
#include "somato/studies/study.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

// The study, its TOML file with the reasons as comments, and all scores as JSON.
nb::tuple suggestion_for(const Recording& recording, const nb::dict& settings, std::size_t threads,
                         nb::object progress) {
  const auto parameters = parameters_of<SuggestionParameters>(settings, "suggest");
  Result<Suggestion> found;
  unlocked(
      [&](Interrupts& interrupts) {
        found = suggest(recording, parameters, {threads, interrupts.progress()});
      },
      std::move(progress));
  const Suggestion suggestion = value_or_throw(std::move(found));
  const std::string toml = to_toml(suggestion);
  StudyDescription study = value_or_throw(parse_toml(toml, "suggest").and_then(read_study));
  return nb::make_tuple(std::move(study), toml, to_json(suggestion));
}

}  // namespace

void bind_suggestion(nb::module_& module) {
  module.def("suggest", &suggestion_for, nb::arg("recording"), nb::arg("settings"),
             nb::arg("threads"), nb::arg("progress").none());
}

}  // namespace somato::python
