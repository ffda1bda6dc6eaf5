#!/usr/bin/env bash
# Builds one preset and runs its test programs and samples, two at a time. What each said is in
# build/test-logs/PRESET; the sum is in build/test-logs/PRESET/count as "passed failed skipped".
# usage: scripts/run_tests.sh PRESET
set -euo pipefail
cd "$(dirname "$0")/.."

preset=$1
build=build/$preset
logs=$PWD/build/test-logs/$preset
rm -rf "$logs"
mkdir -p "$logs"

if ! { cmake --preset "$preset" && cmake --build "$build" -- -k 0; } > "$logs/build.txt" 2>&1; then
	cat "$logs/build.txt"
	echo "$preset: the build failed"
	echo "0 1 0" > "$logs/count"
	exit 1
fi

# runOne FILE: its output and exit status end up in the logs.
runOne()
{
	local log
	log=$logs/$( basename "$1" ).txt
	local status=0
	( cd "$( dirname "$1" )" && timeout 600 "./$( basename "$1" )" ) > "$log" 2>&1 || status=$?
	echo "exit status $status" >> "$log"
}
export -f runOne
export logs

# These play every scene, for minutes where nothing is optimised; that bits do not differ there test_demo sees.
slow=' test_gates test_complaints '

# Programs without a source any more are left over from an earlier build.
programs=()
for source in test/test_*.c samples/*.c; do
	program=$build/${source%.c}
	if [[ $preset == *debug && $slow == *" $( basename "$program" ) "* ]]; then
		continue
	fi
	if [ -x "$program" ]; then
		programs+=( "$program" )
	fi
done
printf '%s\0' "${programs[@]}" | xargs -0 -n 1 -P 2 bash -c 'runOne "$1"' _

# sum WORD FILE: adds up the numbers of cmocka's closing lines "[  WORD  ] N test(s)".
sum()
{
	sed -n "s/^\[ *$1 *\] \([0-9]*\) test(s).*/\1/p" "$2" | awk '{ n += $1 } END { print n + 0 }'
}

# What a failing program said, but for the tests that passed. A leak report can have thousands of lines.
showFailures()
{
	local said
	said=$( grep -av '^\[ \(RUN \|      OK\) ' "$1" || true )
	head -n 60 <<< "$said"
	if [ "$( wc -l <<< "$said" )" -gt 60 ]; then
		echo "... the rest is in ${1#"$PWD"/}"
	fi
}

passed=0 failed=0 skipped=0
for program in "${programs[@]}"; do
	log=$logs/$( basename "$program" ).txt
	p=0 f=0 s=0
	if [[ $program == */samples/* ]]; then
		p=1
	else
		p=$( sum PASSED "$log" ) f=$( sum FAILED "$log" ) s=$( sum SKIPPED "$log" )
	fi
	# A crash, a leak found at exit, a failing set-up or no result at all is a failure too.
	if [ "$f" -eq 0 ] && { ! grep -q '^exit status 0$' "$log" || [ $(( p + s )) -eq 0 ]; }; then
		f=1
		[[ $program != */samples/* ]] || p=0
	fi
	if [ "$f" -gt 0 ]; then
		echo "---- $program"
		showFailures "$log"
	fi
	passed=$(( passed + p )) failed=$(( failed + f )) skipped=$(( skipped + s ))
done
if [ ${#programs[@]} -eq 0 ]; then
	echo "$preset: no test program was built"
	failed=1
fi
if [ $skipped -gt 0 ]; then
	echo "$preset: $skipped tests skipped, most for want of data that is not part of the project: see ${logs#"$PWD"/}"
fi
echo "$passed $failed $skipped" > "$logs/count"
[ $failed -eq 0 ]
