#!/bin/sh
# The binary exports the functions of the standard and no other name: exported_names.sh NM BINARY HEADER
set -eu
"$1" --dynamic --defined-only "$2" | awk '{print $3}' | sed 's/@.*//' | sort >fmu_exported_names.txt
sed -n 's/^FMI2_API .*[ *]\(fmi2[A-Za-z]*\)(.*/\1/p' "$3" | sort >fmi_declared_names.txt
[ "$(wc -l <fmi_declared_names.txt)" -eq 34 ]
diff fmi_declared_names.txt fmu_exported_names.txt
