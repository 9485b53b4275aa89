#include "views/live/stage.h"

#include <utility>

namespace somato::live {
namespace {

// A body continues without viewers, unless it is a demonstration; readings are not held up.
bool may_rest(const ViewSource& source, const ViewSettings& settings) {
  return settings.wait_for_viewer && !source.readings.on_moment &&
         (!source.explorer || source.demonstrates);
}

// A real body moves by a person's command only: that of the program without a view, or a viewer's.
Beginning beginning_of(const ViewSource& source, const ViewSettings& settings) {
  if (!settings.wait_for_viewer) return Beginning::kAtOnce;
  const bool is_real = source.explorer && source.explorer->moves_real_body();
  return is_real ? Beginning::kByCommand : Beginning::kWithFirstViewer;
}

}  // namespace

Stage::Stage(ViewSource viewed, const ViewSettings& settings, EventHub& hub)
    : source(std::move(viewed)),
      replay(hub, pace, source.readings),
      chosen(source, replay),
      kept(source),
      audience(beginning_of(source, settings), may_rest(source, settings)) {
  pace.speed = settings.speed;
  replay.limit_memory(settings.memory / 2);
}

void Stage::begin_exploration(std::size_t index) {
  begin_exploration(index, std::make_shared<Timeline>(kept[index]));
}

void Stage::begin_exploration(std::size_t index, std::shared_ptr<const Timeline> timeline) {
  const Exploration& begun = kept[index];
  std::shared_ptr<ScenePlayer> scene = kept.scene(index);
  if (!scene && source.scenes) scene = source.scenes(begun);
  replay.begin({index, &begun, std::move(timeline), std::move(scene)});
}

void Stage::rest() {
  pace.playing = false;
  moments_left = 0;
}

}  // namespace somato::live
