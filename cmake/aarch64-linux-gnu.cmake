# 64-bit Arm with Debian's cross compiler. The arm64 packages lie beside those of this machine
# (scripts/install_dependencies.sh arm), so QEMU finds the libraries where Debian puts them.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)
