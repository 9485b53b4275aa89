#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/bodies/scene.h"
#include "views/exports/bag_export.h"
#include "views/exports/foxglove_layout.h"

namespace somato {

/// The topics of scenes in a bag.
struct SceneTopics {
  std::size_t scene = 0;
  std::size_t transforms = 0;
  std::size_t taxels = 0;
  std::size_t points = 0;
};

/// A bag as BagExport writes it, with the scene of explorations whose body is known, and
/// `foxglove_layout.json`, which shows both. The topics of the scene:
///
/// - `/scene` (SceneUpdate): the shapes of body and object at the start of the exploration;
/// - `/tf`: the poses of the bodies with the frames of the channel that has most of them, at most
///   100 in a second;
/// - `/taxels` (SceneUpdate): the taxels with each frame of the channel `touch`, coloured by the
///   share of the largest force in the exploration;
/// - `/taxel_points` (PointCloud2): their positions and forces, for programs without SceneUpdate.
///
/// The poses of a body need complete explorations: memory is bounded by one exploration.
class FoxgloveExport final : public WholeExport {
 public:
  static Result<std::unique_ptr<RecordingExport>> begin(const std::string& path,
                                                        SceneFinder scenes);

  FoxgloveExport(std::unique_ptr<BagWriter> writer, SceneFinder scenes)
      : bag_(std::move(writer)), scenes_(std::move(scenes)) {}

  Result<void> finish() override;

 private:
  class ScenedFrames;

  Result<void> add(const Exploration& exploration) override;
  void plot(const Exploration& exploration);
  Result<void> open_scene_topics(const Scene& scene);

  BagExport bag_;
  SceneFinder scenes_;
  std::vector<PlottedTopic> plots_;
  std::string label_topic_;  // The topic of the first label, or empty.
  std::optional<SceneTopics> topics_;
  std::optional<ShownScene> shown_;
};

}  // namespace somato
