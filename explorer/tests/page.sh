#!/bin/sh
# The page in a real browser: page.sh TESTS PROGRAM PAGE PROFILES SOURCES, TESTS use or answers. Code 77, skipped, where one of them is missing.
tests=$1 program=$2 page=$3 profiles=$4 sources=$5
export CHROMIUM=${CHROMIUM:-/usr/bin/chromium}
for needed in "$page/index.html" "$CHROMIUM" "$sources/node_modules"; do
  [ -e "$needed" ] || { echo "skipped: $needed is not there; tools/explorer builds the page"; exit 77; }
done
MICROSLIP=$program MICROSLIP_PAGE=$page PROFILES=$profiles exec node "$sources/test.mjs" "$tests"
