#!/usr/bin/env bash
# The documents do not rot: every C example marked complete (```c complete) stands, line by line, in a sample that is
# compiled and run; every link to a file of the tree leads somewhere.
set -euo pipefail
cd "$(dirname "$0")/../.."

work=$( mktemp -d )
trap 'rm -rf "$work"' EXIT
status=0

# Indentation aside: an example stands at the margin, its sample inside a function.
flat()
{
	sed -e 's/^[ \t]*//' -e 's/[ \t]*$//' -e '/^$/d' "$@"
}

mkdir "$work/samples" "$work/blocks"
for sample in samples/*.c; do
	flat "$sample" | tr '\n' '\001' > "$work/samples/$( basename "$sample" )"
done

count=0
for document in README.md docs/*.md; do
	awk -v stem="$work/blocks/$( basename "$document" )" '
		/^```c complete$/ { inside = 1; name = stem "." ++n; next }
		/^```$/ { inside = 0 }
		inside { print > name }' "$document"
done
for block in "$work"/blocks/*; do
	[ -f "$block" ] || continue
	count=$(( count + 1 ))
	text=$( flat "$block" | tr '\n' '\001' )
	if ! grep -qaF -- "$text" "$work"/samples/*; then
		echo "the example $( basename "$block" ) stands in no sample"
		status=1
	fi
done
echo "$count examples"
[ $count -gt 0 ] || status=1

links=0
for document in README.md docs/*.md; do
	while read -r link; do
		links=$(( links + 1 ))
		if [ ! -e "$( dirname "$document" )/$link" ]; then
			echo "$document links to $link, which is not there"
			status=1
		fi
	done < <( grep -o ']([^)#]*' "$document" | sed 's/^](//' | grep -v '^[a-z]*:' | grep -v '^$' || true )
done
echo "$links links"
exit $status
