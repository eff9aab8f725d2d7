# shellcheck shell=bash
# The Debian packages that docent needs, by purpose. Sourced by run, test and the checks of .ci.

packages_build=(
  cmake g++ ninja-build pkg-config
  libcli11-dev libdrm-dev libegl-dev libfmt-dev libgbm-dev libgles-dev libglm-dev libhidapi-dev
  libjpeg62-turbo-dev libpango1.0-dev libsodium-dev libspng-dev libsqlite3-dev libtomlplusplus-dev
  libxcb-icccm4-dev libxcb-keysyms1-dev libxcb1-dev
)
packages_content=(libboost-dev libcgal-dev librsvg2-dev nlohmann-json3-dev)
packages_kiosk=(
  fonts-inter fonts-noto-cjk fonts-noto-core
  libegl-mesa0 libegl1 libgl1-mesa-dri libgles2 libhidapi-hidraw0
)
packages_test=(
  libgmock-dev libgtest-dev librapidcheck-dev python3 x11-utils xdotool xvfb
)
# For the preset bench only: what the paths are compared with.
packages_bench=(librecast-dev)
packages_check=(clang-19 clang-format-19 clang-tidy-19 libclang-rt-19-dev)
