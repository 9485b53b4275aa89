#include "bodies/objects/selected_things.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "somato/core/parameter.h"

namespace somato {
namespace {

Result<std::string> label_of_things(const Recording& recording) {
  for (const char* name : {"object", "material"}) {
    if (!recording.explorations.empty() && find_label(recording.explorations.front(), name)) {
      return std::string(name);
    }
  }
  return fail(ErrorKind::kData, "the explorations have neither a label 'object' nor 'material'", {},
              "use a recording whose explorations name what was explored");
}

Result<void> check_names(const std::vector<std::string>& things,
                         const std::vector<std::string>& known) {
  std::set<std::string> seen;
  for (const std::string& thing : things) {
    if (std::find(known.begin(), known.end(), thing) == known.end()) {
      return fail(unknown_name("object or material", thing, {}, known));
    }
    if (!seen.insert(thing).second) {
      return fail(ErrorKind::kUsage, fmt::format("'{}' is selected twice", thing), thing,
                  "name each object or material once");
    }
  }
  return {};
}

}  // namespace

Result<Recording> select_things(Recording recording, const ThingSelection& selection) {
  if (selection.things.empty() && !selection.each) return recording;
  SOMATO_TRY(const auto label, label_of_things(recording));
  SOMATO_TRY(const auto known, label_values(recording, label));
  SOMATO_TRY_VOID(check_names(selection.things, known));
  Recording selected;
  for (const std::string& thing : selection.things.empty() ? known : selection.things) {
    std::size_t count = 0;
    for (Exploration& exploration : recording.explorations) {
      if (count == selection.each || find_label(exploration, label) != thing) continue;
      selected.explorations.push_back(std::move(exploration));
      ++count;
    }
    if (count < selection.each.value_or(0)) {
      return fail(ErrorKind::kUsage,
                  fmt::format("'{}' has {} explorations, not {}", thing, count, *selection.each),
                  thing, "select fewer of each, or explore more");
    }
  }
  return selected;
}

}  // namespace somato
