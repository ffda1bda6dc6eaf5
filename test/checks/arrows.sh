#!/usr/bin/env bash
# Which part of the tree may include which.
set -euo pipefail
cd "$(dirname "$0")/../.."

bad=0
stages='sense|probe|support|contact|foothold|target|pelvis|leg|ankle'

# includes FILE: the quoted includes of a file.
includes()
{
	sed -n 's/^[ \t]*#[ \t]*include[ \t]*"\([^"]*\)".*/\1/p' "$1"
}

complain()
{
	echo "$1 includes \"$2\": $3"
	bad=1
}

# Files below the folders given.
sources()
{
	local folder
	for folder in "$@"; do
		if [ -d "$folder" ]; then
			find "$folder" -name node_modules -prune -o -name '*.[ch]' -print
		fi
	done
}

# The public headers know each other and nothing else.
for file in $( sources include ); do
	for name in $( includes "$file" ); do
		[ -f "include/$name" ] || complain "$file" "$name" "public headers include public headers only"
	done
done

# Whoever uses the library uses its public headers.
for file in $( sources tool viewer bindings samples ); do
	for name in $( includes "$file" ); do
		folder=$( dirname "$file" )
		[ -f "include/$name" ] || [ -f "$folder/$name" ] || [ -f "scenarios/$name" ] || [ -f "tool/$name" ] ||
			[[ $name == baselines/* && -f $name ]] ||
			complain "$file" "$name" "only include/sole may be used from here"
	done
	case $file in
		samples/* | bindings/*)
			for name in $( includes "$file" ); do
				[ ! -f "tool/$name" ] || complain "$file" "$name" "samples and bindings do not use the program"
				[[ $name != baselines/* ]] || complain "$file" "$name" "samples and bindings do not use the baselines"
			done ;;
	esac
done

# What Sole is compared with is made of what everyone can use.
for file in $( sources baselines ); do
	for name in $( includes "$file" ); do
		[[ -f include/$name || ( $name == baselines/* && -f $name ) ]] ||
			complain "$file" "$name" "baselines use include/sole and each other's shared part"
	done
done

# The folders of src: what each may use beside itself and the public headers.
declare -A uses=( [base]='' [rig]='base' [ground]='base' [place]='base|rig' [measure]='base|rig' [debug]='base|rig|place' [limb]='base' )
for folder in src/*/; do
	part=$( basename "$folder" )
	allowed="$part${uses[$part]:+|${uses[$part]}}"
	for file in $( sources "$folder" ); do
		for name in $( includes "$file" ); do
			[[ -f include/$name || -f $( dirname "$file" )/$name || $name =~ ^($allowed)/ ]] ||
				complain "$file" "$name" "src/$part may use: $allowed"
		done
	done
done

# The stages of a frame do not call each other: place.c calls them in turn.
for file in $( sources src/place ); do
	stage=$( basename "${file%.*}" )
	[[ $stage =~ ^($stages)$ ]] || continue
	for name in $( includes "$file" ); do
		if [[ $name =~ ^(place/)?($stages)\.h$ && ${BASH_REMATCH[2]} != "$stage" ]]; then
			complain "$file" "$name" "stages do not know each other"
		fi
	done
done
exit $bad
