#!/bin/sh
# Builds DYTSI's bogies with our laws and compares linear critical speeds: bogies_test.sh PREFIX DYTSI FOLDER [option of
# cmake...]. Exit code 77 where DYTSI or what it needs is not there.
set -eu
prefix=$1 dytsi=$2 folder=$3
shift 3
project=$(cd "$(dirname "$0")/.." && pwd)
[ -f "$dytsi/src/GeneralModel/WheelSetComponent.cpp" ] || { echo "skipped: no sources of DYTSI in $dytsi"; exit 77; }
pkg-config --exists gsl xerces-c || { echo "skipped: libgsl-dev or libxerces-c-dev is not installed"; exit 77; }
mkdir -p "$folder"
cmake -S "$project" -B "$folder" -DDYTSI="$dytsi" -DCMAKE_PREFIX_PATH="$prefix" "$@" >"$folder/log" || { cat "$folder/log"; exit 1; }
cmake --build "$folder" --parallel 2 >"$folder/log" || { cat "$folder/log"; exit 1; }

# speed LAW [SHEAR_MODULUS]: linear critical speed
speed() { (cd "$dytsi/input" && "$folder/critical_speed" InputFiles/inputBifurcation-Cooperrider-straight.xml "$@") | tee -a "$folder/said" | sed 's/.*speed \([0-9.]*\) .*/\1/'; }
: >"$folder/said"
dytsi_law=$(speed dytsi) ours=$(speed shen_hedrick_elkins) fastsim2=$(speed fastsim2) table=$(speed table)
steel=$(speed shen_hedrick_elkins 8.268e10)
cat "$folder/said"
# The same law through the call is the same to the last digit; the simplified theory follows the exact one more closely
# than Shen, Hedrick and Elkins do; softer contacts raise the speed.
[ "$dytsi_law" = "$ours" ]
awk "BEGIN { exit !($table > $ours && ($fastsim2 - $table) ^ 2 < ($ours - $table) ^ 2 && $steel > $ours) }"
