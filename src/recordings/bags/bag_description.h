#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/recording/csv_import.h"

namespace somato {

/// The clock of the frames.
enum class BagClock {
  kReceiver,  ///< The time at which the message was recorded.
  kHeader,    ///< The stamp in the header of the message.
};

/// Treatment of a clock of a topic that is set back.
enum class ClockJumps {
  kRefuse,  ///< It is an error.
  kCut,     ///< The exploration ends, and another one begins.
};

template <>
struct Choices<BagClock> {
  static const std::vector<std::pair<BagClock, std::string>>& all();
};
template <>
struct Choices<ClockJumps> {
  static const std::vector<std::pair<ClockJumps, std::string>>& all();
};

/// The division of bags into explorations: the table [import].
struct BagTrials {
  std::string files;  ///< Such as "{object}_{trial:number}"; empty: no labels from names.
  Unmentioned other_files = Unmentioned::kRefuse;
  std::string events;  ///< A topic, or topic:field.
  std::string spans;   ///< A CSV file.
  double gap = 0.0;    ///< Seconds; 0: gaps do not matter.
  BagClock clock = BagClock::kReceiver;
  ClockJumps jumps = ClockJumps::kRefuse;
  std::string definitions;

  static const Declarations<BagTrials>& declarations();
};

/// A channel from the messages of a topic: a table [[channel]].
struct BagChannel {
  std::string name;
  std::string unit;
  std::string topic;
  std::vector<std::string> fields;  ///< Paths; see FieldReader.
  std::string names;                ///< The path of texts with the names of its elements.
  std::vector<std::size_t> shape;
  double factor = 1.0;

  static const Declarations<BagChannel>& declarations();
};

/// A label of the explorations: a table [[label]].
struct BagLabel {
  std::string name;
  std::string value;
  std::string topic;
  std::string field;

  static const Declarations<BagLabel>& declarations();
};

/// Description of the import of bags as a recording.
struct BagImport {
  BagTrials trials;
  std::vector<BagChannel> channels;  ///< None: those of all known types.
  std::vector<BagLabel> labels;
};

/// Checks the consistency of the description. Errors (kUsage): a channel without name, topic or
/// fields, two channels or labels of the same name, a label with both or neither of value and
/// topic, two ways to cut.
Result<void> check_bag_import(const BagImport& description);

/// Reads a description from its tables [import], [[channel]] and [[label]] and checks it. Errors
/// (kUsage) with their location: also unknown keys and values out of range.
Result<BagImport> read_bag_import(const Table& file);

/// Channels with commas between, such as
/// "touch:counts=/topic:sensors[*].taxels[*].z+sensors[*].taxels[*].x", where the unit and what
/// follows the first field are optional. Errors (kUsage).
Result<std::vector<BagChannel>> parse_bag_channels(const std::string& text);

/// "object=cup" or "object=/topic:field". Errors (kUsage).
Result<BagLabel> parse_bag_label(const std::string& text);

}  // namespace somato
