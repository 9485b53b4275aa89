#include "bodies/physics/physics.h"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <mutex>

namespace somato::detail {
namespace {

// A file in memory for the engine's loader.
class MemoryFile {
 public:
  MemoryFile(const char* name, const std::string& content) : files_(std::make_unique<mjVFS>()) {
    mj_defaultVFS(files_.get());
#if mjVERSION_HEADER >= 313
    mj_addBufferVFS(files_.get(), name, content.data(), static_cast<int>(content.size()));
#else
    mj_makeEmptyFileVFS(files_.get(), name, static_cast<int>(content.size()));
    std::memcpy(files_->filedata[0], content.data(), content.size());
#endif
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile(MemoryFile&&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  MemoryFile& operator=(MemoryFile&&) = delete;
  ~MemoryFile() { mj_deleteVFS(files_.get()); }

  const mjVFS* get() const { return files_.get(); }

 private:
  std::unique_ptr<mjVFS> files_;
};

// Prevents the engine from writing a log into the working folder. Its warnings are also counted in
// the data.
void keep_quiet() {
  mju_user_warning = [](const char*) {};
}

}  // namespace

Result<std::shared_ptr<mjModel>> compile_model(const std::string& mjcf, const std::string& name) {
  // The engine's compiler keeps its last model in a global variable.
  static std::mutex compiler;
  const std::scoped_lock lock(compiler);
  keep_quiet();
  constexpr const char* kFile = "model.xml";
  const MemoryFile file(kFile, mjcf);
  std::array<char, 1024> message{};
  mjModel* model = mj_loadXML(kFile, file.get(), message.data(), static_cast<int>(message.size()));
  if (!model) {
    return fail(ErrorKind::kData,
                fmt::format("the physics engine rejects the model: {}", message.data()), name);
  }
  return std::shared_ptr<mjModel>(model, ModelDeleter{});
}

Result<PhysicsData> make_data(const PhysicsModel& model) {
  PhysicsData data(mj_makeData(model.get()));
  if (!data) return fail(ErrorKind::kSystem, "not enough memory for the simulation's state");
  return data;
}

Result<void> check_stable(const mjData& data) {
  for (const int warning :
       {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC, mjWARN_CONTACTFULL, mjWARN_CNSTRFULL}) {
    if (data.warning[warning].number == 0) continue;
    return fail(ErrorKind::kData,
                fmt::format("the simulation diverged: {}",
                            mju_warningText(
                                warning, static_cast<std::size_t>(data.warning[warning].lastinfo))),
                {}, "use a smaller time step, a heavier object or less placement noise");
  }
  return {};
}

}  // namespace somato::detail
