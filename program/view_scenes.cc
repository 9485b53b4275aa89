#include "view_scenes.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "somato/bodies/object_table.h"
#include "somato/simulation/hand_poses.h"

namespace somato::program {
namespace {

std::vector<Object> known_objects() {
  std::vector<Object> all;
  for (const auto& table :
       {lucs2_objects(declared_materials()), lucs3_objects(declared_materials()),
        lucs3_new_objects(declared_materials())}) {
    if (table) all.insert(all.end(), table->begin(), table->end());
  }
  return all;
}

std::optional<Object> object_of(const Exploration& exploration) {
  static const std::vector<Object> known = known_objects();
  const auto name = find_label(exploration, "object");
  if (!name) return {};
  const auto found = std::find_if(known.begin(), known.end(),
                                  [&](const Object& object) { return object.name == *name; });
  if (found == known.end()) return {};
  return *found;
}

// What stands in for an object that is not known; it is not shown.
Object nothing() {
  Object object;
  object.name = "nothing";
  object.size = {20.0, 20.0, 20.0};
  object.material = declared_materials().front();
  return object;
}

std::unique_ptr<ScenePlayer> find_scene(const Exploration& exploration) {
  for (const Hand hand : {Hand::kLucs2, Hand::kLucs3}) {
    if (!is_of_hand(exploration, hand)) continue;
    const std::optional<Object> object = object_of(exploration);
    SimulationParameters parameters;
    parameters.taxels = static_cast<bool>(find_channel(exploration, "touch"));
    const auto scene = HandScene::build(hand, object.value_or(nothing()), parameters);
    return scene ? play_hand(*scene, object.has_value()) : nullptr;
  }
  return nullptr;
}

}  // namespace

SceneFinder hand_scenes() {
  return find_scene;
}

}  // namespace somato::program
