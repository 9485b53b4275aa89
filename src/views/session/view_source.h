#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recordings/file/growing_recording.h"
#include "somato/bodies/explorer.h"
#include "somato/bodies/exploring.h"
#include "somato/bodies/scene.h"
#include "somato/graph/system_description.h"
#include "somato/graph/system_model.h"
#include "somato/recording/layout.h"
#include "somato/recording/recording.h"
#include "views/session/reading_sink.h"
#include "views/skins/channel_places.h"

namespace somato {

/// A system that may be chosen: trained already, or to be trained on what is viewed.
struct ViewSystem {
  std::string name;
  std::string text;                    ///< One line.
  SystemDescription description = {};  ///< The description of one that is still to be trained.
  std::string label = {};              ///< The label to be predicted, such as "object".
  std::string map = {};                ///< The module that answers; empty: its last map.
  std::shared_ptr<const SystemModel> trained;  ///< Or nullptr.
};

/// An exploration of a body that follows without a further command.
struct PlannedExploration {
  std::size_t thing = 0;
  std::size_t trial = 0;
};

/// Explorations of a simulated body before those of the view, for a system that is trained on them
/// when the view starts.
struct PriorExplorations {
  std::size_t rounds = 0;  ///< Each explores every thing once; the system is trained after each.
  std::shared_ptr<const SimulatedExplorer> explorer = {};
  std::vector<std::size_t> things = {};  ///< By number.
};

/// The source of the view: a recording, or a body that explores, simulated or real.
struct ViewSource {
  std::string name;          ///< The file's name, or the body's.
  Recording recording = {};  ///< Valid; of a body what was explored before, if any.
  /// The index of the first of these explorations: earlier ones of the body are no longer kept.
  std::size_t first = 0;
  /// The name of the recording of each of these explorations, if there are several.
  std::vector<std::string> origins = {};
  std::optional<RecordingLayout> layout = {};  ///< That of a recording which is read for a system.
  std::unique_ptr<Explorer> explorer = {};     ///< With the body; or nullptr.
  std::size_t thing = 0;                       ///< That the body explores first.
  /// The explorations of the body, one after the other, each object placed at random; it then
  /// explores nothing else. Empty: one thing, and what commands say.
  std::vector<PlannedExploration> plan = {};
  /// Whether the plan is a demonstration: after its last exploration all are played again, in a
  /// loop, until a viewer explores or selects an object.
  bool demonstrates = false;
  /// The selected system is trained on these; may have no rounds.
  PriorExplorations prior_explorations = {};
  bool teaches = true;  ///< Whether the selected system learns the names that are given.
  /// The names that are planned, for the keys of the page, and the explorations of each; 0: any.
  std::vector<std::string> names = {};
  std::size_t each = 0;
  std::uint64_t seed = 1;  ///< The seed of training.
  /// The file in which the explorations of the body are saved, or nullptr; must outlive the
  /// session.
  GrowingRecording* file = nullptr;
  SceneFinder scenes = {};                 ///< For recordings; may be empty.
  std::vector<ChannelPlaces> places = {};  ///< Places of elements, from a layout file.
  /// Takes what the first of the systems says, which is then the only one; may be empty.
  live::ReadingSink readings = {};
  std::vector<ViewSystem> systems = {};
  std::optional<std::size_t> system = {};  ///< That is chosen first.
};

/// Without waiting for the next moment.
inline constexpr double kFastest = 1e9;

/// The memory of what a view keeps by default, in bytes: hours of a hand's explorations.
inline constexpr std::size_t kPageMemory = std::size_t{256} << 20;

/// The settings of a view.
struct ViewSettings {
  bool wait_for_viewer = true;  ///< Begins to play with the first viewer; else at once.
  double speed = 1.0;           ///< 0.05 to 100, or kFastest; 1: as fast as it was.
  /// Seconds between two of the hundred snapshots of a map in training: at full speed they could
  /// not be followed.
  double training_pause = 0.06;
  double result_pause = 1.5;  ///< Seconds for which a demonstration shows each result.
  /// Whether a page may show earlier moments. Without, only what systems need is kept.
  bool has_page = true;
  /// The most memory of the explorations that a body made and that are kept, in bytes.
  std::size_t memory = kPageMemory;
  /// Called once in each thread that reads the body or computes what is read, before it begins,
  /// such as to give it a priority; may be empty.
  std::function<void()> on_thread = {};
};

}  // namespace somato
