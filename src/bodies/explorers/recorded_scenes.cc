#include "bodies/explorers/recorded_scenes.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "bodies/hands/hand_poses.h"
#include "bodies/objects/built_in_things.h"
#include "bodies/objects/exploration_source.h"
#include "bodies/probes/probe_poses.h"

namespace somato {
namespace {

// Objects of others may have the same name. The trial is not a property of an object.
bool is_contradicted(const Object& object, const Exploration& exploration) {
  const std::vector<Label> known = labels_of(object, 0);
  return std::any_of(known.begin(), known.end(), [&](const Label& label) {
    const auto said = find_label(exploration, label.name);
    return label.name != "trial" && said && *said != label.value;
  });
}

// A substitute for an unknown object; it is not shown.
Object nothing() {
  Object object;
  object.name = "nothing";
  object.size = {20.0, 20.0, 20.0};
  object.material = declared_materials().front();
  return object;
}

class RecordedScenes {
 public:
  explicit RecordedScenes(std::vector<Object> own) : own_(std::move(own)), nothing_(nothing()) {}

  std::unique_ptr<ScenePlayer> find(const Exploration& exploration) {
    if (!is_of_body(exploration.source)) return nullptr;
    for (const Hand hand : {Hand::kLucs2, Hand::kLucs3}) {
      if (is_of_hand(exploration, hand)) return find(exploration, hand);
    }
    return play_probes(exploration);
  }

 private:
  struct Built {
    Hand hand;
    bool taxels;
    const Object* object;
    HandScene scene;
  };

  std::unique_ptr<ScenePlayer> find(const Exploration& exploration, Hand hand) {
    const bool taxels = static_cast<bool>(find_channel(exploration, "touch"));
    const HandScene* shown = with_object(own_, exploration, hand, taxels);
    if (shown == nullptr && is_of_built_in_things(exploration.source)) {
      shown = with_object(built_in_objects(), exploration, hand, taxels);
    }
    if (shown != nullptr) return play_hand(*shown);
    const HandScene* empty = built(hand, taxels, nothing_);
    return empty != nullptr ? play_hand(*empty, false) : nullptr;
  }

  // The hand with the explored object, if it is one of `objects`, or nullptr.
  const HandScene* with_object(const std::vector<Object>& objects, const Exploration& exploration,
                               Hand hand, bool taxels) {
    const auto name = find_label(exploration, "object");
    for (const Object& object : objects) {
      if (!name || object.name != *name) continue;
      const HandScene* scene = built(hand, taxels, object);
      if (scene != nullptr && !is_contradicted(scene->object(), exploration)) return scene;
    }
    return nullptr;
  }

  // Explorations of one thing follow each other, and people go back: to build a hand takes some
  // milliseconds, in which nothing plays. nullptr for an object that does not fit it.
  const HandScene* built(Hand hand, bool taxels, const Object& object) {
    constexpr std::size_t kMost = 8;
    for (const Built& one : built_) {
      if (one.hand == hand && one.taxels == taxels && one.object == &object) return &one.scene;
    }
    SimulationParameters parameters;
    parameters.taxels = taxels;
    auto scene = HandScene::build(hand, object, parameters);
    if (!scene) return nullptr;
    if (built_.size() == kMost) built_.pop_front();
    built_.push_back({hand, taxels, &object, std::move(*scene)});
    return &built_.back().scene;
  }

  std::vector<Object> own_;
  Object nothing_;
  std::deque<Built> built_;  // the latest last
};

}  // namespace

SceneFinder recorded_scenes(std::vector<Object> own) {
  auto scenes = std::make_shared<RecordedScenes>(std::move(own));
  return [scenes](const Exploration& exploration) { return scenes->find(exploration); };
}

}  // namespace somato
