#!/bin/sh
# In an image of manylinux (AlmaLinux 9): what the wheel's program is compiled with, from the distribution and from EPEL.
# setup.py lets the wheel carry HDF5 and the others.
set -eu
dnf install -y epel-release
dnf config-manager --set-enabled crb
dnf install -y boost-devel cli11-devel fmt-devel hdf5-devel json-devel libcsv-devel tomlplusplus-devel ninja-build patchelf
