#!/usr/bin/env bash
# What runs every frame uses + - * / and sqrt only, and neither memory nor anything outside the program: the same bits
# everywhere, and no allocation. Sources are looked at without their comments.
set -euo pipefail
cd "$(dirname "$0")/../.."

libm='a?sinh?|a?cosh?|a?tanh?|atan2|exp[2m]?1?|log(10|1p|2)?|pow|cbrt|hypot|fma|fmod|remainder|floor|ceil|round|rint|nearbyint|l?lrint|l?lround|trunc|fdim|erfc?|tgamma|lgamma|ldexp|frexp|modf'
intrinsics='_mm[0-9]*_(mask[z3]?_)?(rcp|rsqrt|fn?m(add|sub)|fm(addsub|subadd))[a-z0-9_]*|v(rsqrte|recpe|rsqrts|recps|fma|fms|mla|mls)q?_[a-z0-9_]+|__builtin_fmaf?'
memory='malloc|calloc|realloc|free|soleAlloc|soleFree|alloca'
outside='time|clock|rand|setlocale|fopen|printf|getenv'

status=0
# scan FOLDER PATTERN WHY [NAME]: all sources but those of that name
scan()
{
	local file
	for file in $( find "$1" -name '*.[ch]' ! -name "${4:-}" | sort ); do
		if gcc -fpreprocessed -dD -E -P "$file" 2> /dev/null | grep -nE "\\b($2)[[:space:]]*\\("; then
			echo "$file: $3"
			status=1
		fi
	done
}

for folder in src/base src/place src/limb; do
	if [ -d $folder ]; then
		scan $folder "($libm)[fl]?|$intrinsics" "not the same bits everywhere"
	fi
done
for folder in src/place src/limb; do
	if [ -d $folder ]; then
		# crowd.c makes and ends crowds; its frame is in crowd_frame.c.
		scan $folder "$memory|$outside" "no allocation and nothing from outside in a frame" crowd.c
	fi
done
exit $status
