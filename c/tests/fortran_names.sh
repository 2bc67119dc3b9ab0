#!/bin/sh
# The Fortran module has every function of the header: fortran_names.sh HEADER MODULE
set -eu
for name in $(sed -n 's/^MICROSLIP_API .*[ *]\(microslip_[a-z0-9_]*\)(.*/\1/p' "$1"); do
  grep -q "\(function\|subroutine\) $name\b\|name='$name'" "$2" || { echo "$2 has no $name"; missing=1; }
done
[ -z "${missing:-}" ]
