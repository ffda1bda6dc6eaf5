#!/usr/bin/env bash
# Every public header compiles alone, as strict C11 and as C++17, without a warning.
set -euo pipefail
cd "$(dirname "$0")/../.."

warnings=( -Wall -Wextra -pedantic -Werror -Wshadow -Wundef -Iinclude -fsyntax-only )
count=0
for header in include/sole/*.h; do
	line="#include \"${header#include/}\""
	gcc -std=c11 -Wconversion "${warnings[@]}" -x c - <<< "$line"
	clang-14 -std=c11 -Wconversion "${warnings[@]}" -x c - <<< "$line"
	g++ -std=c++17 "${warnings[@]}" -x c++ - <<< "$line"
	count=$(( count + 1 ))
done
echo "$count headers"
[ $count -gt 0 ]
