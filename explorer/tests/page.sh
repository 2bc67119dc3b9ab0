#!/bin/sh
# The page in a real browser: page.sh PROGRAM PAGE PROFILES SOURCES. Code 77, skipped, where one of them is missing.
program=$1 page=$2 profiles=$3 sources=$4
export CHROMIUM=${CHROMIUM:-/usr/bin/chromium}
for needed in "$page/index.html" "$CHROMIUM" "$sources/node_modules"; do
  [ -e "$needed" ] || { echo "skipped: $needed is not there; tools/explorer builds the page"; exit 77; }
done
MICROSLIP=$program MICROSLIP_PAGE=$page PROFILES=$profiles exec node "$sources/test.mjs" page
