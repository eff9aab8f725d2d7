# shellcheck shell=bash
# The Debian packages that docent needs, by purpose. Sourced by run, test and the checks of .ci.

packages_build=(
  cmake g++ ninja-build pkg-config
  libasound2-dev libcli11-dev libcurl4-openssl-dev libdrm-dev libegl-dev libfmt-dev libfontconfig-dev libgbm-dev libgles-dev libglm-dev libhidapi-dev
  libjpeg62-turbo-dev libopus-dev libpango1.0-dev libsodium-dev libspng-dev libsqlite3-dev libssl-dev libtomlplusplus-dev libvpx-dev
  nlohmann-json3-dev
  libxcb-icccm4-dev libxcb-keysyms1-dev libxcb1-dev
)
packages_content=(espeak-ng libboost-dev libcgal-dev libdraco-dev libexpat1-dev libfreetype-dev libgeos-dev libgif-dev libheif-dev libicu-dev libmeshoptimizer-dev libprotozero-dev libpugixml-dev librsvg2-dev libsndfile1-dev libwebp-dev libzip-dev mecab mecab-ipadic-utf8 zlib1g-dev)
# All that a docent which was built elsewhere needs to run.
packages_kiosk=(
  fonts-inter fonts-noto-cjk fonts-noto-core
  ca-certificates libasound2 libcairo2 libcurl4 libdrm2 libegl-mesa0 libegl1 libfmt9 libfontconfig1 libgbm1 libgl1-mesa-dri libgles2 libglib2.0-0 libhidapi-hidraw0
  libjpeg62-turbo libopus0 libpango-1.0-0 libpangocairo-1.0-0 libpangoft2-1.0-0 libsodium23 libspng0 libsqlite3-0 libssl3 libstdc++6 libvpx7
  libxcb-icccm4 libxcb-keysyms1 libxcb1 zchunk
)
packages_test=(
  libgmock-dev libgtest-dev librapidcheck-dev mandoc openssl python3 x11-utils xdotool xvfb zchunk zsh
)
# For tests/kiosk, which boots a Debian and installs docent in it; that test is skipped without them.
packages_booted=(busybox-static cpio dosfstools e2fsprogs fdisk kmod mmdebstrap mtools qemu-system-x86 seabios)
# For deploy/package, and to judge what it makes.
packages_package=(debhelper dpkg-dev lintian)
# For deploy/image.
packages_image=(dosfstools e2fsprogs fdisk grub-common grub-efi-amd64-bin mmdebstrap mtools rauc squashfs-tools)
# For the preset bench only: what the paths are compared with.
packages_bench=(librecast-dev)
# ffmpeg makes the films that a test looks at, by the command that staff are told: for .ci only; elsewhere that test is skipped.
packages_check=(clang-19 lld-19 clang-format-19 clang-tidy-19 libclang-rt-19-dev libclang-19-dev llvm-19-dev ffmpeg)
# promtool tries the alerts: 100 MB, and a server that starts on a desk, so for .ci only; elsewhere that test is skipped.
packages_alerts=(prometheus)
