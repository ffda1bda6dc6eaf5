#!/usr/bin/env bash
# Instructions of the benchmark's counted cases, by callgrind: within 3 % of bench/baseline.csv, or the change has to be
# written down there: test/checks/instructions.sh --renew. Needs build/release, and the compiler of the baseline: with
# another the counts say nothing, and nothing is compared.
set -euo pipefail
cd "$(dirname "$0")/../.."

bench=build/release/bench/sole_bench
baseline=bench/baseline.csv
work=$( mktemp -d )
trap 'rm -rf "$work"' EXIT

compiler()
{
	echo "$( uname -m ) gcc $( gcc -dumpfullversion )"
}

# count CASE: instructions of one run, nothing where this machine cannot run it. The C library picks its memory functions
# by what the machine has: the plainest.
count()
{
	if GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX512VL,-AVX2,-AVX2_Usable,-ERMS,-FSRM valgrind --tool=callgrind \
		--callgrind-out-file="$work/counts" --toggle-collect=benchCounted "$bench" --count "$1" > "$work/log" 2>&1; then
		sed -n 's/^summary: \([0-9]*\)$/\1/p' "$work/counts"
	fi
}

# countAll: a line a case as in the baseline.
countAll()
{
	echo "case,instructions,build"
	local name items
	$bench --counted | while read -r name items; do
		echo "$name,$( awk -v n="$( count "$name" )" -v items="$items" 'BEGIN { printf "%.1f", n / items }' ),$( compiler )"
	done
}

if [ "${1:-}" = --renew ]; then
	countAll > "$work/baseline"
	cp "$work/baseline" $baseline
	exit
fi
if ! grep -q ",$( compiler )\$" $baseline; then
	echo "left out: $baseline is of another compiler than $( compiler )"
	exit
fi
countAll > "$work/now"
awk -F, '
	NR == FNR { before[$1] = $2; next }
	FNR == 1 { next }
	$2 == 0 { print $1 ": left out: this machine cannot run it"; delete before[$1]; next }
	{
		change = before[$1] > 0 ? 100 * ( $2 / before[$1] - 1 ) : 100
		printf "%-24s %10.1f %10.1f  %+.1f %%\n", $1, before[$1], $2, change
		if ( change > 3 || change < -3 ) { bad = 1 }
		delete before[$1]
	}
	END {
		for ( name in before ) { if ( name != "case" ) { print name ": no longer counted"; bad = 1 } }
		if ( bad ) { print "Meant to be so? Write it down: test/checks/instructions.sh --renew" }
		exit bad
	}' $baseline "$work/now"
