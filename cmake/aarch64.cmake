# Toolchain: builds for 64-bit ARM with the cross compiler of Debian and its packages for arm64 (dpkg --add-architecture
# arm64); programs of the build run under qemu-aarch64, of the package qemu-user. scripts/other_systems.sh arm64
# installs all of them.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)

# Debian's packages of both architectures are in the same tree: CMake searches the folders of the compiler's
# architecture, and those that the architectures share.
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(ENV{PKG_CONFIG_LIBDIR} /usr/lib/aarch64-linux-gnu/pkgconfig:/usr/share/pkgconfig)
