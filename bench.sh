#!/usr/bin/env bash
# Measures how fast Sole is beside its peers and writes docs/performance.md with tables, plots, machine and flags. A
# quarter of an hour; the figures mean most on a machine that does nothing else.
# usage: ./bench.sh [--quick]
set -euo pipefail
cd "$(dirname "$0")"
export LC_ALL=C
trap 'echo "bench: stopped at line $LINENO: what went wrong is said above" >&2' ERR

case "$*" in
	'') options=( --runs 21 ) ;;
	--quick) options=( --runs 5 --largest 100000 ) ;;
	*) echo "usage: ./bench.sh [--quick]    --quick: fewer runs, no more than 100,000 triangles" >&2; exit 2 ;;
esac
echo "Builds sole_bench, measures every case with all variants in turn, and writes docs/performance.md and its plots."

scripts/setup.sh build bench
build=build/bench
mkdir -p $build
if ! { cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release -DSOLE_BENCH=ON && cmake --build $build --target sole_bench sole_bench_stages; } \
	> $build/build.log 2>&1; then
	cat $build/build.log >&2
	exit 1
fi
bench=$build/bench/sole_bench
csv=$build/bench.csv
$bench "${options[@]}" -o $csv
${bench}_stages >> $csv

# pivot PATTERN: cases whose names match, a column for each variant, median and (min).
pivot()
{
	awk -F, -v pattern="$1" '
		NR > 1 && $1 ~ pattern {
			if ( !( $1 in seenCase ) ) { seenCase[$1] = 1; cases[++caseCount] = $1; unit[$1] = $3 }
			if ( !( $2 in seenVariant ) ) { seenVariant[$2] = 1; variants[++variantCount] = $2 }
			value[$1, $2] = $5 == $6 ? sprintf( "%.1f", $5 ) : sprintf( "%.0f (%.0f)", $5, $6 )
		}
		END {
			printf "| case | per |"
			for ( v = 1; v <= variantCount; ++v ) { printf " %s |", variants[v] }
			printf "\n|---|---|"
			for ( v = 1; v <= variantCount; ++v ) { printf "---:|" }
			for ( c = 1; c <= caseCount; ++c ) {
				printf "\n| %s | %s |", cases[c], unit[cases[c]]
				for ( v = 1; v <= variantCount; ++v ) { printf " %s |", value[cases[c], variants[v]] }
			}
			print ""
		}' $csv
}

# series STEM VARIANT: size and median of cases STEM-SIZE, for plots.
series()
{
	awk -F, -v stem="$1" -v variant="$2" '
		$2 == variant && index( $1, stem "-" ) == 1 {
			size = substr( $1, length( stem ) + 2 )
			if ( size ~ /^[0-9]+[kM]?$/ ) { print size * ( size ~ /M$/ ? 1e6 : ( size ~ /k$/ ? 1e3 : 1 ) ), $5 }
		}' $csv
}

# plot FILE XLABEL YLABEL STEM:VARIANT...
plot()
{
	local file=$1 x=$2 y=$3 commands='' part data
	shift 3
	for part in "$@"; do
		data=$build/plot-${part//:/-}.txt
		series "${part%:*}" "${part#*:}" > "$data"
		if [ -s "$data" ]; then
			commands+="${commands:+, }'$data' with linespoints title '${part#*:} ${part%:*}'"
		fi
	done
	gnuplot <<- PLOT
		set terminal svg size 760,440 font 'sans-serif,12' background 'white'
		set output '$file'
		set logscale xy
		set format x '%.0s%c'
		set xlabel '$x'
		set ylabel '$y'
		set key outside right
		set grid
		plot $commands
	PLOT
}

# growth: of each kind of crowd, what a character costs among 100,000 to among 1,000, and how much faster two threads are.
# From the least of all runs: what others do on the machine at the time is in the rest.
growth()
{
	awk -F, '
		{ least[$1, $2] = $6 }
		$1 ~ /^crowd-.*-1k$/ && $2 == "1-thread" { kinds[++count] = substr( $1, 1, length( $1 ) - 3 ) }
		function ratio( a, b ) { return b > 0 && a > 0 ? sprintf( "%.2f", a / b ) : "" }
		function faster( name ) { return ratio( least[name, "1-thread"], least[name, "2-threads"] ) }
		END {
			for ( i = 1; i <= count; ++i ) {
				kind = kinds[i]
				printf "| %s | %s | %s | %s | %s |\n", kind, ratio( least[kind "-100k", "1-thread"], least[kind "-1k", "1-thread"] ),
					faster( kind "-1k" ), faster( kind "-10k" ), faster( kind "-100k" )
			}
			printf "| arithmetic that shares nothing | | %s | | |\n", faster( "spin" )
		}' $csv
}

# stages: what each stage of a solve takes, most of which are in functions of the stage's own name: instructions, and what
# a machine with this one's first caches would miss.
stages()
{
	local names
	names=$( sed -nE 's/^void (sole[A-Za-z]*)\( (const )?solePlaceWork\* work.*/\1/p' src/place/place.h | sort -u )
	valgrind --tool=callgrind --cache-sim=yes --branch-sim=yes --callgrind-out-file=$build/solve.callgrind \
		--toggle-collect=benchCounted $bench --count biped-solve/sole > $build/solve.log 2>&1
	callgrind_annotate --inclusive=yes --threshold=100 --show-percs=no --show=Ir,I1mr,D1mr,D1mw,Bcm $build/solve.callgrind |
		awk -v names="$names" '
		BEGIN { n = split( names, list ); for ( i = 1; i <= n; ++i ) { wanted[list[i]] = 1 } }
		function each( figure ) { gsub( /,/, "", figure ); return ( figure == "." ? 0 : figure ) / 256 }
		match( $0, /:sole[A-Za-z]*/ ) {
			name = substr( $0, RSTART + 1, RLENGTH - 1 )
			if ( name in wanted && !( name in seen ) ) {
				seen[name] = 1
				printf "| %s | %.0f | %.1f | %.1f | %.1f |\n", name, each( $1 ), each( $2 ), each( $3 ) + each( $4 ), each( $5 )
			}
		}'
}

machine=$( sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1 )
flags=$( grep -o '"command": ".*src/ground/walk.c' $build/compile_commands.json 2> /dev/null | grep -o ' -[OfD][^ ]*' | tr -d '\n' || true )

writePage()
{
	cat <<- TEXT
		<!-- Made by ./bench.sh: change that, not this. -->
		# How fast it is

		Nanoseconds, median and (least) of all runs. Variants of a case are taken in turn in one process, so ratios
		within a line hold better than figures do from machine to machine; where others were at work beside it, the least
		says more than the median. Measured on $machine, $( nproc )
		cores, one in use but for two threads; gcc $( gcc -dumpfullversion ),$flags.

		Not all that is wished for is reached: [design-reasons.md](design-reasons.md) says what limits it.

		## Ground

		Straight down, from a metre over the ground to a metre below, over rolling ground of so many triangles of a
		quarter of a metre; answers with point and normal. "In order" are the same questions sorted along a Z curve.
		\`ray-flat\` and those after it are samples of the program. \`sole\` is asked one by one, \`sole-batch\` 40 at once by \`soleCastProbes()\`. \`five-rays\` are five under one
		foot, asked at once. Spheres have a radius of 0.1 m. \`ray-field\` is a height field of as many triangles. Peers
		are those that Debian has: Embree (robust; one ray, or five of a packet of eight), ODE and Bullet (without their
		broad phases).

		$( pivot '^(ray|five|sphere)-' )

		![Cost of a question against triangles](performance-triangles.svg)

		Building, fitting to moved vertices in place, and memory beyond the mesh itself (12 bytes a vertex, 12 a triangle):

		$( pivot '^(build|refit|memory)-[0-9]' )

		## A frame

		One biped, the mannequin on its walk, with hits taken beforehand; beside the systems that Sole is compared with,
		which do much less. Then crowds by the same calls one after another: root on the ground, gather, cast into
		100,000 triangles, solve, apply.

		$( pivot '^biped-' )

		$( pivot '^crowd-[0-9]' )

		Where a solve goes by time, each stage of all frames of the walk; looking at the clock takes a little more than
		what is taken off for it:

		$( pivot '^stage ' )

		And by counts of callgrind, a character and frame, a stage with what it calls: instructions, lines of code and of
		data that were not in the first caches (as callgrind plays them), branches foretold wrongly.

		| stage | instructions | code | data | branches |
		|---|---:|---:|---:|---:|
		$( stages )

		## Legs by themselves

		Reach, two bones, the foot and new local turns by \`soleSolveLegBatch()\`, in each width that the machine has, and
		one by one, which is what all widths equal to the bit; beside the two jobs of ozz in plain C (\`baselines/\`), which
		do less: two bones and an aim, no new local turns.

		$( pivot '^legs-' )

		## Crowds

		By the calls of \`crowd.h\`, 64 characters at a time with a work area, roots on the ground included: every level of
		detail, every frame or every fourth, by one thread and by two that take the next 64 from one counter. What all
		legs go through goes through wide kernels, as wide as the machine has them. The second thread is started anew in
		every frame, which takes some 60 us: a host that keeps its threads does better where they are few.

		$( pivot '^crowd-[fh]' )

		A thousand characters in full detail over grounds of so many triangles, and over a flat plane:

		$( pivot '^crowd-on-' )

		$( pivot '^memory-(biped|crowd)' )

		A character among 100,000 against one among 1,000, and how much faster two threads are, from the least of all
		runs. The last line is what two threads of plain arithmetic had of the machine in the same minutes: with others at
		work beside it that is less than 2, and no crowd can have more.

		| crowd | growth | 2 threads, 1k | 10k | 100k |
		|---|---:|---:|---:|---:|
		$( growth )

		![Cost of a character against characters](performance-characters.svg)
	TEXT
}

plot docs/performance-triangles.svg triangles 'ns a question' ray-scattered:sole ray-scattered:sole-batch ray-scattered:embree ray-scattered:ode \
	ray-scattered:bullet five-rays:sole five-rays:embree sphere-scattered:sole sphere-scattered:bullet ray-field:sole
plot docs/performance-characters.svg characters 'ns a character' crowd:sole-calls crowd-full:1-thread crowd-full:2-threads crowd-few:1-thread \
	crowd-height:1-thread crowd-full-4th:1-thread crowd-few-4th:1-thread
# Here documents keep the indentation of what is put into them: tables stand at the margin.
writePage | sed 's/^[ \t]*//' > $build/performance.md
cp $build/performance.md docs/performance.md
echo "Written: docs/performance.md, docs/performance-triangles.svg, docs/performance-characters.svg, $csv"
