#pragma once

#include <string>
#include <string_view>

#include "somato/core/matrix.h"
#include "somato/core/result.h"

namespace somato {

/// A recorded sound.
struct Sound {
  double rate = 0.0;  ///< Samples per second, in Hz.
  Matrix<float>
      samples;  ///< samples x channels; integers are divided so that the range is [-1, 1).
};

/// The sound in the bytes of a WAV file, from the source `where`: PCM of 8, 16, 24 or 32 bits, and
/// floating-point numbers of 32 or 64 bits. A writer to a pipe cannot know the size of the samples
/// and states 0 or the largest number: then they reach to the end of the file. Errors (kData):
/// files that are cut, damaged or of another kind, such as compressed ones; samples that are not
/// finite. Source: Multimedia Programming Interface and Data Specifications 1.0 (Microsoft, IBM),
/// chapter 3, and WAVEFORMATEXTENSIBLE.
Result<Sound> decode_wav(std::string_view bytes, const std::string& where);

}  // namespace somato
