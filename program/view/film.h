#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "base/files/scratch_folder.h"
#include "bodies/hands/png.h"
#include "somato/core/result.h"
#include "terminal/child_process.h"

namespace somato::program {

/// Pictures of a second in a film.
inline constexpr std::size_t kFilmRate = 20;

/// A picture as a frame of the format Y4M, with the colours of BT.709: its luminance, and the two
/// chrominances of each square of four pixels. Throws InvalidArgument for odd sizes.
std::string y4m_frame(const detail::Image& picture);

/// A film in WebM, VP9, which is encoded by the program vpxenc of libvpx.
class Film {
 public:
  /// Errors: kSystem if vpxenc is not installed.
  static Result<Film> begin(std::size_t width, std::size_t height);

  /// Adds a picture of that size as a frame. Errors: kSystem if vpxenc fails.
  Result<void> add(const std::string& frame) { return encoder_.send(frame); }

  /// Completes the film and saves it, atomically. Errors: kSystem.
  Result<void> save(const std::string& path);

 private:
  Film(ScratchFolder folder, ChildProcess encoder)
      : folder_(std::move(folder)), encoder_(std::move(encoder)) {}

  ScratchFolder folder_;
  ChildProcess encoder_;
};

}  // namespace somato::program
