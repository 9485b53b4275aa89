#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system_description.h"
#include "somato/recording/recording.h"

namespace somato {

/// Modules that output the frames from which codes are computed.
struct FrameSource {
  std::vector<ModuleDescription> modules;
  /// The modules that output them: the frames of a sense, then of a speed if there is one; or those
  /// of the two senses of a product.
  std::vector<std::string> outputs;
};

/// A name for the modules of each channel, made of letters, digits and '_', all different and
/// different from the names of other modules: the channel's own if possible.
std::vector<std::string> module_names(const std::vector<std::string>& channels);

/// Whether an exploration has more than one frame of the channel.
bool has_several_frames(const Recording& recording, std::size_t channel);

/// Whether the elements of the channel may have different units, like the columns of a table: it
/// has no unit, and explorations have one frame of it.
bool may_mix_units(const Recording& recording, std::size_t channel);

/// The source that reads a channel of the recording. Missing values are replaced by the preceding
/// ones, and without these by the mean of the element's known values in the recording.
FrameSource channel_source(const std::string& module, const Recording& recording,
                           std::size_t channel);

/// The source that continues `source` with the frames from the onset of contact, and takes its
/// module and length from `onset`.
struct Onset {
  double threshold = 0.0;  ///< Change since the first frame, of any element.
  std::size_t length = 0;  ///< Frames, available in every exploration.
};
FrameSource from_onset(const FrameSource& source, const Onset& onset);

/// The frames that the source outputs for every exploration of the recording: channels that are
/// named after `outputs`. Errors: those of the modules.
Result<Recording> frames_of(const Recording& recording, const FrameSource& source,
                            std::size_t threads);

/// The onset of the frames of the first channel, if contact begins at different moments: the first
/// frame whose change is at least a fifth of the median of the largest changes. Nothing if an
/// exploration has no onset, if onsets are spread over at most a twentieth of the median
/// exploration, or if fewer than 8 frames remain.
std::optional<Onset> find_varying_onset(const Recording& frames);

}  // namespace somato
