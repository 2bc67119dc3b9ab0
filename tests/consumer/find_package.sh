#!/bin/sh
# Configures, builds and runs a project that finds an installed microslip: find_package.sh PREFIX PROJECT FOLDER
# PROGRAM [option of cmake...]
set -eu
prefix=$1 project=$2 folder=$3 program=$4
shift 4
rm -rf "$folder"
cmake -S "$project" -B "$folder" -DCMAKE_PREFIX_PATH="$prefix" "$@" >"$folder.log" || { cat "$folder.log"; exit 1; }
cmake --build "$folder" --parallel 2 >"$folder.log" || { cat "$folder.log"; exit 1; }
"$folder/$program"
