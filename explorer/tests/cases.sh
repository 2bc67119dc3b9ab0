#!/bin/sh
# Case files and links as states of the page, by the native core: cases.sh ANSWERS PROGRAM EXAMPLES SOURCES. Code 77,
# skipped, where node or its packages are missing.
answers=$1 program=$2 examples=$3 sources=$4
command -v node >/dev/null || { echo "skipped: node is missing"; exit 77; }
[ -e "$sources/node_modules" ] || { echo "skipped: $sources/node_modules is not there; tools/explorer installs it"; exit 77; }
MICROSLIP_ANSWERS=$answers MICROSLIP=$program EXAMPLES=$examples exec node "$sources/test.mjs" cases
