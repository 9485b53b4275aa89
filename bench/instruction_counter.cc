// A plugin of qemu-user that counts instructions for bench/guard_arm64.py. The guest marks the
// begin and the end of what is counted (bench/guard.cc); each end adds a line with the number to
// the file of the argument 'to'.
//
//     g++ -shared -fPIC -O2 -o counter.so bench/instruction_counter.cc
//     qemu-aarch64 -plugin counter.so,to=counts build/arm64/tests/guard_arm64 neon

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstring>

// The part of the interface of plugins, version 1, that this one uses. Debian 12 has no package
// with its header.
extern "C" {
struct qemu_plugin_tb;
enum qemu_plugin_op { QEMU_PLUGIN_INLINE_ADD_U64 };
std::size_t qemu_plugin_tb_n_insns(const qemu_plugin_tb* block);
void qemu_plugin_register_vcpu_tb_trans_cb(std::uint64_t id,
                                           void (*call)(std::uint64_t id, qemu_plugin_tb* block));
void qemu_plugin_register_vcpu_tb_exec_inline(qemu_plugin_tb* block, qemu_plugin_op operation,
                                              void* number, std::uint64_t added);
void qemu_plugin_register_vcpu_syscall_cb(std::uint64_t id,
                                          void (*call)(std::uint64_t id, unsigned processor,
                                                       std::int64_t number, std::uint64_t first,
                                                       std::uint64_t second, std::uint64_t,
                                                       std::uint64_t, std::uint64_t, std::uint64_t,
                                                       std::uint64_t, std::uint64_t));
extern int qemu_plugin_version;
int qemu_plugin_version = 1;
int qemu_plugin_install(std::uint64_t id, const void* machine, int count, char** arguments);
}

namespace {

constexpr std::int64_t kPrctl = 167;  // of Linux on 64-bit ARM
constexpr std::uint64_t kMark = 0x536F6D61;
constexpr std::uint64_t kBegin = 0;

std::uint64_t executed = 0;
std::FILE* counts = nullptr;

void count_block(std::uint64_t /*id*/, qemu_plugin_tb* block) {
  qemu_plugin_register_vcpu_tb_exec_inline(block, QEMU_PLUGIN_INLINE_ADD_U64, &executed,
                                           qemu_plugin_tb_n_insns(block));
}

void see_call(std::uint64_t /*id*/, unsigned /*processor*/, std::int64_t number,
              std::uint64_t first, std::uint64_t second, std::uint64_t /*third*/,
              std::uint64_t /*fourth*/, std::uint64_t /*fifth*/, std::uint64_t /*sixth*/,
              std::uint64_t /*seventh*/, std::uint64_t /*eighth*/) {
  if (number != kPrctl || first != kMark) return;
  if (second == kBegin) {
    executed = 0;
  } else {
    std::fprintf(counts, "%" PRIu64 "\n", executed);
    std::fflush(counts);
  }
}

}  // namespace

int qemu_plugin_install(std::uint64_t id, const void* /*machine*/, int count, char** arguments) {
  constexpr const char* kTo = "to=";
  if (count != 1 || std::strncmp(arguments[0], kTo, std::strlen(kTo)) != 0) {
    std::fprintf(stderr, "instruction_counter: the argument to=FILE is missing\n");
    return 1;
  }
  counts = std::fopen(arguments[0] + std::strlen(kTo), "w");
  if (counts == nullptr) {
    std::perror(arguments[0] + std::strlen(kTo));
    return 1;
  }
  qemu_plugin_register_vcpu_tb_trans_cb(id, count_block);
  qemu_plugin_register_vcpu_syscall_cb(id, see_call);
  return 0;
}
