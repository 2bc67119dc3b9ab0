#!/bin/sh
# Critical speeds of all laws, with the picture of their limit cycles: critical_speeds.sh DYTSI PREFIX FOLDER. DYTSI: its
# source folder, PREFIX: where microslip is installed. Some minutes.
set -eu
dytsi=$(cd "$1" && pwd) prefix=$(cd "$2" && pwd) project=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$3"
folder=$(cd "$3" && pwd)
cmake -S "$project" -B "$folder/build" -DDYTSI="$dytsi" -DCMAKE_PREFIX_PATH="$prefix"
cmake --build "$folder/build" --parallel 2
cd "$dytsi/input"
speed() { "$folder/build/critical_speed" InputFiles/inputBifurcation-Cooperrider-straight.xml "$@"; }
speed exact
speed dytsi 0 "$folder/dytsi.csv"
for law in fastsim2 table; do speed $law 0 "$folder/$law.csv"; done
for law in shen_hedrick_elkins fastsim2 table; do speed $law 8.268e10 "$folder/$law-steel.csv"; done
cd "$folder"
exec /usr/bin/python3 "$project/plot.py" critical_speed.png dytsi.csv fastsim2.csv table.csv shen_hedrick_elkins-steel.csv \
  fastsim2-steel.csv table-steel.csv
