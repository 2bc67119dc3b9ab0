#!/bin/sh
# The page in real browsers: page.sh TESTS PROGRAM PAGE PROFILES SOURCES, TESTS use, answers, firefox or screens. Code 77,
# skipped, where one of them is missing.
tests=$1 program=$2 page=$3 profiles=$4 sources=$5
export CHROMIUM=${CHROMIUM:-/usr/bin/chromium} FIREFOX=${FIREFOX:-/usr/bin/firefox-esr}
browsers=$CHROMIUM
[ "$tests" != firefox ] || browsers="$CHROMIUM $FIREFOX"
for needed in "$page/index.html" $browsers "$sources/node_modules"; do
  [ -e "$needed" ] || { echo "skipped: $needed is not there; tools/explorer builds the page"; exit 77; }
done
MICROSLIP=$program MICROSLIP_PAGE=$page PROFILES=$profiles SCREENS=$sources/tests/screens exec node "$sources/test.mjs" "$tests"
