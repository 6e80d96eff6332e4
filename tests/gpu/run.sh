#!/usr/bin/env bash
# The shaders on a device and in the compilers of others. Installs, as root, what is missing of: a Vulkan device in
# software, SPIR-V and GLSL tools, node, Dawn for node.
set -euo pipefail
cd "$(dirname "$0")/../.."
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/target}
export XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-/tmp} # which the device asks for
out=$CARGO_TARGET_DIR/shaders

# Prints the seconds of a part.
part() {
    local name=$1 start=$SECONDS
    shift
    "$@"
    echo "-- $name: $((SECONDS - start)) s"
}

installed() {
    local missing=()
    command -v spirv-val >/dev/null || missing+=(spirv-tools)
    command -v glslangValidator >/dev/null || missing+=(glslang-tools)
    command -v npm >/dev/null || missing+=(nodejs npm)
    ls /usr/share/vulkan/icd.d/*.json >/dev/null 2>&1 || missing+=(mesa-vulkan-drivers)
    ldconfig -p | grep -q libvulkan.so.1 || missing+=(libvulkan1)
    [ ${#missing[@]} -eq 0 ] || { apt-get -qq update && apt-get -qq install -y --no-install-recommends "${missing[@]}"; } >/dev/null
}

# What the million calls of each function spend their time in is optimised; wgpu is not, which halves the build.
quick() {
    CARGO_PROFILE_DEV_DEBUG=0 cargo "$@" -p gpu \
        --config profile.dev.package.gpu.opt-level=2 --config profile.dev.package.bluedither.opt-level=2
}

# Each file that a tool refuses is named; then all of it has failed.
accepted() {
    local ending=$1 refused=0 file
    shift
    for file in "$out"/*"$ending"; do
        "$@" "$file" >"$out/log" 2>&1 || { echo "$* refuses $file:"; head -n 5 "$out/log"; refused=1; }
    done
    return $refused
}

reference_tools() {
    accepted .spv spirv-val --target-env vulkan1.1
    accepted .glsl glslangValidator -S comp
    # Entry points of HLSL are named; SPIR-V is made, since only then all of it is checked.
    accepted .hlsl hlsl
}

hlsl() {
    local entry
    for entry in $(sed -n 's/^void \(main\|bd_seeds_[a-z_0-9]*\)(uint3 .*/\1/p' "$1"); do
        glslangValidator -D -S comp -e "$entry" -V "$1" -o "$out/log.spirv"
    done
}

part "installing" installed
part "building" quick build
part "functions on the device" "$CARGO_TARGET_DIR/debug/gpu"
rm -rf "$out"
part "translating" "$CARGO_TARGET_DIR/debug/gpu" --out "$out"
part "reference tools" reference_tools
