#!/usr/bin/env bash
# The shaders on a device and in the compilers of others: every function a million times against Rust; what naga makes
# of them, by the reference tools; the WGSL by Tint, which Chromium has; and what samplers cost on a GPU's compiler.
# Missing packages are installed, for which it has to be root on Debian: a Vulkan device in software, the tools, node,
# and Dawn for node by npm.
set -euo pipefail
cd "$(dirname "$0")/../.."
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/target}
export XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-/tmp} # which the device asks for
out=$CARGO_TARGET_DIR/shaders
dawn=$CARGO_TARGET_DIR/dawn

# Prints the seconds of a part.
part() {
    local name=$1 start=$SECONDS
    shift
    "$@"
    echo "-- $name: $((SECONDS - start)) s"
}

installed() {
    tests/packages.sh shaders
    # Tint comes in the package of Dawn.
    npm install --prefix "$dawn" --no-audit --no-fund --no-save --silent webgpu@0.6
}

# What the million calls of each function spend their time in is optimised; wgpu is not, which halves the build.
quick() {
    CARGO_PROFILE_DEV_DEBUG=0 cargo "$@" -p gpu \
        --config profile.dev.package.gpu.opt-level=2 --config profile.dev.package.bluedither.opt-level=2
}

# Each file that a tool refuses is named.
accepted() {
    local ending=$1 refused=0 file
    shift
    for file in "$out"/*"$ending"; do
        "$@" "$file" >"$out/log" 2>&1 || { echo "$* refuses $file:"; head -n 5 "$out/log"; refused=1; }
    done
    return "$refused"
}

reference_tools() {
    accepted .spv spirv-val --target-env vulkan1.1
    accepted .glsl glslangValidator -S comp
    accepted .hlsl hlsl
}

# Entry points are named; SPIR-V is made, since only then all of it is checked.
hlsl() {
    local entry entries
    entries=$(sed -n 's/^void \(main\|bd_seeds_[a-z_0-9]*\)(uint3 .*/\1/p' "$1")
    [ -n "$entries" ] || { echo "it has no entry point"; return 1; }
    for entry in $entries; do
        glslangValidator -D -Od -S comp -e "$entry" -V "$1" -o "$out/log.spirv" || return 1
    done
}

# Without a device: one line that says how to get one.
without_a_device() {
    local line
    if line=$(VK_DRIVER_FILES=/nonexistent VK_ICD_FILENAMES=/nonexistent "$CARGO_TARGET_DIR/debug/gpu" 2>&1); then
        echo "without a device this should have failed" && return 1
    fi
    [[ $line == "error: there is no Vulkan device: one in software is installed by"* ]] || { echo "$line"; return 1; }
}

# What shaders cost on a real compiler, with bounds; a file of one's own; and one line where the driver is missing.
costs() {
    local cost=$CARGO_TARGET_DIR/debug/cost line
    "$cost" | tee "$CARGO_TARGET_DIR/cost.md"
    printf '%s\n' '@compute @workgroup_size(64)' 'fn mine(@builtin(global_invocation_id) id: vec3<u32>) {' \
        '    bd_filled[id.x] = vec4<f32>(bd_unit_to_f32(bd_hash_mix(id.x)));' '}' >"$CARGO_TARGET_DIR/mine.wgsl"
    "$cost" "$CARGO_TARGET_DIR/mine.wgsl" | grep '^| mine | '
    if line=$(VK_DRIVER_FILES=/nonexistent VK_ICD_FILENAMES=/nonexistent "$cost" 2>&1); then
        echo "without the driver this should have failed" && return 1
    fi
    [[ $line == "error: Mesa's RADV, which compiles without a GPU, is not there: "* ]] || { echo "$line"; return 1; }
}

part "installing" installed
part "building" quick build
part "without a device" without_a_device
part "costs" costs
part "functions on the device" "$CARGO_TARGET_DIR/debug/gpu"
rm -rf "$out"
part "writing" "$CARGO_TARGET_DIR/debug/gpu" --out "$out"
part "reference tools" reference_tools
part "Tint" node tests/gpu/tint.mjs "$out" "$dawn"
