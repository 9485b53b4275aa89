#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>

#include "base/files/scratch_folder.h"
#include "somato/core/result.h"
#include "terminal/child_process.h"

namespace somato::program {

/// The address of a file.
std::string file_address(const std::string& path);

/// A page in a browser without a window: Chromium, which is controlled by the DevTools protocol
/// through a socket that only this program has.
class HeadlessBrowser {
 public:
  /// Opens the page. Errors: kSystem if no Chromium is installed or it does not answer.
  static Result<HeadlessBrowser> open(const std::string& address, std::size_t width,
                                      std::size_t height);

  /// Opens another page in its place; what the first one had is gone. Errors: kSystem.
  Result<void> go_to(const std::string& address);

  /// Waits until `condition`, an expression in JavaScript, is true, and what it depends on is
  /// drawn. Errors: kSystem if this takes longer than a minute.
  Result<void> wait_until(const std::string& condition);

  /// The value of an expression in JavaScript, or of its promise. Errors: kSystem, also if it
  /// throws.
  Result<nlohmann::json> value_of(const std::string& expression);

  /// The bytes of a PDF file of the page on paper of this size in mm, without margins. Errors:
  /// kSystem.
  Result<std::string> printed(double width, double height);

  /// The bytes of a PNG file of the page. Errors: kSystem.
  Result<std::string> picture();

  /// The same of a page that nothing changes, once two pictures are equal. Errors: kSystem.
  Result<std::string> settled_picture();

 private:
  HeadlessBrowser(ScratchFolder profile, ChildProcess process)
      : profile_(std::move(profile)), process_(std::move(process)) {}

  Result<void> attach();
  Result<nlohmann::json> call(const std::string& method, const nlohmann::json& parameters);
  Result<nlohmann::json> next_message();

  ScratchFolder profile_;
  ChildProcess process_;
  std::string session_;
  std::string received_;
  int calls_ = 0;
};

}  // namespace somato::program
