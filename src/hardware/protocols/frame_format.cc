#include "hardware/protocols/frame_format.h"

namespace somato {

using devices::FrameFormat;

const std::vector<std::pair<FrameFormat, std::string>>& Choices<FrameFormat>::all() {
  static const std::vector<std::pair<FrameFormat, std::string>> formats{
      {FrameFormat::kFrames, "frames"},
      {FrameFormat::kLines, "lines"},
      {FrameFormat::kAnyskin, "anyskin"}};
  return formats;
}

}  // namespace somato
