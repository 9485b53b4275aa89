#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "somato/recording/recording.h"
#include "studies/codes/frame_source.h"

namespace somato {

/// Properties of the frames of a source that determine its codes.
struct FrameFacts {
  std::size_t elements = 0;
  std::size_t most_frames = 0;    ///< The number of frames of the longest exploration.
  std::size_t shortest_half = 0;  ///< Frames of the shortest view of the shortest exploration.
  std::optional<double> rate;     ///< The lowest, in Hz; empty if it is unknown.
  std::optional<double> highest_speed;  ///< That of the source's second output, if it is a speed.
  std::vector<float> low;               ///< The lowest value of each element.
  std::vector<float> high;              ///< The highest.
};

/// The facts about frames as frames_of() returns them.
FrameFacts facts_of(const Recording& frames, bool has_speed);

/// A way to obtain a vector from the frames of an exploration.
struct Code {
  std::string name;                        ///< Such as "curve".
  std::vector<ModuleDescription> modules;  ///< After those of the source, in order.
  std::string output;                      ///< The module that outputs the vector.
  /// Name of the spectrum whose logarithm it is, which precedes it; else empty.
  std::string logarithm_of;
};

/// The codes of a source, as docs/mathematics/suggest.md lists them. The floor of logarithms is not
/// set; see set_floor().
std::vector<Code> codes_of(const FrameSource& source, const FrameFacts& facts);

/// Sets the value that is added before the logarithm.
void set_floor(Code& code, double floor);

/// The tensor product of the one-hot code of the first output of a source with its second output,
/// summed: P06 model 1. The facts are those of the first output.
Code product_code(const FrameSource& source, const FrameFacts& facts);

/// A scaling of a vector.
enum class Scaling { kNone, kStandardized, kUnit };
inline constexpr Scaling kAllScalings[] = {Scaling::kNone, Scaling::kStandardized, Scaling::kUnit};

template <>
struct Choices<Scaling> {
  static const std::vector<std::pair<Scaling, std::string>>& all();
};

/// The code with a module that scales its vector, or itself.
Code scaled(const Code& code, Scaling scaling);

}  // namespace somato
