#!/usr/bin/env bash
# Installs those of the named Debian packages that are missing; a line says so where that cannot be done.
set -euo pipefail
missing=()
for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q ' installed$' || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0
{ apt-get update -qq && apt-get install -y -qq --no-install-recommends "${missing[@]}"; } >/dev/null ||
    { echo "These Debian packages are needed: ${missing[*]}" >&2; exit 1; }
