#!/usr/bin/env bash
# Builds Sole and tests it. The last line is the sum of all tests and checks; the exit status is 1 when any failed.
# usage: ./test.sh [--quick]
set -euo pipefail
cd "$(dirname "$0")"
export LC_ALL=C

quick=no
case "$*" in
	'') ;;
	--quick) quick=yes ;;
	*) echo "usage: ./test.sh [--quick]    --quick: one configuration, without the checks of bits and clang-tidy" >&2; exit 2 ;;
esac

if [ $quick = yes ]; then
	presets=( release )
	echo "Tests Sole quickly: one configuration (gcc, optimised) and the checks but bits and clang-tidy."
else
	presets=( release debug clang clang-debug sanitize )
	echo "Tests Sole in full: gcc and clang, with and without optimisation, the sanitizers, and all checks."
fi
echo "Everything it builds and writes is below build/."

passed=0 failed=0 skipped=0
logs=build/test-logs
mkdir -p $logs

report()
{
	printf '%-7s %-34s %4d s\n' "$1" "$2" "$3"
}

# check NAME: runs test/checks/NAME.sh, which counts as one test. What it leaves out is said.
check()
{
	local start=$SECONDS log=$logs/check-$1.txt
	if "test/checks/$1.sh" > "$log" 2>&1; then
		passed=$(( passed + 1 ))
		report ok "check $1" $(( SECONDS - start ))
		grep 'left out' "$log" || true
	else
		failed=$(( failed + 1 ))
		cat "$log"
		report FAILED "check $1" $(( SECONDS - start ))
	fi
}

# tests PRESET: builds it and runs its programs.
tests()
{
	local start=$SECONDS word=ok p f s
	rm -f "$logs/$1/count"
	scripts/run_tests.sh "$1" || word=FAILED
	if ! read -r p f s < "$logs/$1/count"; then
		word=FAILED p=0 f=1 s=0
	fi
	passed=$(( passed + p )) failed=$(( failed + f )) skipped=$(( skipped + s ))
	report $word "tests $1: $p passed, $f failed" $(( SECONDS - start ))
}

scripts/setup.sh build test
check format
for preset in "${presets[@]}"; do
	tests "$preset"
done
check headers
check dropin
check arrows
check numerics
check docs
check version
check install
check glb
check instructions
check wasm
check viewer
if [ $quick = no ]; then
	check bits
	check tidy
fi

tail=
if [ $skipped -gt 0 ]; then
	tail=", $skipped skipped"
fi
echo "$passed passed, $failed failed$tail"
[ $failed -eq 0 ]
