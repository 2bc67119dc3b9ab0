#!/bin/sh
# The library exports the functions that the header declares, each with and without an underscore behind it, and no
# other name; Fortran's module has the same: exported_names.sh NM LIBRARY HEADER MODULE
set -eu
"$1" --dynamic --defined-only "$2" | awk '{print $3}' | sed 's/@.*//' | sort >libcontact_exported.txt
sed -n 's/^int \([a-z0-9_]*\)(.*/\1/p' "$3" | sort >libcontact_declared.txt
[ "$(wc -l <libcontact_declared.txt)" -ge 69 ]
sed 'p;s/$/_/' libcontact_declared.txt | sort | diff - libcontact_exported.txt
sed -n 's/^ *subroutine \([a-z0-9_]*\)(.*/\1/p' "$4" | sort | diff libcontact_declared.txt -
