#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "somato/core/check.h"
#include "somato/recording/inspect_recording.h"
#include "somato/recording/recording_file.h"
#include "somato/recording/recover_recording.h"

namespace {

// Files in memory, which exist as long as the fuzzer.
struct Folder {
  Folder() {
    const bool has_memory = std::filesystem::is_directory("/dev/shm");
    name = (has_memory ? "/dev/shm" : std::filesystem::temp_directory_path().string());
    name += "/somato-fuzz-XXXXXX";
    SOMATO_ASSERT(::mkdtemp(name.data()) != nullptr);
  }
  Folder(const Folder&) = delete;
  Folder(Folder&&) = delete;
  Folder& operator=(const Folder&) = delete;
  Folder& operator=(Folder&&) = delete;
  ~Folder() { std::filesystem::remove_all(name); }

  std::string name;
};

}  // namespace

// A valid recording reads back when it is written; the part that recovery saves can be read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  const std::string in = folder.name + "/in";
  const std::string out = folder.name + "/out";
  std::ofstream(in, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  const auto summary = somato::inspect_recording(in);
  const auto recording = somato::read_recording(in);
  SOMATO_ASSERT(!recording || (summary && !summary->damage));
  if (recording && somato::write_recording(out, *recording)) {
    const auto again = somato::read_recording(out);
    SOMATO_ASSERT(again && again->explorations.size() == recording->explorations.size());
  }
  const auto report = somato::recover_recording(in, out);
  if (report) {
    const auto saved = somato::inspect_recording(out);
    SOMATO_ASSERT(saved && !saved->damage);
  }
  return 0;
}
