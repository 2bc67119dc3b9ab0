#!/usr/bin/env bash
# Builds and installs microslip into a conda environment: PREFIX, PYTHON, SP_DIR and CPU_COUNT are conda's, the sources
# are in the folder where it runs, those of libcsv in libcsv.
set -euo pipefail
libraries=$PWD/libcsv/installed
mkdir -p "$libraries"/{lib,include}
"${CC:-cc}" ${CFLAGS:-} -O2 -fPIC -c libcsv/libcsv.c -o libcsv/libcsv.o
"${AR:-ar}" rcs "$libraries/lib/libcsv.a" libcsv/libcsv.o
cp libcsv/csv.h "$libraries/include/"

cmake -S . -B build/conda -G Ninja ${CMAKE_ARGS:-} -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_INSTALL_PREFIX="$PREFIX" -DCMAKE_INSTALL_LIBDIR=lib "-DCMAKE_PREFIX_PATH=$PREFIX;$libraries" \
  -DPython3_EXECUTABLE="$PYTHON" -DMICROSLIP_PYTHON_FOLDER="${SP_DIR#"$PREFIX/"}" \
  -DMICROSLIP_BUILD_PYTHON=ON -DMICROSLIP_BUILD_LIBCONTACT=OFF -DMICROSLIP_BUILD_TESTS=OFF -DMICROSLIP_BUILD_BENCH=OFF \
  -DMICROSLIP_MPI=OFF
cmake --build build/conda --parallel "${CPU_COUNT:-2}"
cmake --install build/conda --strip
