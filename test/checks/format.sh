#!/usr/bin/env bash
# Every C file is formatted as .clang-format says.
set -euo pipefail
cd "$(dirname "$0")/../.."

if ! files=$( git ls-files '*.c' '*.h' 2> /dev/null ); then
	files=$( find . \( -name build -o -name 'build-*' -o -name node_modules \) -prune -o -name '*.[ch]' -print )
fi
xargs -d '\n' clang-format-14 --dry-run -Werror <<< "$files"
