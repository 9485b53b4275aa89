#pragma once

#include <string>
#include <utility>

#include "base/files/scratch_folder.h"
#include "somato/core/result.h"

namespace somato::program {

/// Opens an address in the user's browser, with xdg-open. The address contains a token, and other
/// users of the machine can read the arguments of a program: a file that only this user can read
/// leads the browser to the address. It is removed with this object.
class BrowserStart {
 public:
  /// Errors: kSystem without xdg-open, and if the file cannot be written.
  static Result<BrowserStart> open(const std::string& address);

 private:
  explicit BrowserStart(ScratchFolder folder) : folder_(std::move(folder)) {}

  ScratchFolder folder_;
};

}  // namespace somato::program
