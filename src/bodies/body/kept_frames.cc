#include "bodies/body/kept_frames.h"

namespace somato {

const std::vector<std::pair<KeptFrames, std::string>>& Choices<KeptFrames>::all() {
  static const std::vector<std::pair<KeptFrames, std::string>> choices{
      {KeptFrames::kLatest, "latest"}, {KeptFrames::kEvery, "every"}};
  return choices;
}

}  // namespace somato
