#!/usr/bin/env bash
# Installs the packages of Debian 12 that the named scripts need and this machine lacks; one line says so where that fails.
set -euo pipefail
rust="rustc-web cargo-web rust-web-src rust-web-llvm" # with the source of the standard library, to build it for others
vulkan="libvulkan1 mesa-vulkan-drivers"               # a device in software
tools="spirv-tools glslang-tools"
missing=()
for script in "$@"; do
    case $script in
        firmware) needed="$rust lld-22 qemu-system-arm qemu-system-misc" ;;
        foreign) needed="$rust qemu-user-static gcc-arm-linux-gnueabihf libc6-dev-armhf-cross gcc-s390x-linux-gnu
            libc6-dev-s390x-cross" ;;
        fuzz) needed="g++" ;;
        wasm) needed="$rust lld-22 $(command -v node >/dev/null || echo nodejs)" ;;
        shaders) needed="$vulkan $tools $(command -v npm >/dev/null || echo nodejs npm)" ;;
        export) needed="$vulkan $tools gcc g++ chromium chromium-driver" ;;
        *) echo "'$script' needs no packages: firmware, foreign, fuzz, wasm, shaders and export do" >&2 && exit 1 ;;
    esac
    for package in $needed; do
        dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q ' installed$' || missing+=("$package")
    done
done
[ ${#missing[@]} -gt 0 ] || exit 0
{ apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"; } >/dev/null ||
    { echo "these Debian packages could not be installed, for which root and a network are needed: ${missing[*]}" >&2; exit 1; }
