#!/usr/bin/env bash
# Builds the page that `sole report` fills into one file, build/report/template.html. Does nothing where that is newer
# than what it is made of.
# usage: scripts/build_report.sh
set -euo pipefail
cd "$(dirname "$0")/.."
PATH=$PWD/node_modules/.bin:$PATH

template=build/report/template.html
if [ -e $template ] && [ -z "$( find viewer/report viewer/src scripts/build_report.sh package-lock.json -newer $template -print -quit )" ]; then
	exit
fi
tsc -p viewer/report
vite build viewer/report --logLevel warn
