#include "views/session/viewed_system.h"

#include <utility>

#include "systems/graph/layout_fit.h"

namespace somato::live {
namespace {

SystemPicture picture_of_trained(const SystemModel& model,
                                 const std::optional<RecordingLayout>& layout) {
  SystemPicture picture;
  picture.graph = graph_json(model.system, model.answer ? model.answer->map : "");
  picture.maps = maps_json(model.system, model.answer);
  if (model.answer) picture.label = model.answer->label;
  const auto fits = layout ? check_layout(model.system, *layout) : Result<void>();
  if (!fits) picture.problem = "The channels do not fit the system: " + sentence_of(fits.error());
  return picture;
}

}  // namespace

Result<std::string> answering_map(const System& system, const std::string& named) {
  if (!named.empty()) return system.find(named).map([&](std::size_t) { return named; });
  std::string last;
  for (std::size_t i = 0; i < system.modules().size(); ++i) {
    if (som_of(system, i) != nullptr) last = system.modules()[i].name;
  }
  if (!last.empty()) return last;
  return fail(ErrorKind::kUsage, "the system has no map");
}

SystemPicture picture_of(const ViewSystem& system, const std::optional<RecordingLayout>& layout) {
  if (system.trained) return picture_of_trained(*system.trained, layout);
  SystemPicture picture;
  picture.label = system.label;
  const auto built = System::build(system.description, layout.value_or(RecordingLayout{}));
  const auto map = built ? answering_map(*built, system.map) : fail(built.error());
  if (!map) {
    picture.problem = sentence_of(map.error());
    return picture;
  }
  picture.graph = graph_json(*built, *map);
  picture.maps = maps_json(*built, {});
  picture.problem = "This system is not trained yet.";
  return picture;
}

std::string sentence_of(const Error& error) {
  std::string text = to_string(error);
  if (!text.empty() && text.back() != '.') text.push_back('.');
  return text;
}

}  // namespace somato::live
