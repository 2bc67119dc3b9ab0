#!/bin/sh
# Builds and runs programs with what pkg-config says of an installed microslip:
# pkg_config.sh PREFIX SOURCE-FOLDER FOLDER "CXX [flags]" "CC [flags]" [FC]
set -eu
prefix=$1 source=$2 folder=$3 cxx=$4 cc=$5 fc=${6-}
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name microslip.pc)")
LD_LIBRARY_PATH=$(pkg-config --variable=libdir "$PKG_CONFIG_PATH/microslip_c.pc")
export PKG_CONFIG_PATH LD_LIBRARY_PATH
# Compilers and what pkg-config prints are several words each.
$cxx -std=c++20 "$source/tests/consumer/consumer.cpp" $(pkg-config --cflags --libs microslip microslip_c) -o consumer
./consumer
$cc -std=c99 "$source/examples/c/first_contact.c" $(pkg-config --cflags --libs microslip_c) -lm -o first_contact
./first_contact
[ -n "$fc" ] || exit 0
"$fc" "$(pkg-config --variable=fortrandir microslip_c)/microslip.f90" "$source/examples/fortran/first_contact.f90" \
  $(pkg-config --libs microslip_c) -o fortran_first_contact
./fortran_first_contact
