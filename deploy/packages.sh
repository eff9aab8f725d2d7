# shellcheck shell=bash
# The Debian packages that docent needs, by purpose. Sourced by run, test and the checks of .ci.

packages_build=(
  cmake g++ ninja-build pkg-config
  libcli11-dev libdrm-dev libegl-dev libfmt-dev libgbm-dev libgles-dev libglm-dev libhidapi-dev
  libjpeg62-turbo-dev libpango1.0-dev libsodium-dev libspng-dev libsqlite3-dev libtomlplusplus-dev
  nlohmann-json3-dev
  libxcb-icccm4-dev libxcb-keysyms1-dev libxcb1-dev
)
packages_content=(libboost-dev libcgal-dev librsvg2-dev)
# All that a docent which was built elsewhere needs to run.
packages_kiosk=(
  fonts-inter fonts-noto-cjk fonts-noto-core
  libcairo2 libdrm2 libegl-mesa0 libegl1 libfmt9 libgbm1 libgl1-mesa-dri libgles2 libglib2.0-0 libhidapi-hidraw0
  libjpeg62-turbo libpango-1.0-0 libpangocairo-1.0-0 libsodium23 libspng0 libsqlite3-0 libstdc++6
  libxcb-icccm4 libxcb-keysyms1 libxcb1
)
packages_test=(
  libgmock-dev libgtest-dev librapidcheck-dev mandoc python3 x11-utils xdotool xvfb zsh
)
# For tests/kiosk, which boots a Debian and installs docent in it; that test is skipped without them.
packages_booted=(busybox-static cpio e2fsprogs kmod mmdebstrap qemu-system-x86 seabios)
# For the preset bench only: what the paths are compared with.
packages_bench=(librecast-dev)
packages_check=(clang-19 clang-format-19 clang-tidy-19 libclang-rt-19-dev)
