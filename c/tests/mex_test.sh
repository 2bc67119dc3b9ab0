#!/bin/sh
# Compiles the MEX file for Octave and tries it; 77: skipped, since Octave is not there.
# mex_test.sh SOURCES LIBRARY_FOLDER FOLDER
set -eu
for program in mkoctfile octave-cli; do
  command -v $program >/dev/null || { echo "skipped: $program is not installed"; exit 77; }
done
mkdir -p "$3"
cd "$3"
mkoctfile --mex -Wall -Wextra -Werror -I"$1/c/include" -L"$2" -Wl,-rpath,"$2" "$1/c/mex/microslip.c" -lmicroslip_c -o microslip.mex
exec octave-cli --no-gui --no-init-file "$1/c/tests/mex_test.m" "$3" "$1"
