#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "somato/bodies/placement.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato::live {

/// A request of a page; see docs/formats/view.md.
struct PlayCommand {};
struct PauseCommand {};
struct StepCommand {
  std::int64_t frames = 1;
};
struct SeekCommand {
  std::size_t exploration = 0;
  std::size_t frame = 0;
};
struct SpeedCommand {
  double speed = 1.0;
};
struct ThingCommand {
  std::string name;
};
struct PlacementCommand {
  Placement placement;
};
struct ExploreCommand {};
struct NameCommand {
  Label label;                         ///< Such as {"object", "cup"}.
  std::optional<std::size_t> id = {};  ///< The exploration; empty: the current one.
};
struct UndoNameCommand {
  std::size_t id = 0;  ///< The exploration that was named last.
  Label label;         ///< The label that it was given last.
};
struct PlanCommand {
  std::size_t each = 0;  ///< Explorations of each name; 0 ends the plan.
};
struct SystemCommand {
  std::string name;
};
struct TrainCommand {};
struct StopTrainingCommand {};
struct DismissCommand {};

using ViewCommand =
    std::variant<PlayCommand, PauseCommand, StepCommand, SeekCommand, SpeedCommand, ThingCommand,
                 PlacementCommand, ExploreCommand, NameCommand, UndoNameCommand, PlanCommand,
                 SystemCommand, TrainCommand, StopTrainingCommand, DismissCommand>;

/// The most explorations of each name in a plan.
inline constexpr std::size_t kMostPlanned = 1000;

/// The command that a text in JSON holds. Errors (kUsage): no JSON, no known command, fields that
/// are missing, unknown, of another type or out of range.
Result<ViewCommand> parse_view_command(std::string_view text);

}  // namespace somato::live
