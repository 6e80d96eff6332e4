#!/usr/bin/env bash
# Compiles exported shaders by glslang, and accepts SPIR-V by SPIRV-Tools: shaders.sh DIR, as written by
# `cargo run -p export -- --out DIR`.
set -euo pipefail
cd "$1/shaders"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# What a tool refuses is named.
accepted() {
    local file=$1
    shift
    "$@" >"$scratch/log" 2>&1 || { echo "$file is refused by $1:"; head -n 5 "$scratch/log"; exit 1; }
}

for file in *.spv; do
    accepted "$file" spirv-val --target-env vulkan1.1 "$file"
done
# The others are included: in the least shader that there is.
for file in *.glsl; do
    version=$(sed -n 's/^.*a shader of #version \(.*\) or later.*/\1/p' "$file")
    printf '#version %s\n' "$version" | cat - "$file" <(echo 'layout(local_size_x = 1) in; void main() {}') >"$scratch/s.comp"
    accepted "$file" glslangValidator "$scratch/s.comp"
done
for file in *.hlsl; do
    cat "$file" <(echo '[numthreads(1, 1, 1)] void main() {}') >"$scratch/s.hlsl"
    accepted "$file" glslangValidator -D -S comp -e main -V "$scratch/s.hlsl" -o "$scratch/s.spv"
done
echo "$(ls *.spv *.glsl *.hlsl | wc -l) shaders are accepted"
